// code_interface: what callers see of emitted code: its name space, the parameters it takes, and
// what holds the results of a function.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The namespace of the emitted code, or the prefix of its names: what the scene asks for, or its
/// base name.
[[nodiscard]] const std::string& name_space(const Scene& scene);

/// "CART_POLE": of names that stand for the preprocessor.
[[nodiscard]] std::string capitals(std::string_view name);

/// "forward_dynamics" -> "ForwardDynamics": the struct that a function of several fields returns in
/// C++.
[[nodiscard]] std::string camel_case(std::string_view name);

/// The parameters that a function of the program reads, whole arrays of them: a parameter that the
/// scene has fixed, or whose terms are not asked for, is no argument.
[[nodiscard]] std::vector<ParameterArray> emitted_parameters(const Model& model,
                                                             const Program& program);

/// The scalars in them.
[[nodiscard]] std::size_t emitted_parameter_count(const Model& model, const Program& program);

/// "lambda_" for "lambda": a parameter, function or field in a language; others keep their names.
[[nodiscard]] std::string spelt_name(LanguageId language, std::string_view name);

/// The member of the emitted parameters that a parameter leaf is, and its place in an array.
struct ParameterMember {
  std::string name = {};
  std::optional<std::uint32_t> element = {};
};
[[nodiscard]] std::vector<ParameterMember> members_of(const Model& model, const LeafNames& leaves);

/// "m", "l[2]": the same as C writes it.
[[nodiscard]] std::vector<std::string> parameter_members(const Model& model,
                                                         const LeafNames& leaves);

/// The kinds of leaves that an emitted function takes, whether it reads them or not.
///
///     inverse_dynamics, time occurs   ->   p, q, v, a, t
///
/// Parameters, q and what the output table says, in the order of leaves.def; t where it occurs, and
/// open values where the model has some.
[[nodiscard]] std::vector<Opcode> arguments_of(const Model& model, const Function& function);

/// The same in a language: without parameters where the program reads none, but where they say the
/// scalar.
[[nodiscard]] std::vector<Opcode> arguments_of(const Model& model, const Function& function,
                                               const Program& program, LanguageId language);

/// Whether it is an array of numbers, not the struct of parameters or one number.
[[nodiscard]] constexpr bool is_vector(Opcode argument) {
  return argument != Opcode::parameter && !is_single(argument);
}

/// The values of the elements of an array in the model.
[[nodiscard]] std::vector<cln::cl_R> values_of(const Model& model, const ParameterArray& array);

/// One of the arrays at the head of the code: of texts, numbers or intervals.
struct DeclaredArray {
  enum class Kind : std::uint8_t { texts, numbers, intervals };

  std::string name;
  Kind kind = Kind::texts;
  std::vector<std::string> texts = {};
  std::vector<cln::cl_R> numbers = {};
  std::vector<std::optional<Interval>> intervals = {};

  [[nodiscard]] std::size_t size() const {
    return texts.size() + numbers.size() + intervals.size();
  }
};

/// Where nothing rotates, velocities are called as their coordinates.
[[nodiscard]] std::vector<DeclaredArray> declared_arrays(const Model& model,
                                                         const Program& program);

/// Whether the instruction is the sine of an angle whose cosine comes next: one call computes both,
/// where the language has it.
[[nodiscard]] bool is_sine_with_cosine(const Function& function, std::size_t at);

/// Whether some function has such a pair.
[[nodiscard]] bool has_sine_with_cosine(const Program& program);

/// Whether the function calls one of what the code has of its own, which compares numbers.
[[nodiscard]] bool needs_order(const Function& function);

/// The functions of so many arguments that a Program calls, square roots among them; sines and
/// cosines aside, and what the code has of its own.
[[nodiscard]] std::vector<std::string_view> library_calls(const Program& program,
                                                          std::size_t arity);

/// Whether some function calls a sine or a cosine.
[[nodiscard]] bool calls_sines(const Program& program);

/// Whether the header of packs has tables of sines; else it uses those of the other header.
[[nodiscard]] bool has_tables_of_packs(const Scene& scene, const Program& program);

/// Whether some function gives the pivots of M.
[[nodiscard]] bool gives_pivots(const Program& program);

/// True for functions that give a struct: all but those with one field without a name.
[[nodiscard]] bool gives_struct(const Function& function);

/// The row of the output table a field of `dynamics` is from; the function's own row otherwise.
[[nodiscard]] OutputKind kind_of_field(const Program& program, const Function& function,
                                       const Field& field);

/// Whether a field is one number by its nature: an energy, or a user's value of one component. The
/// gravity of one coordinate is an array of one.
[[nodiscard]] bool is_scalar(OutputKind kind, const Field& field);
[[nodiscard]] bool is_scalar(const Program& program, const Function& function, const Field& field);

/// Whether a field is a matrix by its nature, also with one column.
[[nodiscard]] bool is_matrix(OutputKind kind, const Field& field);

/// How many relative pivots there are, as C++ says it.
[[nodiscard]] std::string_view pivot_count(const Model& model);

/// "Forces<Scalar>", "Scalar", "std::array<Scalar, 3>": what holds it in C++.
[[nodiscard]] std::string field_type(const Model& model, OutputKind kind, const Field& field);

/// "Vector<Scalar, 3>", "Scalar": what holds it with Eigen.
[[nodiscard]] std::string eigen_type(OutputKind kind, const Field& field);

/// The function with the entries of its matrices in the order of storage; a column-major matrix
/// becomes its transpose, row by row:
///
///     2 x 3: a b c d e f   ->   3 x 2: a d b e c f
[[nodiscard]] Function stored(const Function& function, Storage storage);

/// Outputs beyond so many entries are not returned: they would not fit a stack.
inline constexpr std::size_t largest_returned = 4096;
[[nodiscard]] bool is_returned(const Function& function);

}  // namespace elgen
