// rk4 and dopri5 by Boost.odeint: the classical method of Runge and Kutta, and the method of
// Dormand and Prince of order 5, which adapts its steps to an error estimate and ends them at kinks
// of the forces. Laws of inputs are evaluated at every stage. Hairer, Norsett, Wanner, Solving
// Ordinary Differential Equations I, 2nd ed., sec. II.1, II.5 and II.6.
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "run/steps/methods.hpp"
#include "run/steps/pieces.hpp"

namespace elgen {
namespace {

namespace odeint = boost::numeric::odeint;

/// find_rates() of a SimulatedSystem or PiecewiseMotion, as a function for odeint.
template <class Source>
auto rate_function(Source& source) {
  return [&source](const Numbers& state, Numbers& rates, double t) {
    source.find_rates(state, rates, t);
  };
}

/// Discards the rates at the end of the last step, if the method would reuse them in the next step.
template <class Steps>
void discard_rates(Steps& steps) {
  if constexpr (requires { steps.reset(); }) steps.reset();
}

/// Call at the end of a step. Projects the state, and discards the rates at the end of the step,
/// which belong to the unprojected state.
template <class Steps>
void project_state(SimulatedSystem& system, Steps& steps, Numbers& state, double t) {
  if (!system.needs_projection()) return;
  system.project_state(state, t);
  discard_rates(steps);
}

template <class Steps>
class RungeKutta {
 public:
  explicit RungeKutta(SimulatedSystem& system) : system_(system) {}

  void restart() { discard_rates(steps_); }

  bool step(Numbers& state, double t, double h) {
    steps_.do_step(rate_function(system_), state, t, h);
    project_state(system_, steps_, state, t + h);
    return true;
  }

 private:
  SimulatedSystem& system_;
  Steps steps_ = {};
};

/// Makes steps of the largest length that the error estimate permits. No step crosses a kink.
template <class Steps>
class AdaptiveStepper final : public Stepper {
 public:
  AdaptiveStepper(SimulatedSystem& system, const StepRule& rule)
      : system_(system),
        pieces_(system, rule.tolerance),
        steps_(odeint::make_controlled(rule.tolerance, rule.tolerance, Steps())),
        shortest_(rule.shortest_step) {}

  void set_interval(double begin, double end) override {
    t_ = begin;
    end_ = end;
    if (length_ == 0) length_ = (end - begin) / 100;
    discard_rates(steps_);
  }

  std::optional<double> step(Numbers& state) override {
    const double begin = t_;
    const bool is_first = !has_begun_ && pieces_.has_kinks();
    has_begun_ = true;
    if (is_first) pieces_.begin_piece(state, state, t_);
    if (!advance(state)) return std::nullopt;
    const bool is_tiny = t_ - begin < tiny_step_limit();
    const bool is_at_kink = tiny_steps_ > 0 || has_crossed_;
    has_crossed_ = false;
    tiny_steps_ = is_tiny && is_at_kink ? tiny_steps_ + 1 : 0;
    if (tiny_steps_ < most_tiny_steps) return t_;
    obstacle_ = std::string(slides_along) + pieces_.last_kink();
    return std::nullopt;
  }

  [[nodiscard]] std::string_view failure_reason() const override { return obstacle_; }

  [[nodiscard]] std::string_view failure_hint() const override {
    if (tiny_steps_ < most_tiny_steps) return Stepper::failure_hint();
    return "a smooth approximation is tanh(x/width); `--method rk4 --step` continues over the kink";
  }

 private:
  /// If the motion slides along a kink at which no rate is held, every step changes the side, and
  /// time hardly advances. After this many tiny steps the run ends.
  static constexpr int most_tiny_steps = 1000;

  /// The shortest step: 1e-12 of the run, but at least 4 times the spacing of doubles near t.
  [[nodiscard]] double shortest_step() const {
    const double spacing =
        std::numeric_limits<double>::epsilon() * std::max(std::abs(t_), std::abs(end_));
    return std::max(shortest_, 4 * spacing);
  }

  /// Steps below this length are tiny: 1e-9 of the run, but at least 4 times the shortest step.
  [[nodiscard]] double tiny_step_limit() const {
    return std::max(1e3 * shortest_, 4 * shortest_step());
  }

  /// Makes one step and sets `t_`; false if the tolerance needs less than shortest_step().
  bool advance(Numbers& state) {
    while (true) {
      // The piece ends before `piece_end_bound_`, so a step covers half of the time to this bound.
      const double half = (piece_end_bound_ - t_) / 2;
      if (half < shortest_step()) return cross_kink(state);
      const double wanted = std::min(length_, half);
      const bool is_last = wanted >= end_ - t_;
      double h = is_last ? end_ - t_ : wanted;
      if (h < shortest_step() && !is_last) return false;
      const bool is_cut = h < length_;
      const double begin = t_;
      const double tried = h;
      before_ = state;
      pieces_.reset_left_piece();
      const auto result = steps_.try_step(rate_function(pieces_), state, t_, h);
      if (pieces_.has_left_piece()) {
        state = before_;
        t_ = begin;
        piece_end_bound_ = begin + tried;
        discard_rates(steps_);
        continue;
      }
      if (result == odeint::fail) {
        length_ = h;
        continue;
      }
      // A step that was shortened for the end or for a kink does not limit the next step.
      length_ = is_cut ? std::max(length_, h) : h;
      if (is_last) t_ = end_;
      project_state(system_, steps_, state, t_);
      pieces_.reset_held_rates(state);
      return true;
    }
  }

  /// Leaves the piece by a step of Euler's method, so short that the state hardly changes.
  bool cross_kink(Numbers& state) {
    before_ = state;
    Numbers slope(state.size());
    Numbers unused(state.size());
    pieces_.find_rates(before_, slope, t_);
    double h = 0;
    pieces_.reset_left_piece();
    for (double next = shortest_step();
         !pieces_.has_left_piece() && h < tiny_step_limit() && t_ + h < end_; next *= 2) {
      h = std::min(next, end_ - t_);
      for (std::size_t i = 0; i < state.size(); ++i) state[i] = before_[i] + h * slope[i];
      pieces_.find_rates(state, unused, t_ + h);
    }
    t_ = t_ + h < end_ ? t_ + h : end_;
    if (pieces_.has_left_piece()) pieces_.begin_piece(before_, state, t_);
    has_crossed_ = pieces_.has_left_piece();
    piece_end_bound_ = std::numeric_limits<double>::infinity();
    length_ = 2 * tiny_step_limit();
    project_state(system_, steps_, state, t_);
    pieces_.reset_held_rates(state);
    discard_rates(steps_);
    return true;
  }

  SimulatedSystem& system_;
  PiecewiseMotion pieces_;
  typename odeint::result_of::make_controlled<Steps>::type steps_;
  double shortest_;
  double t_ = 0;
  double end_ = 0;
  double length_ = 0;  ///< of the next step; 0 before the first
  double piece_end_bound_ =
      std::numeric_limits<double>::infinity();  ///< a time after the piece's end
  bool has_begun_ = false;
  bool has_crossed_ = false;
  int tiny_steps_ = 0;  ///< tiny steps in succession since a kink was crossed
  Numbers before_ = {};
  std::string obstacle_{step_too_short};
};

template <class Steps>
std::unique_ptr<Stepper> make_fixed_stepper(SimulatedSystem& system, double step) {
  return std::make_unique<FixedStepper<RungeKutta<Steps>>>(system, step);
}

}  // namespace

std::unique_ptr<Stepper> make_rk4(SimulatedSystem& system, const StepRule& rule) {
  return make_fixed_stepper<odeint::runge_kutta4<Numbers>>(system, *rule.step);
}

std::unique_ptr<Stepper> make_dopri5(SimulatedSystem& system, const StepRule& rule) {
  using Steps = odeint::runge_kutta_dopri5<Numbers>;
  if (rule.step) return make_fixed_stepper<Steps>(system, *rule.step);
  return std::make_unique<AdaptiveStepper<Steps>>(system, rule);
}

}  // namespace elgen
