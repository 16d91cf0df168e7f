// The C interface to emitted headers: one function per model function and scalar, with flat arrays.
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

/// The model, scene and program that drivers are made from.
struct DriverInput {
  const Model& model;
  const Scene& scene;
  const Program& program;
};

/// A translation unit.
struct Source {
  std::string file = {};
  std::string text = {};
  std::string needs = {};  ///< "Eigen/Core": a header that is no part of the language
};

/// The part of a translation unit that includes one emitted header, in the header's language, and
/// wraps each function for each scalar. `parameters` are those of Program::leaves; results follow
/// each other in the order of Function::fields, matrices row by row.
struct Driver {
  std::string types = {};  ///< "Eigen", "batch", "wide"; empty for those of the language itself
  std::string name = {};   ///< "eigen": a part of its symbols
  std::string text = {};
  std::string needs = {};     ///< of the Source, which leaves the text out where it is not there
  bool in_packs = false;      ///< sines and cosines are polynomials, see Sines
  bool is_wide = false;       ///< computes in Numerics::inner
  bool has_functions = true;  ///< else it has nothing but these
};

/// One for every header among the emitted files that is compiled in this build.
[[nodiscard]] std::vector<Driver> drivers(const DriverInput& input, Build build);

/// Drivers that are compiled together.
struct DriverUnit {
  Source source = {};
  Build build = Build::as_written;
  std::vector<Driver> drivers = {};
};

/// Drivers of a build: all in one unit, or one unit each where the program is long, because the
/// compiler's memory grows with it. `more` ends the first unit.
[[nodiscard]] std::vector<DriverUnit> units_of(const DriverInput& input, Build build,
                                               const std::string& more);

/// The scalars a driver wraps functions for: of generic code double, and float where its numbers
/// fit that, else the scene's own.
[[nodiscard]] std::vector<ScalarKind> driver_scalars(const DriverInput& input);

/// Scalars of this driver: a header on arrays of states, or in a wider scalar, has the scene's.
[[nodiscard]] std::vector<ScalarKind> scalars_of(const Driver& driver, const DriverInput& input);

/// Whether the driver has the function: in packs or a wider scalar none has more than 4096 entries.
[[nodiscard]] bool is_wrapped(const Driver& driver, const Function& function);

/// The name that the driver of this name has for Program::functions[function], or where that is
/// the number of functions, for sine_and_cosine: "elgen_driver_eigen_double_3".
[[nodiscard]] std::string driver_symbol(std::string_view driver, std::string_view scalar,
                                        std::size_t function);

/// The text that declared numbers are given by, and what they have to be.
struct Declarations {
  std::string text = {};
  std::vector<DeclaredNumber> numbers = {};
};
[[nodiscard]] Declarations declarations(const DriverInput& input);

/// The numbers of an array at the head of the code, or its bounds: "input_limits[0].low".
[[nodiscard]] std::vector<DeclaredNumber> numbers_of(const DeclaredArray& array);

/// In the text of declarations: void (*)(double* to), which writes all of them.
inline constexpr const char* declarations_symbol = "elgen_declared_numbers";

// The parts that the drivers of all languages are put together from.

/// "  result.l[1] = values[3];" for every run-time parameter, in the order of the program's leaves.
[[nodiscard]] std::string parameter_assignments(const DriverInput& input);

/// Where the header has entry (i, j) of a result: the driver gives them row by row.
[[nodiscard]] std::string_view stored_position(const Scene& scene);

/// "  append(to, result.gravity.data(), 2, 1);" for each field; `data` gives the address of one.
[[nodiscard]] std::string appended(const DriverInput& input, const Function& function,
                                   std::string_view to, std::string_view data);

/// "const double* parameters, const double* q, …, double t, ": what a driver function declares
/// before its result, each after `attribute`.
[[nodiscard]] std::string declared_leaves(std::string_view scalar, std::string_view attribute = "");

/// `append` and `parameters_from`, which the drivers in C++17 have in common.
[[nodiscard]] std::string cpp_helpers(const DriverInput& input);

/// The drivers of C++17, in Eigen's types, on arrays of states and in a wider scalar too, and of
/// C99; of packs also that of their sines and cosines alone.
[[nodiscard]] std::string cpp_driver(const DriverInput& input);
[[nodiscard]] std::string eigen_driver(const DriverInput& input);
[[nodiscard]] std::string batch_driver(const DriverInput& input);
[[nodiscard]] std::string wide_driver(const DriverInput& input);
[[nodiscard]] std::string sine_driver(const DriverInput& input);
[[nodiscard]] std::string c99_driver(const DriverInput& input);

// The drivers that time: an emitted function on arrays of states, one by one or in packs, and an
// emitted step in loops.

/// Number k of state i stands at [k * count + i] of every array.
template <class Scalar>
using TimingDriverFunction = void (*)(std::size_t count,
#define ELGEN_LEAVES(kind, member, ...) const Scalar *member,
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
                                      Scalar* result);

/// Times the first function of the program for a scene in C++, with its header of batches if a
/// variant is in packs.
[[nodiscard]] Source timing_driver(const DriverInput& input,
                                   const std::vector<TimedVariant>& variants);

/// "elgen_timed_3" of variants[3].
[[nodiscard]] std::string timed_symbol(std::size_t variant);

/// For a scene in C++ with its header of batches: a StepLoop of one state and one in packs, under
/// these names. The first function of the program is a `step`.
[[nodiscard]] Source step_driver(const DriverInput& input);
inline constexpr const char* step_loop_of_one = "elgen_step_loop";
inline constexpr const char* step_loop_in_packs = "elgen_step_loop_in_packs";

}  // namespace elgen
