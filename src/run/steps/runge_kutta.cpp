// rk4 and dopri5 by Boost.odeint: classical Runge and Kutta's method, and Dormand and Prince's of
// order 5 with an estimate of its error. Laws of inputs are asked for at every stage. Hairer,
// Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., sec. II.1 and II.5.
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <limits>

#include "run/steps/methods.hpp"

namespace elgen {
namespace {

namespace odeint = boost::numeric::odeint;

/// d(q, v, W)/dt as odeint asks for it.
struct StateRates {
  System* system;

  void operator()(const Numbers& state, Numbers& rates, double t) const {
    const double* const q = state.data();
    const double* const v = system->v_of(state);
    system->coordinate_rates(q, v, rates.data());
    system->acceleration(q, v, t, system->v_of(rates));
    System::work_of(rates) = system->power(q, v, t);
  }
};

/// Forgets the rates at the end of the last step, where the method keeps them for the next one.
template <class Steps>
void forget(Steps& steps) {
  if constexpr (requires { steps.reset(); }) steps.reset();
}

/// To be called after a step, at its end. StateRates at quaternions of another length, or off the
/// constraints, are those of another state.
template <class Steps>
void put_back(System& system, Steps& steps, Numbers& state, double t) {
  if (!system.is_restored()) return;
  system.restore(state, t);
  forget(steps);
}

template <class Steps>
class RungeKutta {
 public:
  explicit RungeKutta(System& system) : system_(system) {}

  void restart() { forget(steps_); }

  bool step(Numbers& state, double t, double h) {
    steps_.do_step(StateRates{&system_}, state, t, h);
    put_back(system_, steps_, state, t + h);
    return true;
  }

 private:
  System& system_;
  Steps steps_ = {};
};

/// Steps as long as their estimated error allows.
template <class Steps>
class AdaptedSteps final : public Stepper {
 public:
  AdaptedSteps(System& system, const StepRule& rule)
      : system_(system),
        steps_(odeint::make_controlled(rule.tolerance, rule.tolerance, Steps())),
        shortest_(rule.shortest) {}

  void aim(double begin, double end) override {
    t_ = begin;
    end_ = end;
    if (length_ == 0) length_ = (end - begin) / 100;
    forget(steps_);
  }

  std::optional<double> step(Numbers& state) override {
    const double spacing =
        std::numeric_limits<double>::epsilon() * std::max(std::abs(t_), std::abs(end_));
    const double shortest = std::max(shortest_, 4 * spacing);
    while (true) {
      const bool is_last = length_ >= end_ - t_;
      double h = is_last ? end_ - t_ : length_;
      if (h < shortest && !is_last) return std::nullopt;
      const auto result = steps_.try_step(StateRates{&system_}, state, t_, h);
      if (result == odeint::fail) {
        length_ = h;
        continue;
      }
      // A step that the end made short says little of the length of the next one.
      length_ = is_last ? std::max(length_, h) : h;
      if (is_last) t_ = end_;
      put_back(system_, steps_, state, t_);
      return t_;
    }
  }

  [[nodiscard]] std::string_view obstacle() const override {
    return "the step that the tolerance asks for is too short to be made";
  }

 private:
  System& system_;
  typename odeint::result_of::make_controlled<Steps>::type steps_;
  double shortest_;
  double t_ = 0;
  double end_ = 0;
  double length_ = 0;  ///< of the next step
};

template <class Steps>
std::unique_ptr<Stepper> fixed(System& system, double step) {
  return std::make_unique<FixedSteps<RungeKutta<Steps>>>(system, step);
}

}  // namespace

std::unique_ptr<Stepper> make_rk4(System& system, const StepRule& rule) {
  return fixed<odeint::runge_kutta4<Numbers>>(system, *rule.step);
}

std::unique_ptr<Stepper> make_dopri5(System& system, const StepRule& rule) {
  using Steps = odeint::runge_kutta_dopri5<Numbers>;
  if (rule.step) return fixed<Steps>(system, *rule.step);
  return std::make_unique<AdaptedSteps<Steps>>(system, rule);
}

}  // namespace elgen
