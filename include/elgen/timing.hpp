// Timing: an emitted function on arrays of states, compiled as users compile, to be timed.
#pragma once

#include <memory>
#include <vector>

#include "elgen/toolchain.hpp"

namespace elgen {

/// How a function goes through the states.
struct TimedVariant {
  ScalarKind scalar = ScalarKind::double_precision;  ///< or float
  bool in_packs = false;  ///< several states at once, by the header of batches; else one by one
};

/// An emitted function together with arrays of states, number k of state i at [k * count + i].
class TimedFunction {
 public:
  virtual ~TimedFunction() = default;
  /// Computes all states once.
  virtual void run() = 0;
  /// The results of the last run: the entries of all fields, each of all states; numbers of float
  /// are numbers of double.
  [[nodiscard]] virtual std::vector<double> results() const = 0;
};

/// Of each variant.
using TimedFunctions = std::vector<std::unique_ptr<TimedFunction>>;

struct TimingOptions {
  std::vector<TimedVariant> variants = {};
  std::vector<Arguments<float>> states = {};
  Limits limits = {};
};

/// The first function of the program, by each variant, in one library; parameters have their values
/// in the model and are arguments. Errors as of `compile`. Cost: 1 s of the compiler, more for long
/// programs.
[[nodiscard]] Result<TimedFunctions> compile_timed(const EmittedFiles& files, const Model& model,
                                                   const Scene& scene, const Program& program,
                                                   const TimingOptions& options);

}  // namespace elgen
