// Toolchain: compiles every emitted header with the user's compiler and loads its functions, to
// call or to time them.
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

/// The signature of every compiled function: all leaves, then the result. Leaves that the function
/// does not take are ignored.
template <class Scalar>
using DriverFunction = void (*)(
#define ELGEN_LEAVES(kind, member, ...) const Scalar *member,
#define ELGEN_LEAF(kind, member, ...) Scalar member,
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
    Scalar* result);

/// The arguments of a compiled function: a pointer to each list of leaves, and t, h and E as
/// numbers.
template <class Scalar>
using ArgumentPointers = LeafMembers<const Scalar*, Scalar>;

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
void call_compiled_function(DriverFunction<Scalar> function,
                            const ArgumentPointers<Scalar>& arguments, Scalar* result) {
  function(
#define ELGEN_LEAVES(kind, member, ...) arguments.member,
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
      result);
}

/// Element [function][state] has the entries of all fields, or is empty if the function raised an
/// exception. Interpreters raise exceptions instead of returning infinity or NaN.
template <class Scalar>
using FunctionResults = std::vector<std::vector<std::vector<Scalar>>>;

/// The functions of one emitted header, instantiated for one built-in scalar.
class CompiledModel {
 public:
  virtual ~CompiledModel() = default;
  /// A pointer to `function`, valid while *this lives; null if the code is not compiled for double.
  /// The function writes the entries of all fields, in the order of Function::fields.
  [[nodiscard]] virtual DriverFunction<double> find(std::string_view function) const = 0;
  /// Calls `function`. Returns the entries of all fields, in the order of Function::fields.
  [[nodiscard]] virtual std::vector<double> call(std::string_view function,
                                                 const Arguments<double>& arguments) const = 0;
  [[nodiscard]] virtual std::vector<float> call(std::string_view function,
                                                const Arguments<float>& arguments) const = 0;
  /// Calls each of `functions` at each of `states`. An interpreter runs all calls in one process.
  /// E709: the process of the interpreter ends early.
  [[nodiscard]] virtual Result<FunctionResults<double>> call_at_states(
      const std::vector<std::string_view>& functions,
      const std::vector<Arguments<double>>& states) const;
  [[nodiscard]] virtual Result<FunctionResults<float>> call_at_states(
      const std::vector<std::string_view>& functions,
      const std::vector<Arguments<float>>& states) const;
  /// True if the code is compiled for the scalar.
  [[nodiscard]] virtual bool has(ScalarKind scalar) const = 0;
};

/// Compiler flags for headers.
enum class BuildFlags : std::uint8_t {
  as_written,  ///< strict flags, no contraction: bit-identical to the written arithmetic
  native,      ///< -O3 -march=native, no contraction: also bit-identical
  user_flags,  ///< -O3 -march=native, contraction on; skips Eigen headers, and compiles only the
               ///< sine and cosine functions of batch headers
  timing,      ///< -O2 -march=native, contraction on
};

/// A number that a header declares in addition to its functions.
struct DeclaredNumber {
  std::string name = {};   ///< "l[1] (double)", "the place of l[1] (double)", "input_limits[0].low"
  double declared = 0;     ///< the number in the compiled header
  double model_value = 0;  ///< the number in the model, rounded to the scalar
};

/// The function name with which CompiledModel::call() returns {sin t, cos t} by the polynomials of
/// a batch header.
inline constexpr std::string_view sine_and_cosine = "sine and cosine";

/// One emitted header in one build: the header in the types of the language, or a further header
/// for Eigen types, arrays of states or a wider scalar.
struct CompiledHeader {
  std::string types = {};  ///< "Eigen", "batch", "wide", "wide, batch"; "" for the language's types
  /// True for a batch header: sines and cosines are polynomials, and a call computes one state of a
  /// pack.
  bool is_in_packs = false;
  std::unique_ptr<CompiledModel> functions = {};
  BuildFlags build = BuildFlags::as_written;
  std::string failure_reason = {};            ///< why `functions` is null; else empty
  std::vector<DeclaredNumber> declared = {};  ///< first header: numbers of all headers; else empty
  bool is_wide = false;  ///< true: computes in Numerics::inner; not bit-identical to the program
  /// As SourceSpelling::own_implementations and roundings: C names of functions that the
  /// interpreter implements itself, and the tolerance of outputs that call no such function, in u.
  std::string_view own_implementations = {};
  int roundings = 0;
};
using CompiledHeaders = std::vector<CompiledHeader>;

struct CompileOptions {
  Limits limits = {};
  std::vector<BuildFlags> builds = {BuildFlags::as_written};
  /// True: also return the numbers that headers declare (CompiledHeader::declared): the counts of
  /// coordinates, rates, inputs, open values and parameters, and the values and positions of
  /// parameters; in C++ also ranges and limits, and for batches the polynomial coefficients of
  /// sines and cosines.
  bool reads_declared_numbers = false;
};

/// Compiles all headers in each build. The result starts with the header in the types of the
/// language. The compiler is $CXX, else the first of c++, g++, clang++ that is installed. It runs
/// once per build, or once per header of a long program. CompiledHeader::functions is null if the
/// compiler rejects the flags of the build, or if Eigen is not installed. E704: no compiler. E705:
/// the compiler rejects the emitted code. E706: no space for files. E709: the compiler fails. E909:
/// the compiler exceeds limits.seconds of wall-clock time. E705 and E709 quote the compiler.
[[nodiscard]] Result<CompiledHeaders> compile(const EmittedFiles& files, const Model& model,
                                              const Scene& scene, const Program& program,
                                              const CompileOptions& options);

/// The compiler, processor and C library by which functions are compiled and timed.
struct Machine {
  std::string compiler = {};   ///< "g++ (Debian 12.2.0-14) 12.2.0"
  std::string processor = {};  ///< "AMD EPYC 7B13"
  std::string c_library = {};  ///< "glibc 2.36"
};

/// The machine on which this process runs. E704 and E909: as compile().
[[nodiscard]] Result<Machine> this_machine(const Limits& limits);

/// The way in which a timed function, compiled with BuildFlags::timing, processes its states.
struct TimedVariant {
  ScalarKind scalar = ScalarKind::double_precision;  ///< double or float
  bool in_packs = false;  ///< true: the batch header is called; false: one state per call
  bool is_one_per_call =
      false;  ///< with in_packs: one call per state, which fills one lane of a pack
};

/// An emitted function, and the states at which the function is timed. The states are rounded to
/// TimedVariant::scalar.
class TimedFunction {
 public:
  virtual ~TimedFunction() = default;
  /// Evaluates the function once at each state, with the parameters of the model.
  virtual void run() = 0;
  /// The entries of all fields at the given states: entry k of state i at [k * states.size() + i].
  /// If the scene varies parameters, each state has its own parameters, otherwise those of the
  /// model. `states` is not empty.
  [[nodiscard]] virtual std::vector<double> values_at(
      const std::vector<Arguments<double>>& states) const = 0;
};

/// One function for each of TimingOptions::variants, in the same order.
using TimedFunctions = std::vector<std::unique_ptr<TimedFunction>>;

struct TimingOptions {
  std::vector<TimedVariant> variants = {};
  std::vector<Arguments<double>> states = {};
  Limits limits = {};
};

/// Compiles the first function of the program in each variant, in one library. Parameters are
/// arguments, with their values in the model. Errors: as compile(). Cost: 1 s of the compiler, more
/// for long programs.
[[nodiscard]] Result<TimedFunctions> compile_timed_functions(const EmittedFiles& files,
                                                             const Model& model, const Scene& scene,
                                                             const Program& program,
                                                             const TimingOptions& options);

/// Advances `count` states by `steps` steps of length h from time t, with constant inputs. `state`
/// has q and v, with number k of state i at [k * count + i]; `inputs` has the same layout. `state`
/// and `spare`, which is overwritten, have room for StepLoops::entries numbers per state.
using StepLoop = void (*)(std::size_t count, std::size_t steps, double t, double h,
                          const double* inputs, double* state, double* spare);

/// Loops that call an emitted `step`.
struct StepLoops {
  std::shared_ptr<const void> code = {};  ///< the loaded library that contains the loops
  StepLoop one_state_loop = nullptr;      ///< loop over one state; ignores `count`
  StepLoop pack_loop = nullptr;           ///< loop over `count` states in packs
  std::size_t entries = 0;                ///< number of entries that a step returns for one state
};

/// Compiles loops over the `step` of a program, followed by `projected` if the program has it. The
/// scene must emit double and a batch header. Parameters are arguments, with their values in the
/// model. Errors and cost: as compile_timed_functions().
[[nodiscard]] Result<StepLoops> compile_step_loops(const EmittedFiles& files, const Model& model,
                                                   const Scene& scene, const Program& program,
                                                   const Limits& limits);

}  // namespace elgen
