// The explicit methods that take q and v in turns:
//
//     euler    v += h a(q, v, t),   q += h N(q) v                       semi-implicit, order 1
//     verlet   v += h/2 a(q, t),   q += h v,   v += h/2 a(q, t + h)     kick, drift, kick, order 2
//
// Hairer, Lubich, Wanner, Geometric Numerical Integration, 2nd ed., sec. I.1.4 and VI.3.
#include "simulate/steps/methods.hpp"

namespace elgen {
namespace {

class SemiImplicitEuler {
 public:
  explicit SemiImplicitEuler(System& system)
      : system_(system), a_(system.velocities()), rates_(system.positions()) {}

  void restart(const Numbers& /*state*/, double /*t*/) {}

  bool step(Numbers& state, double t, double h) {
    double* const q = state.data();
    double* const v = system_.v_of(state);
    system_.acceleration(q, v, t, a_.data());
    for (std::size_t i = 0; i < a_.size(); ++i) v[i] += h * a_[i];
    System::work_of(state) += h * system_.power(q, v, t);
    system_.coordinate_rates(q, v, rates_.data());
    for (std::size_t i = 0; i < rates_.size(); ++i) q[i] += h * rates_[i];
    system_.normalize(q);
    return true;
  }

 private:
  System& system_;
  Numbers a_;
  Numbers rates_;
};

/// The acceleration at the end of a step is that of the next one.
class Verlet {
 public:
  explicit Verlet(System& system) : system_(system), a_(system.velocities()) {}

  void restart(const Numbers& state, double t) {
    system_.acceleration(state.data(), system_.v_of(state), t, a_.data());
  }

  bool step(Numbers& state, double t, double h) {
    double* const q = state.data();
    double* const v = system_.v_of(state);
    const double begin = system_.power(q, v, t);
    for (std::size_t i = 0; i < a_.size(); ++i) {
      v[i] += h / 2 * a_[i];
      q[i] += h * v[i];
    }
    system_.acceleration(q, v, t + h, a_.data());
    for (std::size_t i = 0; i < a_.size(); ++i) v[i] += h / 2 * a_[i];
    System::work_of(state) += h / 2 * (begin + system_.power(q, v, t + h));
    return true;
  }

 private:
  System& system_;
  Numbers a_;
};

}  // namespace

std::unique_ptr<Stepper> make_euler(System& system, const StepRule& rule) {
  return std::make_unique<FixedSteps<SemiImplicitEuler>>(system, *rule.step);
}

std::unique_ptr<Stepper> make_verlet(System& system, const StepRule& rule) {
  return std::make_unique<FixedSteps<Verlet>>(system, *rule.step);
}

}  // namespace elgen
