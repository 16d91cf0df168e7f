// Mechanics: each quantity is the coefficient of some generators in one evaluation of an energy.
// Expansions: expressions of the model give the point, and motions are scaled towards it.
#include "oracle/mechanics.hpp"

#include <algorithm>

#include "oracle/real_functions.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;

constexpr Generators first = generator(0);
constexpr Generators second = generator(1);
constexpr Generators third = generator(2);

std::vector<Jet> jets(const std::vector<cl_R>& reals) { return {reals.begin(), reals.end()}; }

using KnownValues = std::vector<std::optional<cl_R>>;

void scale(std::vector<Jet>& quantity, const KnownValues& about, const Jet& s) {
  for (std::size_t i = 0; i < quantity.size(); ++i) {
    if (about[i]) quantity[i] = Jet(*about[i]) + s * (quantity[i] - Jet(*about[i]));
  }
}

/// Evaluates expressions in parameters; an absent expression has no value.
KnownValues values_of(const Model& model,
                      const std::vector<std::optional<ExpressionId>>& expressions,
                      const State& state) {
  const Motion motion = motion_of(state);
  Evaluation at(model, motion);
  KnownValues values;
  for (const auto& expression : expressions) {
    values.push_back(expression ? std::optional(at.value(*expression).real()) : std::nullopt);
  }
  return values;
}

}  // namespace

Direction unit_direction(std::size_t n, std::size_t i) {
  Direction direction(n, cl_R(0));
  direction[i] = 1;
  return direction;
}

State shortened(const State& state) {
  return map_leaves([](const cl_R& value) { return shortened(value, longest_leaf); }, state);
}

Motion motion_of(const State& state) {
  return map_leaves([](const cl_R& value) { return Jet(value); }, shortened(state));
}

std::optional<ExpansionPoint> expansion_point(const Model& model, const State& state) {
  if (!model.approximation) return std::nullopt;
  const Approximation& approximation = *model.approximation;
  ExpansionPoint point;
  point.order = approximation.order;
  point.q = values_of(model, approximation.coordinates, state);
  point.u = values_of(model, approximation.inputs, state);
  point.v.resize(model.velocities.size());
  for (std::size_t i = 0; i < point.q.size(); ++i) {
    if (!approximation.small[i]) point.q[i].reset();
    if (approximation.small[i]) point.v[model.coordinates[i].velocity] = cl_R(0);
  }
  const bool small_inputs = approximation.small_inputs;
  for (std::optional<cl_R>& value : point.u) {
    if (!small_inputs) value.reset();
    if (small_inputs && !value) value = cl_R(0);
  }
  return point;
}

Motion scaled_towards(const ExpansionPoint& point, const Motion& motion, unsigned order) {
  const Jet s(graded_symbol(order), 1);
  Motion result = motion;
  scale(result.q, point.q, s);
  scale(result.v, point.v, s);
  scale(result.a, point.v, s);
  scale(result.u, point.u, s);
  return result;
}

Mechanics::Mechanics(const Model& model, const State& state)
    : model_(model),
      state_(shortened(state)),
      point_(expansion_point(model, state_)),
      base_(motion_of(state_)) {
  base_.a.assign(model.velocities.size(), Jet());
  base_.u.assign(model.inputs.size(), Jet());
}

Motion Mechanics::at_rest() const {
  Motion motion = base_;
  motion.v.assign(size(), Jet());
  return motion;
}

template <class Quantity>
Jet Mechanics::expanded(unsigned order, const Motion& motion, const Quantity& quantity) const {
  if (!point_) return quantity(motion);
  return quantity(scaled_towards(*point_, motion, order)).ungraded();
}

Jet Mechanics::energy_at(Energy energy, const Motion& motion) {
  return expanded(point_ ? point_->order + 1 : 0, motion, [&](const Motion& moved) {
    Evaluation evaluation(model_, moved, functions_);
    return energy(evaluation);
  });
}

Jet Mechanics::potential_at(const Motion& motion) {
  return has_whole_lagrangian(model_) ? -energy_at(lagrangian, motion)
                                      : energy_at(oracle::potential_energy, motion);
}

/// Coefficient of e0 e1 in L(q, v + w e0 + y e1). If L is quadratic, M does not depend on v, and
/// evaluation at rest is cheaper.
cl_R Mechanics::mass(const Direction& w, const Direction& y) {
  Motion motion = model_.quadratic ? at_rest() : base_;
  displace(motion.v, w, first);
  displace(motion.v, y, second);
  return energy_at(lagrangian, motion).coefficient(first | second);
}

/// M_ij is the coefficient of e_i g_j in L(q, v + sum e_i w_i + sum g_j y_j), with unit vectors
/// w_i, y_j. If L is quadratic, one evaluation with six generators gives nine entries. Otherwise
/// each evaluation gives one entry, because functions of jets in six generators would cost more.
std::vector<cl_R> Mechanics::mass_matrix() {
  const std::size_t n = size();
  const std::size_t block = model_.quadratic ? 3 : 1;
  const auto first_of = [](std::size_t i) { return generator(static_cast<unsigned>(i)); };
  const auto second_of = [](std::size_t j) { return generator(static_cast<unsigned>(3 + j)); };
  std::vector<cl_R> values(n * n);
  for (std::size_t row = 0; row < n; row += block) {
    const std::size_t rows = std::min(block, n - row);
    for (std::size_t column = 0; column <= row; column += block) {
      const std::size_t columns = std::min(block, n - column);
      Motion motion = model_.quadratic ? at_rest() : base_;
      for (std::size_t i = 0; i < rows; ++i) displace(motion.v, unit(row + i), first_of(i));
      for (std::size_t j = 0; j < columns; ++j) displace(motion.v, unit(column + j), second_of(j));
      const Jet energy = energy_at(lagrangian, motion);
      for (std::size_t k = 0; k < rows * columns; ++k) {
        const std::size_t i = k / columns;
        const std::size_t j = k % columns;
        cl_R& entry = values[(row + i) * n + column + j];
        entry = energy.coefficient(first_of(i) | second_of(j));
        values[(column + j) * n + row + i] = entry;
      }
    }
  }
  return values;
}

cl_R Mechanics::cross_mass(const Direction& w, const Direction& by, const Direction& y) {
  return model_.rotations.empty() ? 0 : mass(cross_on_rotations(model_, w, by), y);
}

/// Coefficient of e0 e1 e2 in L(q + x e2, w e0 + y e1).
cl_R Mechanics::mass_gradient(const Direction& x, const Direction& w, const Direction& y) {
  Motion motion = at_rest();
  displace(motion.v, w, first);
  displace(motion.v, y, second);
  displace_position(model_, motion, x, third);
  return energy_at(lagrangian, motion).coefficient(first | second | third);
}

cl_R Mechanics::momentum(const Direction& w) {
  Motion motion = base_;
  displace(motion.v, w, first);
  return energy_at(lagrangian, motion).coefficient(first);
}

/// p_i is the coefficient of e0 in L(v + w_i e0), w_i the i-th unit vector; v.dL/dv is the
/// coefficient of e0 in L(v + v e0).
void Mechanics::add_momenta(Motion& motion) {
  motion.momenta.assign(size(), Jet());
  for (std::size_t i = 0; i < size(); ++i) {
    Motion pushed = motion;
    displace(pushed.v, unit(i), first);
    motion.momenta[i] = energy_at(lagrangian, pushed).tangent(first);
  }
  Motion scaled = motion;
  displace(scaled.v, motion.v, first);
  const Jet value = energy_at(lagrangian, scaled);
  motion.E = value.tangent(first) - value.without(first);
}

cl_R Mechanics::position_gradient(const Direction& w) {
  Motion motion = base_;
  displace_position(model_, motion, w, first);
  return energy_at(lagrangian, motion).coefficient(first);
}

/// d/dt (w.dL/dv) is the coefficient of e0 e1 in L(q + dq/dt e1, v + a e1 + w e0, t + e1).
Jet Mechanics::residual(const Motion& at, const Direction& w, const Direction& a) {
  Motion moving = at;
  advance_time(model_, moving, a, second);
  displace(moving.v, w, first);
  Motion displaced = at;
  displace_position(model_, displaced, w, first);
  Motion resisted = at;
  displace(resisted.v, w, first);
  Jet sum = energy_at(lagrangian, moving).tangent(first).tangent(second) -
            energy_at(lagrangian, displaced).tangent(first) +
            energy_at(dissipation, resisted).tangent(first) - force_along(at, w);
  if (model_.rotations.empty()) return sum;
  Motion turning = at;
  displace(turning.v, cross_on_rotations(model_, jets(w), at.v), first);
  return sum + energy_at(lagrangian, turning).tangent(first);
}

cl_R Mechanics::inverse_dynamics(const Direction& w, const Direction& a) {
  return residual(base_, w, a).real();
}

Direction Mechanics::cross_velocity(const Direction& d) const {
  return cross_on_rotations(model_, state_.v, d);
}

cl_R Mechanics::residual_slope(const Direction& w, const Displacement& along, const Direction& a,
                               const Direction& inputs) {
  Motion at = base_;
  at.u = jets(inputs);
  displace_position(model_, at, along.x, third);
  displace(at.v, along.y, third);
  return residual(at, w, a).coefficient(third);
}

cl_R Mechanics::gravity(const Direction& w) {
  Motion motion = at_rest();
  displace_position(model_, motion, w, first);
  return potential_at(motion).coefficient(first);
}

cl_R Mechanics::dissipation_force(const Direction& w) {
  Motion motion = base_;
  displace(motion.v, w, first);
  return energy_at(dissipation, motion).coefficient(first);
}

/// Forces along small coordinates are expanded to the order of the equations, forces along other
/// coordinates to one order more.
Jet Mechanics::force_along(const Motion& motion, const Direction& w) {
  if (!point_) return exact_force_along(motion, w);
  Direction small = w;
  Direction others = w;
  for (std::size_t i = 0; i < w.size(); ++i) (point_->v[i] ? others : small)[i] = 0;
  const auto along = [&](unsigned order, const Direction& part) {
    return expanded(order, motion, [&](const Motion& at) { return exact_force_along(at, part); });
  };
  return along(point_->order, small) + along(point_->order + 1, others);
}

/// sum Q_i w_i + sum F.(dp/dq w) + sum N.turn. The displacement along w is in generator e0; turn is
/// the rotation of the frame by this displacement.
Jet Mechanics::exact_force_along(const Motion& motion, const Direction& w) {
  Motion displaced = motion;
  displace_position(model_, displaced, w, first);
  Evaluation moving(model_, displaced, functions_);
  // The spin is linear in the rates, so the spin at the rates w is the rotation along w.
  Motion turned = motion;
  for (std::size_t i = 0; i < turned.v.size(); ++i) turned.v[i] = Jet(first, w[i]);
  Evaluation turning(model_, turned, functions_);
  const auto work = [&](Evaluation& at, const auto& place, const std::vector<ExpressionId>& force) {
    Jet sum;
    for (std::size_t c = 0; c < force.size(); ++c) {
      const Jet displacement = at.value(place[c]).tangent(first);
      sum = sum + moving.value(force[c]).without(first) * displacement;
    }
    return sum;
  };
  Jet sum;
  for (const Force& f : model_.forces) {
    if (f.on) sum = sum + moving.value(f.value[0]).without(first) * Jet(w[*f.on]);
    if (f.frame) sum = sum + work(turning, model_.frames[*f.frame].spin, f.value);
    if (f.from_frame) sum = sum - work(turning, model_.frames[*f.from_frame].spin, f.reaction);
    if (f.at) sum = sum + work(moving, model_.points[*f.at].at, f.value);
    if (f.from) sum = sum - work(moving, model_.points[*f.from].at, f.value);
  }
  for (std::size_t k = 0; k < model_.inputs.size(); ++k) {
    if (model_.inputs[k].on) sum = sum + motion.u[k] * Jet(w[*model_.inputs[k].on]);
  }
  return sum;
}

cl_R Mechanics::applied_force(const Direction& w) { return force_along(base_, w).real(); }

cl_R Mechanics::input_force(const Direction& w, const Direction& y) {
  Motion motion = base_;
  displace(motion.u, y, second);
  return force_along(motion, w).coefficient(second);
}

cl_R Mechanics::kinetic_energy() {
  if (has_whole_lagrangian(model_)) return mass(state_.v, state_.v) / 2;
  return energy_at(oracle::kinetic_energy, base_).real();
}

cl_R Mechanics::potential_energy() {
  return has_whole_lagrangian(model_) ? potential_energy_at_rest() : potential_at(base_).real();
}

cl_R Mechanics::potential_energy_at_rest() { return potential_at(at_rest()).real(); }

cl_R Mechanics::energy_function() {
  Motion motion = base_;
  displace(motion.v, state_.v, first);
  const Jet value = energy_at(lagrangian, motion);
  return value.coefficient(first) - value.real();
}

cl_R Mechanics::energy_magnitude() {
  return cln::abs(energy_function()) + energy_at(potential_magnitude, base_).real();
}

cl_R rotation_terms(Mechanics& at, const Direction& w, const Direction& y) {
  const Direction& v = at.state().v;
  return at.cross_mass(w, v, y) + at.cross_mass(w, y, v) - at.cross_mass(y, v, w);
}

cl_R velocity_force(Mechanics& at, const Direction& w) {
  const Direction& v = at.state().v;
  return at.mass_gradient(v, w, v) - at.mass_gradient(w, v, v) / 2 + at.cross_mass(w, v, v);
}

cl_R coriolis(Mechanics& at, const Direction& w, const Direction& y) {
  const Direction& v = at.state().v;
  const cl_R christoffel =
      at.mass_gradient(v, w, y) + at.mass_gradient(y, w, v) - at.mass_gradient(w, y, v);
  return (christoffel + rotation_terms(at, w, y)) / 2;
}

cl_R bias(Mechanics& at, const Direction& w) {
  return at.inverse_dynamics(w, Direction(at.size(), cl_R(0)));
}

cl_R inverse_dynamics(Mechanics& at, const Direction& w) {
  return at.inverse_dynamics(w, at.state().a);
}

cl_R drift(Mechanics& at, const Direction& w) {
  return bias(at, w) - velocity_force(at, w) - at.gravity(w) - at.dissipation_force(w) +
         at.applied_force(w);
}

}  // namespace elgen::oracle
