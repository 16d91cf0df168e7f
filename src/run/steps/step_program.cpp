// verlet and midpoint: evaluates the output `step` once per step, with the inputs at the beginning
// of the step. The work of a step is h times the power at the midpoint, with the mean rates.
#include <algorithm>
#include <cmath>

#include "run/steps/methods.hpp"

namespace elgen {
namespace {

/// An implicit step is solved if sum |residual| is at most this fraction of sum |p| at the
/// beginning of the step plus sum |p| at its end.
constexpr double largest_residual = 1e-3;

class StepProgramMethod {
 public:
  explicit StepProgramMethod(SimulatedSystem& system)
      : system_(system),
        middle_(system.position_count()),
        rates_(system.velocity_count()),
        momentum_(system.velocity_count()) {}

  void restart() {}

  bool step(Numbers& state, double t, double h) {
    const Numbers& next = system_.step_result(state, t, h);
    if (!is_solved(state, next, t, h)) return false;
    // Models with rotations have no `step`, so dq/dt = v.
    for (std::size_t i = 0; i < rates_.size(); ++i) {
      rates_[i] = (next[i] - state[i]) / h;
      middle_[i] = state[i] + h / 2 * rates_[i];
    }
    SimulatedSystem::work_of(state) +=
        h * system_.power_at_last_inputs(middle_.data(), rates_.data(), t + h / 2);
    std::copy_n(next.begin(), state.size() - 1, state.begin());
    return true;
  }

 private:
  [[nodiscard]] bool is_solved(const Numbers& state, const Numbers& next, double t, double h) {
    const std::size_t residual = state.size() - 1;
    double left = 0;
    for (std::size_t i = residual; i < next.size(); ++i) left += std::abs(next[i]);
    return left == 0 || left <= largest_residual * (momentum_magnitude(state, t) +
                                                    momentum_magnitude(next, t + h));
  }

  double momentum_magnitude(const Numbers& state, double t) {
    system_.find_momentum(state.data(), system_.v_of(state), t, momentum_.data());
    double sum = 0;
    for (const double p : momentum_) sum += std::abs(p);
    return sum;
  }

  SimulatedSystem& system_;
  Numbers middle_;
  Numbers rates_;
  Numbers momentum_;
};

}  // namespace

std::unique_ptr<Stepper> make_step_program(SimulatedSystem& system, const StepRule& rule) {
  return std::make_unique<FixedStepper<StepProgramMethod>>(system, *rule.step);
}

}  // namespace elgen
