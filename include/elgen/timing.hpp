// Timing: an emitted function on arrays of states, or an emitted step in a loop, compiled as users
// compile, to be timed.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "elgen/toolchain.hpp"

namespace elgen {

/// How a function goes through the states.
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

/// Of each variant.
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

/// Of the first function of a program, a `step`, in double, whose scene has a batch; parameters
/// have their values in the model and are arguments. Errors and cost as of compile_timed.
[[nodiscard]] Result<StepLoops> compile_steps(const EmittedFiles& files, const Model& model,
                                              const Scene& scene, const Program& program,
                                              const Limits& limits);

}  // namespace elgen
