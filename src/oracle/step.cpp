// step: integrates a state as a vector x = (q, v). Quaternions are normalised before each
// evaluation. If the step `projects`, its end is projected onto the constraints.
//
// Derivatives are central differences over 1e-45, computed with 135 more digits. They are accepted
// if differences over 1e-48 agree to 80 digits; otherwise smaller differences are tried.
#include <cln/float.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "elgen/step_methods.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/more_digits.hpp"
#include "oracle/constraints.hpp"
#include "oracle/output_values.hpp"
#include "oracle/rotations.hpp"
#include "oracle/solved_dynamics.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;
using Values = std::vector<cl_R>;

/// The part of a state that a step changes, and the residual of an implicit method.
struct StepState {
  Values q;
  Values v;
  Values residual = {};
};

Values add_scaled(const Values& x, const cl_R& factor, const Values& y) {
  Values result;
  for (std::size_t i = 0; i < x.size(); ++i) result.push_back(x[i] + factor * y[i]);
  return result;
}

StepState add_scaled(const StepState& x, const cl_R& factor, const StepState& y) {
  return {add_scaled(x.q, factor, y.q), add_scaled(x.v, factor, y.v)};
}

class OracleStepper {
 public:
  OracleStepper(const Model& model, const State& start, const OutputRequest& output)
      : model_(model),
        start_(start),
        iterations_(output.step->iterations),
        substep_fractions_(composition_coefficients(output.step->composed_order)) {}

  /// x + h/6 (k1 + 2 k2 + 2 k3 + k4)
  StepState rk4() {
    const cl_R& h = start_.h;
    const StepState x{start_.q, start_.v};
    const StepState k1 = state_rates(x, 0);
    const StepState k2 = state_rates(add_scaled(x, h / 2, k1), h / 2);
    const StepState k3 = state_rates(add_scaled(x, h / 2, k2), h / 2);
    const StepState k4 = state_rates(add_scaled(x, h, k3), h);
    return add_scaled(add_scaled(add_scaled(add_scaled(x, h / 6, k1), h / 3, k2), h / 3, k3), h / 6,
                      k4);
  }

  /// Kick, drift, kick for each substep.
  StepState verlet() {
    StepState x{start_.q, start_.v};
    cl_R time = 0;
    for (const cln::cl_RA& part : substep_fractions_) {
      const cl_R h = part * start_.h;
      x.v = add_scaled(x.v, h / 2, state_rates(x, time).v);
      x.q = add_scaled(x.q, h, x.v);
      time = time + h;
      x.v = add_scaled(x.v, h / 2, state_rates(x, time).v);
    }
    return x;
  }

  /// In each substep, solves M w = p + h/2 dp/dt - b at (q + h/2 w, w, t + h/2) for w, by
  /// `iterations` fixed-point iterations. The residual belongs to the middle substep.
  StepState midpoint() {
    Values p = momentum(start_);
    StepState x{start_.q, start_.v};
    cl_R time = 0;
    for (std::size_t k = 0; k < substep_fractions_.size(); ++k) {
      const cl_R h = substep_fractions_[k] * start_.h;
      Values& w = x.v;
      const auto middle = [&] { return state_of({add_scaled(x.q, h / 2, w), w}, time + h / 2); };
      for (std::uint32_t i = 0; i < iterations_; ++i) {
        w = velocities_from_momenta(middle(),
                                    add_scaled(p, h / 2, momentum_rates(model_, middle())));
      }
      const Values rate = momentum_rates(model_, middle());
      if (k == substep_fractions_.size() / 2) {
        x.residual = add_scaled(momentum(middle()), -1, add_scaled(p, h / 2, rate));
      }
      x.q = add_scaled(x.q, h, w);
      p = add_scaled(p, h, rate);
      time = time + h;
    }
    x.v = velocities_from_momenta(state_of(x, time), p);
    return x;
  }

 private:
  [[nodiscard]] State state_of(const StepState& x, const cl_R& later) const {
    State state = start_;
    state.q = normalize_quaternions(model_, x.q);
    state.v = x.v;
    state.t = state.t + later;
    return state;
  }

  [[nodiscard]] Values momentum(const State& state) const {
    Mechanics at(model_, state);
    return unit_products(at, &Mechanics::momentum);
  }

  [[nodiscard]] Values velocities_from_momenta(const State& state, const Values& p) const {
    return velocities_of_momenta(model_, state, p);
  }

  /// dx/dt at the time t + later.
  [[nodiscard]] StepState state_rates(const StepState& x, const cl_R& later) const {
    const State state = state_of(x, later);
    Mechanics at(model_, state);
    const Motion motion = make_motion(state);
    StepState rates;
    for (const Jet& rate : coordinate_rates(model_, motion.q, motion.v)) {
      rates.q.push_back(rate.real());
    }
    rates.v = constrained_motion(at, constrained_system(at)).x;
    return rates;
  }

  const Model& model_;
  const State& start_;
  std::uint32_t iterations_;
  std::vector<cln::cl_RA> substep_fractions_;  ///< substeps as fractions of h; {1} if not composed
};

constexpr StepState (OracleStepper::*step_methods[])() = {
#define ELGEN_STEP_METHOD(name, domain, order, iterations, doc, equation) &OracleStepper::name,
#include "elgen/step_methods.def"
#undef ELGEN_STEP_METHOD
};

/// The state in floats, with enough digits for differences over 10^-`digits`.
State extend_floats(const State& state, unsigned digits) {
  const cln::float_format_t format = cln::float_format(150 + 3 * digits);
  return map_leaves([&](const cl_R& x) { return cl_R(cln::cl_float(x, format)); }, state);
}

/// The state displaced by `size` along a direction of (q, v, u). The q part contains rotation
/// vectors for quaternions.
State displace_state(const Model& model, State state, const Direction& along, const cl_R& size) {
  const std::size_t n = state.v.size();
  const std::vector<Jet> moving(along.begin(), along.begin() + static_cast<std::ptrdiff_t>(n));
  const std::vector<Jet> rates = coordinate_rates(model, make_motion(state).q, moving);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    state.q[i] = state.q[i] + size * rates[i].real();
  }
  for (std::size_t i = 0; i < n; ++i) state.v[i] = state.v[i] + size * along[n + i];
  for (std::size_t i = 0; i < state.u.size(); ++i) {
    state.u[i] = state.u[i] + size * along[2 * n + i];
  }
  return state;
}

/// dq in the components of velocities; for a quaternion e the rotation vector 4 N(e)^T de.
Values velocity_components(const Model& model, const Values& q, const Values& dq) {
  Values result;
  const std::size_t n = model.velocities.size();
  const std::vector<Jet> place(q.begin(), q.end());
  for (std::size_t j = 0; j < n; ++j) {
    const Direction unit = unit_direction(n, j);
    const std::vector<Jet> move =
        coordinate_rates(model, place, std::vector<Jet>(unit.begin(), unit.end()));
    cl_R sum = 0;
    for (std::size_t i = 0; i < dq.size(); ++i) sum = sum + move[i].real() * dq[i];
    result.push_back(model.velocities[j].rotation ? 4 * sum : sum);
  }
  return result;
}

/// Steps that start from the states `start` + size * `along`, and the derivative of the end states
/// with respect to size.
class DirectionalStep {
 public:
  DirectionalStep(const Model& model, const OutputRequest& output, State start,
                  const Direction& along)
      : model_(model), output_(output), start_(std::move(start)), along_(along) {}

  /// d x(t + h)/d size at size = 0; empty unless central differences over 10^-`digits` and over
  /// 10^-(`digits` + 3) agree to 80 digits.
  [[nodiscard]] std::optional<Values> slope(unsigned digits) const {
    const Values wide = central_difference(power_of_ten(-static_cast<long>(digits)));
    const Values narrow = central_difference(power_of_ten(-static_cast<long>(digits) - 3));
    const cl_R tolerance = max_magnitude(narrow) * power_of_ten(-80);
    for (std::size_t i = 0; i < wide.size(); ++i) {
      if (cln::abs(wide[i] - narrow[i]) > tolerance) return std::nullopt;
    }
    return narrow;
  }

 private:
  [[nodiscard]] Values central_difference(const cl_R& size) const {
    const Values there = take_step(model_, output_, displace_state(model_, start_, along_, size));
    const Values back = take_step(model_, output_, displace_state(model_, start_, along_, -size));
    const std::size_t coordinates = start_.q.size();
    Values middle;  // quaternions have length 1 + O(size^2)
    Values change;
    for (std::size_t i = 0; i < coordinates + start_.v.size(); ++i) {
      middle.push_back((there[i] + back[i]) / 2);
      change.push_back((there[i] - back[i]) / (2 * size));
    }
    const auto first_rate = static_cast<std::ptrdiff_t>(coordinates);
    Values result =
        velocity_components(model_, middle, {change.begin(), change.begin() + first_rate});
    result.insert(result.end(), change.begin() + first_rate, change.end());
    return result;
  }

  const Model& model_;
  const OutputRequest& output_;
  State start_;
  const Direction& along_;
};

/// The derivative of x(t + h) along a direction of (q, v, u). Retries use smaller differences and
/// more digits, because a step that is too long for a system amplifies differences by hundreds of
/// orders of magnitude.
Values step_slope(const Model& model, const OutputRequest& output, const State& state,
                  const Direction& along) {
  for (const unsigned digits : {45U, 150U, 450U}) {
    const std::optional<Values> found = with_digits(3 * digits, [&] {
      return DirectionalStep(model, output, extend_floats(state, digits), along).slope(digits);
    });
    if (found) return *found;
  }
  throw OutsideDomain("a step without a slope");
}

}  // namespace

Values take_step(const Model& model, const OutputRequest& output, const State& state) {
  const auto method = static_cast<std::size_t>(output.step->method);
  const StepState end = (OracleStepper(model, state, output).*step_methods[method])();
  Values values = normalize_quaternions(model, end.q);
  if (output.step->projects) {
    State there = state;
    there.q = values;
    there.v = end.v;
    there.t = state.t + state.h;
    return project_state(model, there);
  }
  values.insert(values.end(), end.v.begin(), end.v.end());
  values.insert(values.end(), end.residual.begin(), end.residual.end());
  return values;
}

Values step_derivatives(const Model& model, const OutputRequest& output, const State& state) {
  const std::size_t rows = 2 * state.v.size();
  const std::size_t inputs = state.u.size();
  Values values(rows * (rows + inputs));
  for (std::size_t j = 0; j < rows + inputs; ++j) {
    const Values column = step_slope(model, output, state, unit_direction(rows + inputs, j));
    for (std::size_t i = 0; i < rows; ++i) {
      values[j < rows ? i * rows + j : rows * rows + i * inputs + j - rows] = column[i];
    }
  }
  return values;
}

cl_R step_contraction(const Model& model, const OutputRequest& output, const State& state,
                      const Contraction& by) {
  const std::size_t rows = 2 * state.v.size();
  Direction along(rows + state.u.size());
  std::ranges::copy(by.y, along.begin() + static_cast<std::ptrdiff_t>(by.field == 0 ? 0 : rows));
  const Values values = step_slope(model, output, state, along);
  cl_R sum = 0;
  for (std::size_t i = 0; i < by.w.size(); ++i) sum = sum + by.w[i] * values[i];
  return sum;
}

}  // namespace elgen::oracle
