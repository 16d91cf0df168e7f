// code_interface: the interface of emitted code: its namespace, its parameters, and the types of
// results.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The namespace of the emitted code, or the prefix of its names: `[emit] namespace` of the scene;
/// by default the scene's base name.
[[nodiscard]] const std::string& name_space(const Scene& scene);

/// "cart_pole" -> "CART_POLE": for names of macros.
[[nodiscard]] std::string upper_case(std::string_view name);

/// "forward_dynamics" -> "ForwardDynamics": the C++ result struct of a function.
[[nodiscard]] std::string camel_case(std::string_view name);

/// The parameters that the program reads. An array is included if the program reads an element. A
/// parameter is excluded if the scene fixes it or if no requested output depends on it.
[[nodiscard]] std::vector<ParameterArray> emitted_parameters(const Model& model,
                                                             const Program& program);

/// The number of scalars in emitted_parameters().
[[nodiscard]] std::size_t emitted_parameter_count(const Model& model, const Program& program);

/// "lambda_" for "lambda" in Python: appends an underscore to a reserved word of an interpreted
/// language.
[[nodiscard]] std::string name_in_language(LanguageId language, std::string_view name);

/// The member of the emitted parameters for a parameter leaf. `element`: the index in an array.
struct ParameterMember {
  std::string name = {};
  std::optional<std::uint32_t> element = {};
};
[[nodiscard]] std::vector<ParameterMember> parameter_leaf_members(const Model& model,
                                                                  const LeafNames& leaves);

/// "m", "l[2]": each member of parameter_leaf_members() in the notation of C.
[[nodiscard]] std::vector<std::string> parameter_member_texts(const Model& model,
                                                              const LeafNames& leaves);

/// Kinds of leaves that an emitted function takes as arguments, even if it does not read them.
///
///     inverse_dynamics, time occurs   ->   p, q, v, a, t
///
/// Parameters, q and the leaves of the output table, in the order of leaves.def; t if the model
/// uses time, and open values if the model has any.
[[nodiscard]] std::vector<Opcode> arguments_of(const Model& model, const Function& function);

/// The arguments of `function` in `language`. A program that reads no parameters omits the argument
/// p, unless the type of p selects the scalar in this language.
[[nodiscard]] std::vector<Opcode> arguments_of(const Model& model, const Function& function,
                                               const Program& program, LanguageId language);

/// True for arrays of numbers; false for the struct of parameters and for single numbers.
[[nodiscard]] constexpr bool is_vector(Opcode argument) {
  return argument != Opcode::parameter && !is_single(argument);
}

/// The values of an array's elements in the model.
[[nodiscard]] std::vector<cln::cl_R> element_values(const Model& model,
                                                    const ParameterArray& array);

/// A constant array at the head of the code; its elements are texts, numbers or intervals.
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

/// The constant arrays that the code declares. Names and units of velocities are declared only for
/// models with rotations; in other models velocity i is the rate of coordinate i.
[[nodiscard]] std::vector<DeclaredArray> declared_arrays(const Model& model,
                                                         const Program& program);

/// True if some function has a sine followed by the cosine of the same angle.
[[nodiscard]] bool has_sine_cosine_pair(const Program& program);

/// True if the function calls `min`, `max`, `sign` or `stumpff`, which need `<` on Scalar or on the
/// numbers of a pack.
[[nodiscard]] bool needs_ordered_scalar(const Function& function);

/// True if needs_ordered_scalar() is true for some function.
[[nodiscard]] bool compares_numbers(const Program& program);

/// Names of library functions of this arity that the program calls. sqrt is included. sin, cos and
/// functions that the emitted code defines itself are excluded.
[[nodiscard]] std::vector<std::string_view> library_calls(const Program& program,
                                                          std::size_t arity);

/// True if some function calls sin or cos.
[[nodiscard]] bool calls_sines(const Program& program);

/// True if the batch header has its own tables of sines; otherwise it uses the tables of the main
/// header.
[[nodiscard]] bool has_batch_sine_tables(const Scene& scene, const Program& program);

/// True if some function returns the pivots of M.
[[nodiscard]] bool returns_pivots(const Program& program);

/// True if the function returns a struct: it has several fields, or a field with a name.
[[nodiscard]] bool returns_struct(const Function& function);

/// The output kind of a field. `dynamics` has fields of other outputs; a field of any other
/// function has the kind of the function.
[[nodiscard]] OutputKind kind_of_field(const Program& program, const Function& function,
                                       const Field& field);

/// True if a field is a number by definition: an energy, or a user's output of one component. The
/// gravity of one coordinate is an array of one element.
[[nodiscard]] bool is_scalar(OutputKind kind, const Field& field);
[[nodiscard]] bool is_scalar(const Program& program, const Function& function, const Field& field);

/// True if a field is a matrix by definition, even with one column.
[[nodiscard]] bool is_matrix(OutputKind kind, const Field& field);

/// The number of relative pivots as a C++ expression.
[[nodiscard]] std::string_view pivot_count_text(const Model& model);

/// "Forces<Scalar>", "Scalar", "std::array<Scalar, 3>": the C++ type of a field.
[[nodiscard]] std::string field_type(const Model& model, OutputKind kind, const Field& field);

/// "Vector<Scalar, 3>", "Scalar": the type of a field in the Eigen header.
[[nodiscard]] std::string eigen_type(OutputKind kind, const Field& field);

/// The function with the entries of its matrices in storage order. The entries of a column-major
/// matrix are listed as the rows of its transpose:
///
///     2 x 3: a b c d e f   ->   3 x 2: a d b e c f
[[nodiscard]] Function to_storage_order(const Function& function, Storage storage);

/// Most entries of an output that is returned by value; a larger value could overflow the stack.
inline constexpr std::size_t max_returned_entries = 4096;
[[nodiscard]] bool is_returned_by_value(const Function& function);

}  // namespace elgen
