// Toolchain: compiles every emitted header with the user's compiler and loads its functions, to be
// called or timed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/emitted_files.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/limits.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The signature of every compiled function: all leaves, then the result. Arguments a function does
/// not take are ignored.
template <class Scalar>
using DriverFunction = void (*)(
#define ELGEN_LEAVES(kind, member, ...) const Scalar *member,
#define ELGEN_LEAF(kind, member, ...) Scalar member,
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
    Scalar* result);

/// Where a compiled function finds its arguments: the first number of each list, and single
/// numbers.
template <class Scalar>
using ArgumentPointers = PerLeaf<const Scalar*, Scalar>;

template <class Scalar>
[[nodiscard]] ArgumentPointers<Scalar> argument_pointers(const LeafValues<Scalar>& arguments) {
  ArgumentPointers<Scalar> result;
#define ELGEN_LEAVES(kind, member, ...) result.member = arguments.member.data();
#define ELGEN_LEAF(kind, member, ...) result.member = arguments.member;
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
  return result;
}

/// Calls a compiled function, which writes the entries of all fields to `result`.
template <class Scalar>
void call_code(DriverFunction<Scalar> function, const ArgumentPointers<Scalar>& arguments,
               Scalar* result) {
  function(
#define ELGEN_LEAVES(kind, member, ...) arguments.member,
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
      result);
}

/// values[function][state]: all entries of all fields. Empty where the function raised an
/// exception: interpreters raise one in the place of infinities and NaNs.
template <class Scalar>
using ValuesOfFunctions = std::vector<std::vector<std::vector<Scalar>>>;

/// The functions of one emitted header, instantiated for one built-in scalar.
class CompiledModel {
 public:
  virtual ~CompiledModel() = default;
  /// The function itself, while the CompiledModel lives; null where it is not there for double. Its
  /// result has the entries of all fields, in the order of Function::fields.
  [[nodiscard]] virtual DriverFunction<double> find(std::string_view function) const = 0;
  /// All entries of all fields of an output, in the order of Function::fields.
  [[nodiscard]] virtual std::vector<double> call(std::string_view function,
                                                 const Arguments<double>& arguments) const = 0;
  [[nodiscard]] virtual std::vector<float> call(std::string_view function,
                                                const Arguments<float>& arguments) const = 0;
  /// Each of these functions at each of these states. E709 where what runs them ends before.
  [[nodiscard]] virtual Result<ValuesOfFunctions<double>> call_all(
      const std::vector<std::string_view>& functions,
      const std::vector<Arguments<double>>& states) const;
  [[nodiscard]] virtual Result<ValuesOfFunctions<float>> call_all(
      const std::vector<std::string_view>& functions,
      const std::vector<Arguments<float>>& states) const;
  /// Whether the code is there for double, for float.
  [[nodiscard]] virtual bool has(ScalarKind scalar) const = 0;
};

/// How headers are compiled.
enum class Build : std::uint8_t {
  as_written,  ///< strict flags, no contraction: the bits of the arithmetic that is written
  native,      ///< -O3 -march=native, no contraction: the same bits
  as_users,  ///< -O3 -march=native, contraction on: of Eigen nothing, of batches sines and cosines
  to_time,   ///< -O2 -march=native, contraction on
};

/// A number that a header declares beside its functions.
struct DeclaredNumber {
  std::string name = {};  ///< "l[1] (double)", "the place of l[1] (double)", "input_limits[0].low"
  double declared = 0;    ///< as compiled
  double of_model = 0;    ///< rounded to the scalar
};

/// The function by which a header in packs gives the sine and the cosine of the angle t.
inline constexpr std::string_view sine_and_cosine = "sine and cosine";

/// One emitted header; on vectors of Eigen, on arrays of states and in a wider scalar there are
/// others beside it.
struct CompiledHeader {
  std::string types = {};  ///< "Eigen", "batch", "wide"; empty for those of the language itself
  bool in_packs = false;   ///< sines and cosines are polynomials; called for one state of several
  std::unique_ptr<CompiledModel> functions = {};
  Build build = Build::as_written;
  std::string lacking = {};                   ///< why there are no functions; else empty
  std::vector<DeclaredNumber> declared = {};  ///< by all headers; with the first one
  bool is_wide = false;  ///< computes in Numerics::inner: its bits are not those of the program
  /// Functions that the interpreter of a module computes by code of its own, between spaces; and
  /// the error of its others, in u of the largest entry of a field. 0: the bits of the program.
  std::string_view own_implementations = {};
  int roundings = 0;
};
using CompiledHeaders = std::vector<CompiledHeader>;

struct CompileOptions {
  Limits limits = {};
  std::vector<Build> builds = {Build::as_written};
  /// Counts of coordinates, rates, inputs, open values and parameters; the values of the
  /// parameters, and where they stand in their struct; in C++ ranges and limits too, and of batches
  /// the numbers of their sines and cosines.
  bool declarations = false;
};

/// All headers, in each build in turn, the first of them in the language's own types; one run of
/// the compiler for each build, or for each header where the program is long. $CXX where it is set,
/// else c++, g++, clang++, whichever is there. Headers of a build whose flags the compiler does not
/// take, and those on Eigen where it is not installed, lack their functions. E704 without a
/// compiler, E706 without room for its files, E909 where it takes longer than `limits.seconds` by
/// the clock; with the compiler's words, E705 where it refuses what was emitted, E709 where it
/// cannot work.
[[nodiscard]] Result<CompiledHeaders> compile(const EmittedFiles& files, const Model& model,
                                              const Scene& scene, const Program& program,
                                              const CompileOptions& options);

/// The compiler, library and processor that compiled functions are made and timed by.
struct Machine {
  std::string compiler = {};   ///< "g++ (Debian 12.2.0-14) 12.2.0"
  std::string processor = {};  ///< "AMD EPYC 7B13"
  std::string c_library = {};  ///< "glibc 2.36"
};

/// This one. E704 and E909 as of compile.
[[nodiscard]] Result<Machine> this_machine(const Limits& limits);

/// To be timed: an emitted function on arrays of states, or an emitted step in a loop, compiled as
/// users compile. How a function goes through the states.
struct TimedVariant {
  ScalarKind scalar = ScalarKind::double_precision;  ///< or float
  bool in_packs = false;      ///< several states at once, by the header of batches; else one by one
  bool one_per_call = false;  ///< of packs: a call for each state, in one place of a pack
};

/// An emitted function together with arrays of states, number k of state i at [k * count + i];
/// numbers are rounded to its scalar.
class TimedFunction {
 public:
  virtual ~TimedFunction() = default;
  /// Computes all states once.
  virtual void run() = 0;
  /// The entries of all fields at other states, entry k of state i at [k * states.size() + i];
  /// there is at least one state.
  [[nodiscard]] virtual std::vector<double> at(
      const std::vector<Arguments<double>>& states) const = 0;
};

/// One for each variant.
using TimedFunctions = std::vector<std::unique_ptr<TimedFunction>>;

struct TimingOptions {
  std::vector<TimedVariant> variants = {};
  std::vector<Arguments<double>> states = {};
  Limits limits = {};
};

/// The first function of the program, by each variant, in one library; parameters have their values
/// in the model and are arguments. Errors as of `compile`. Cost: 1 s of the compiler, more for long
/// programs.
[[nodiscard]] Result<TimedFunctions> compile_timed(const EmittedFiles& files, const Model& model,
                                                   const Scene& scene, const Program& program,
                                                   const TimingOptions& options);

/// Goes `steps` steps of length h from time t on, with inputs that stay. The q and v of `count`
/// states side by side: number k of state i at [k * count + i], as of inputs. `spare` is
/// overwritten; it and `state` are as long as the results of the step for all states.
using StepLoop = void (*)(std::size_t count, std::size_t steps, double t, double h,
                          const double* inputs, double* state, double* spare);

/// An emitted `step` in loops.
struct StepLoops {
  std::shared_ptr<const void> code = {};  ///< lives as long as the loops are called
  StepLoop one = nullptr;                 ///< of one state, whatever the count is
  StepLoop in_packs = nullptr;
  std::size_t entries = 0;  ///< of the result of the step
};

/// Loops over the `step` of a program, in double with a batch, and `projected` behind each step
/// where it is there. Parameters have their values in the model and are arguments. Errors and cost
/// as of compile_timed.
[[nodiscard]] Result<StepLoops> compile_steps(const EmittedFiles& files, const Model& model,
                                              const Scene& scene, const Program& program,
                                              const Limits& limits);

}  // namespace elgen
