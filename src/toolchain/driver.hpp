// driver: the C interface to emitted headers: one function per model function and scalar, with flat
// arrays.
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
struct Source {
  std::string file = {};
  std::string text = {};
  std::string needs = {};  ///< "Eigen/Core": a header outside the standard library
};

/// The part of a translation unit that includes one emitted header, in the header's language, and
/// wraps each function for each scalar. `parameters` are in the order of Program::leaves. Results
/// are in the order of Function::fields, matrices row by row.
struct Driver {
  std::string types = {};  ///< "Eigen", "batch", "wide"; "" for the types of the language itself
  std::string name = {};   ///< "eigen": a part of its symbols
  std::string text = {};
  std::string needs = {};     ///< see Source; the text is omitted if this header is not installed
  bool in_packs = false;      ///< sines and cosines are polynomials, see Sines
  bool is_wide = false;       ///< computes in Numerics::inner
  bool has_functions = true;  ///< false: wraps only sine and cosine in packs
};

/// One driver for each emitted header that this build compiles.
[[nodiscard]] std::vector<Driver> drivers(const DriverInput& input, Build build);

/// Drivers that are compiled together.
struct DriverUnit {
  Source source = {};
  Build build = Build::as_written;
  std::vector<Driver> drivers = {};
};

/// Drivers of a build: in a single unit, or in one unit each if the program is long, because the
/// compiler's memory grows with a unit. `more` is appended to the first unit.
[[nodiscard]] std::vector<DriverUnit> units_of(const DriverInput& input, Build build,
                                               const std::string& more);

/// The scalars for which a driver wraps functions. Generic code has double, and float if all its
/// numbers fit float; other code has the scalars of the scene.
[[nodiscard]] std::vector<ScalarKind> driver_scalars(const DriverInput& input);

/// The scalars of this driver: a batch header or a header in a wider scalar has the scalars of the
/// scene.
[[nodiscard]] std::vector<ScalarKind> scalars_of(const Driver& driver, const DriverInput& input);

/// True if the driver wraps the function. In packs and in a wider scalar, functions of more than
/// 4096 entries are omitted.
[[nodiscard]] bool is_wrapped(const Driver& driver, const Function& function);

/// "elgen_driver_eigen_double_3": the symbol of Program::functions[function] in the driver of this
/// name. For the index after the last function it is the symbol of sine_and_cosine.
[[nodiscard]] std::string driver_symbol(std::string_view driver, std::string_view scalar,
                                        std::size_t function);

/// The text of a function that returns the declared numbers, and the values that they must have.
struct Declarations {
  std::string text = {};
  std::vector<DeclaredNumber> numbers = {};
};
[[nodiscard]] Declarations declarations(const DriverInput& input);

/// The numbers of a declared array, or its bounds: "input_limits[0].low".
[[nodiscard]] std::vector<DeclaredNumber> declared_numbers_of(const DeclaredArray& array);

/// void (*)(double* to), in the text of declarations: writes all declared numbers.
inline constexpr const char* declarations_symbol = "elgen_declared_numbers";

// Helpers of the drivers of all languages.

/// "  result.l[1] = values[3];" for every run-time parameter, in the order of the program's leaves.
[[nodiscard]] std::string parameter_assignments(const DriverInput& input);

/// The index of entry (i, j) in a result of the header. The driver returns matrices row by row.
[[nodiscard]] std::string_view stored_position(const Scene& scene);

/// "  append(to, result.gravity.data(), 2, 1);" for each field. `data` is the call that returns the
/// address of an array.
[[nodiscard]] std::string append_statements(const DriverInput& input, const Function& function,
                                            std::string_view to, std::string_view data);

/// "const double* parameters, const double* q, …, double t, ": the parameters of a driver function
/// before its result, each after `attribute`.
[[nodiscard]] std::string declared_leaves(std::string_view scalar, std::string_view attribute = "");

/// `append` and `parameters_from`, which the C++17 drivers share.
[[nodiscard]] std::string cpp_helpers(const DriverInput& input);

/// The drivers in C++17 and in C99. `sine_driver` has only the sines and cosines of packs.
[[nodiscard]] std::string cpp_driver(const DriverInput& input);
[[nodiscard]] std::string eigen_driver(const DriverInput& input);
[[nodiscard]] std::string batch_driver(const DriverInput& input);
[[nodiscard]] std::string wide_driver(const DriverInput& input);
[[nodiscard]] std::string sine_driver(const DriverInput& input);
[[nodiscard]] std::string c99_driver(const DriverInput& input);

// Drivers for timing: an emitted function on arrays of states, one state at a time or in packs; and
// an emitted step in loops.

/// Number k of state i is at [k * count + i] in every array.
template <class Scalar>
using TimingDriverFunction = void (*)(std::size_t count,
#define ELGEN_LEAVES(kind, member, ...) const Scalar *member,
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
                                      Scalar* result);

/// Times the first function of the program, for a scene in C++; with its batch header if a variant
/// is in packs.
[[nodiscard]] Source timing_driver(const DriverInput& input,
                                   const std::vector<TimedVariant>& variants);

/// "elgen_timed_3" for variants[3].
[[nodiscard]] std::string timed_symbol(std::size_t variant);

/// For a scene in C++ with a batch header: a StepLoop of one state and a StepLoop in packs, under
/// the names below. The program must contain a `step`.
[[nodiscard]] Source step_driver(const DriverInput& input);
inline constexpr const char* step_loop_of_one = "elgen_step_loop";
inline constexpr const char* step_loop_in_packs = "elgen_step_loop_in_packs";

}  // namespace elgen
