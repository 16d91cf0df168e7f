// The implicit midpoint rule on (q, p). With q_m = q + h/2 v and everything at (q_m, v, t + h/2)
//
//     p = dL/dv - h/2 (dL/dq + F)      is solved for v,    F = B u + Q - dD/dv
//     q += h v,   p += h (dL/dq + F)
//
// It is the variational integrator of L_d = h L((q0 + q1)/2, (q1 - q0)/h, t + h/2), forces at the
// midpoint, half to each side: symplectic, and exact for momenta of cyclic coordinates. Marsden,
// West, Discrete mechanics and variational integrators, Acta Numerica (2001), sec. 2.6.2 and 3.2.
#include <algorithm>
#include <cmath>

#include "simulate/steps/methods.hpp"
#include "simulate/steps/newton.hpp"

namespace elgen {
namespace {

class ImplicitMidpoint {
 public:
  explicit ImplicitMidpoint(System& system)
      : system_(system),
        v_(system.velocities()),
        middle_(system.positions()),
        momentum_(v_.size()),
        gradient_(v_.size()),
        force_(v_.size()) {}

  void restart(const Numbers& /*state*/, double /*t*/) { steps_.forget(); }

  bool step(Numbers& state, double t, double h) {
    double* const q = state.data();
    double* const p = system_.v_of(state);
    const double t_m = t + h / 2;
    const auto residual = [&](const Numbers& v, Numbers& r) {
      evaluate_at(q, v, t_m, h);
      double scale = 0;
      for (std::size_t i = 0; i < v.size(); ++i) {
        const double impulse = h / 2 * (gradient_[i] + force_[i]);
        r[i] = momentum_[i] - impulse - p[i];
        scale += std::abs(momentum_[i]) + std::abs(impulse) + std::abs(p[i]);
      }
      return scale;
    };
    if (!steps_.solve(v_, residual)) return false;
    System::work_of(state) += h * system_.power(middle_.data(), v_.data(), t_m);
    for (std::size_t i = 0; i < v_.size(); ++i) {
      q[i] += h * v_[i];
      p[i] += h * (gradient_[i] + force_[i]);
    }
    return true;
  }

  void to_own(Numbers& state, double t) {
    std::copy_n(system_.v_of(state), v_.size(), v_.begin());
    plain_ = v_;
    system_.momentum(state.data(), v_.data(), t, system_.v_of(state));
  }

  /// p = dL/dv is solved for v, from that of the last state that was asked for on.
  void to_plain(Numbers& state, double t) {
    double* const p = system_.v_of(state);
    const auto residual = [&](const Numbers& at, Numbers& r) {
      system_.momentum(state.data(), at.data(), t, r.data());
      double scale = 0;
      for (std::size_t i = 0; i < at.size(); ++i) {
        scale += std::abs(r[i]) + std::abs(p[i]);
        r[i] -= p[i];
      }
      return scale;
    };
    if (!velocities_.solve(plain_, residual)) plain_.assign(plain_.size(), NAN);
    std::copy(plain_.begin(), plain_.end(), p);
  }

 private:
  void evaluate_at(const double* q, const Numbers& v, double t_m, double h) {
    for (std::size_t i = 0; i < v.size(); ++i) middle_[i] = q[i] + h / 2 * v[i];
    system_.momentum(middle_.data(), v.data(), t_m, momentum_.data());
    system_.position_gradient(middle_.data(), v.data(), t_m, gradient_.data());
    system_.force(middle_.data(), v.data(), t_m, force_.data());
  }

  System& system_;
  Numbers v_;           ///< of the last step
  Numbers plain_ = {};  ///< of the last state that was asked for
  Numbers middle_;
  Numbers momentum_;
  Numbers gradient_;
  Numbers force_;
  Newton steps_ = {};
  Newton velocities_ = {};
};

class MidpointSteps final : public FixedSteps<ImplicitMidpoint> {
 public:
  using FixedSteps::FixedSteps;
  void to_own(Numbers& state, double t) override { method.to_own(state, t); }
  void to_plain(Numbers& state, double t) override { method.to_plain(state, t); }
};

}  // namespace

std::unique_ptr<Stepper> make_midpoint(System& system, const StepRule& rule) {
  return std::make_unique<MidpointSteps>(system, *rule.step);
}

}  // namespace elgen
