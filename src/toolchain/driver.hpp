// driver: a C interface to emitted headers. It has one function per emitted function and scalar,
// with flat arrays as arguments.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "elgen/toolchain.hpp"
#include "emit/interface/code_interface.hpp"

namespace elgen {

/// The model, scene and program for which drivers are written.
struct DriverInput {
  const Model& model;
  const Scene& scene;
  const Program& program;
};

/// A translation unit.
struct SourceFile {
  std::string file = {};
  std::string text = {};
  /// A header outside the standard library: "Eigen/Core"; "" for none.
  std::string required_header = {};
};

/// The part of a translation unit that includes one emitted header, in the header's language, and
/// wraps each function for each scalar. Arguments named `parameters` are in the order of
/// Program::leaves. Results are in the order of Function::fields, matrices row by row.
struct Driver {
  std::string types = {};  ///< "Eigen", "batch", "wide"; "" for the language's own types
  std::string name = {};   ///< part of the symbols: "eigen"
  std::string text = {};
  std::string needs = {};  ///< header without which `text` is skipped: "Eigen/Core"; or ""
  /// Sines and cosines are polynomials (SineArithmetic::packs). Unless `is_wide`, the driver wraps
  /// them, too.
  bool uses_packs = false;
  bool is_wide = false;       ///< computes in the scalar Numerics::inner
  bool has_functions = true;  ///< false: wraps only the sine and cosine of packs
};

/// One driver for each emitted header that the build compiles, and one for steps in packs whose
/// accelerations are in float.
[[nodiscard]] std::vector<Driver> make_drivers(const DriverInput& input, BuildFlags build);

/// Drivers that are compiled as one translation unit.
struct DriverUnit {
  SourceFile source = {};
  BuildFlags build = BuildFlags::as_written;
  std::vector<Driver> drivers = {};
};

/// The drivers of a build in one unit. For long programs each driver with functions begins a new
/// unit, because the compiler's memory grows with the unit. `more` is appended to the text of the
/// first unit.
[[nodiscard]] std::vector<DriverUnit> make_driver_units(const DriverInput& input, BuildFlags build,
                                                        const std::string& more);

/// The scalars of generic code: double, and also float if all numbers of the code fit float. For
/// other code, the scalars of the scene.
[[nodiscard]] std::vector<ScalarKind> driver_scalars(const DriverInput& input);

/// The scalars for which this driver wraps functions: for a batch header or a header in a wider
/// scalar, the scalars of the scene; otherwise driver_scalars().
[[nodiscard]] std::vector<ScalarKind> scalars_of(const Driver& driver, const DriverInput& input);

/// True if the driver wraps the function. Drivers of packs and of a wider scalar omit functions
/// with more than 4096 entries.
[[nodiscard]] bool is_wrapped(const Driver& driver, const Function& function);

/// The symbol of the function that wraps Program::functions[function] in the driver of this name:
/// "elgen_driver_eigen_double_3". The index after the last function gives the symbol of
/// sine_and_cosine.
[[nodiscard]] std::string driver_symbol(std::string_view driver, std::string_view scalar,
                                        std::size_t function);

/// The text of a function that writes all declared numbers, and the required values of the numbers.
struct DeclarationReader {
  std::string text = {};
  std::vector<DeclaredNumber> numbers = {};
};
[[nodiscard]] DeclarationReader make_declaration_reader(const DriverInput& input);

/// The numbers or bounds in a declared array, with names such as "input_limits[0].low".
[[nodiscard]] std::vector<DeclaredNumber> declared_numbers_of(const DeclaredArray& array);

/// The symbol of the function in DeclarationReader::text, of type void (*)(double* to).
inline constexpr const char* declarations_symbol = "elgen_declared_numbers";

// Helpers for the drivers of all languages.

/// One line for each emitted parameter, in the order of the program's leaves: "  result.l[1] =
/// values[3];".
[[nodiscard]] std::string parameter_assignments(const DriverInput& input);

/// The index of entry (i, j) in a matrix that the header returns, as an expression. Drivers return
/// matrices row by row.
[[nodiscard]] std::string_view storage_index(const Scene& scene);

/// One line for each field: "  append(to, result.gravity.data(), 2, 1);". `data`: the call that
/// returns the address of an array, ".data()" or "".
[[nodiscard]] std::string append_statements(const DriverInput& input, const Function& function,
                                            std::string_view to, std::string_view data);

/// The parameters of a driver function before its result: "const double* parameters, const double*
/// q, …, double t, ". `attribute` precedes each parameter.
[[nodiscard]] std::string leaf_parameter_list(std::string_view scalar,
                                              std::string_view attribute = "");

/// The text of `append` and `parameters_from`, which all C++17 drivers contain.
[[nodiscard]] std::string cpp_helpers(const DriverInput& input);

/// The texts of the drivers. sine_driver() wraps only the sine and cosine of packs.
[[nodiscard]] std::string cpp_driver(const DriverInput& input);
[[nodiscard]] std::string eigen_driver(const DriverInput& input);
[[nodiscard]] std::string batch_driver(const DriverInput& input);
[[nodiscard]] std::string wide_driver(const DriverInput& input);
[[nodiscard]] std::string wide_batch_driver(const DriverInput& input);
[[nodiscard]] std::string sine_driver(const DriverInput& input);
[[nodiscard]] std::string c99_driver(const DriverInput& input);

// Drivers for timing: loops that call an emitted function for arrays of states, one state at a time
// or in packs; and loops that call an emitted step.

/// In every array, number k of state i has the index k * count + i. If the scene varies parameters,
/// `parameters` are those of the only state; null: the parameters of the model.
template <class Scalar>
using TimingDriverFunction = void (*)(std::size_t count,
#define ELGEN_LEAVES(kind, member, ...) const Scalar *member,
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
                                      Scalar* result);

/// A driver that times the program's first function, for a scene in C++. Includes the batch header
/// if a variant needs packs.
[[nodiscard]] SourceFile timing_driver(const DriverInput& input,
                                       const std::vector<TimedVariant>& variants);

/// The symbol of variants[variant]: "elgen_timed_3".
[[nodiscard]] std::string timed_symbol(std::size_t variant);

/// Two functions of type StepLoop, with the names below: one for a single state, one in packs. The
/// scene must be in C++ with a batch header; the program must contain a `step`.
[[nodiscard]] SourceFile step_driver(const DriverInput& input);
inline constexpr const char* single_step_loop_symbol = "elgen_step_loop";
inline constexpr const char* pack_step_loop_symbol = "elgen_step_loop_in_packs";

}  // namespace elgen
