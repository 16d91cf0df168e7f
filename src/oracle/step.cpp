// step: states are moved as vectors x = (q, v), and put on the unit sphere where they are read.
#include "elgen/step_methods.hpp"
#include "oracle/constraints.hpp"
#include "oracle/output_values.hpp"
#include "oracle/rotations.hpp"
#include "oracle/solved_dynamics.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;
using Values = std::vector<cl_R>;

/// The part of a state that a step moves, and the residual of the equation of an implicit method.
struct Moved {
  Values q;
  Values v;
  Values residual = {};
};

Values sum(const Values& x, const cl_R& factor, const Values& y) {
  Values result;
  for (std::size_t i = 0; i < x.size(); ++i) result.push_back(x[i] + factor * y[i]);
  return result;
}

Moved sum(const Moved& x, const cl_R& factor, const Moved& y) {
  return {sum(x.q, factor, y.q), sum(x.v, factor, y.v)};
}

class Stepping {
 public:
  Stepping(const Model& model, const State& start, const OutputRequest& output)
      : model_(model),
        start_(start),
        iterations_(output.iterations),
        parts_(step_parts(output.composed_order)) {}

  /// x + h/6 (k1 + 2 k2 + 2 k3 + k4)
  Moved rk4() {
    const cl_R& h = start_.h;
    const Moved x{start_.q, start_.v};
    const Moved k1 = rates(x, 0);
    const Moved k2 = rates(sum(x, h / 2, k1), h / 2);
    const Moved k3 = rates(sum(x, h / 2, k2), h / 2);
    const Moved k4 = rates(sum(x, h, k3), h);
    return sum(sum(sum(sum(x, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
  }

  /// Kick, drift, kick, over every part of the step.
  Moved verlet() {
    Moved x{start_.q, start_.v};
    cl_R time = 0;
    for (const cln::cl_RA& part : parts_) {
      const cl_R h = part * start_.h;
      x.v = sum(x.v, h / 2, rates(x, time).v);
      x.q = sum(x.q, h, x.v);
      time = time + h;
      x.v = sum(x.v, h / 2, rates(x, time).v);
    }
    return x;
  }

  /// M w = p + h/2 dp/dt - b at (q + h/2 w, w, t + h/2), substituted as often as is asked for, over
  /// every part of the step; the residual is that of the part in the middle.
  Moved midpoint() {
    Values p = momentum(start_);
    Moved x{start_.q, start_.v};
    cl_R time = 0;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const cl_R h = parts_[k] * start_.h;
      Values& w = x.v;
      const auto middle = [&] { return state_of({sum(x.q, h / 2, w), w}, time + h / 2); };
      for (std::uint32_t i = 0; i < iterations_; ++i) {
        w = velocities(middle(), sum(p, h / 2, momentum_rates(model_, middle())));
      }
      const Values rate = momentum_rates(model_, middle());
      if (k == parts_.size() / 2) {
        x.residual = sum(momentum(middle()), -1, sum(p, h / 2, rate));
      }
      x.q = sum(x.q, h, w);
      p = sum(p, h, rate);
      time = time + h;
    }
    x.v = velocities(state_of(x, time), p);
    return x;
  }

 private:
  [[nodiscard]] State state_of(const Moved& x, const cl_R& later) const {
    State state = start_;
    state.q = normalized(model_, x.q);
    state.v = x.v;
    state.t = state.t + later;
    return state;
  }

  [[nodiscard]] Values momentum(const State& state) const {
    Mechanics at(model_, state);
    return unit_products(at, &Mechanics::momentum);
  }

  [[nodiscard]] Values velocities(const State& state, const Values& p) const {
    return velocities_of_momenta(model_, state, p);
  }

  /// dx/dt at the time t + `later`.
  [[nodiscard]] Moved rates(const Moved& x, const cl_R& later) const {
    const State state = state_of(x, later);
    Mechanics at(model_, state);
    const Motion motion = motion_of(state);
    Moved rates;
    for (const Jet& rate : coordinate_rates(model_, motion.q, motion.v)) {
      rates.q.push_back(rate.real());
    }
    rates.v = constrained_motion(at, constrained_system(at)).x;
    return rates;
  }

  const Model& model_;
  const State& start_;
  std::uint32_t iterations_;
  std::vector<cln::cl_RA> parts_;  ///< of h, of a method that is composed
};

constexpr Moved (Stepping::*methods[])() = {
#define ELGEN_STEP_METHOD(name, domain, order, iterations, doc, equation) &Stepping::name,
#include "elgen/step_methods.def"
#undef ELGEN_STEP_METHOD
};

}  // namespace

Values step(const Model& model, const OutputRequest& output, const State& state) {
  const Moved end = (Stepping(model, state, output).*methods[output.user])();
  Values values = normalized(model, end.q);
  values.insert(values.end(), end.v.begin(), end.v.end());
  values.insert(values.end(), end.residual.begin(), end.residual.end());
  return values;
}

}  // namespace elgen::oracle
