// Mechanics: each quantity is the coefficient of some generators in one evaluation of an energy.
// Expressions of the model give the expansion point, towards which motions are scaled.
#include "oracle/mechanics.hpp"

#include <algorithm>

#include "oracle/real_functions.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;

constexpr Generators first_generator = generator(0);
constexpr Generators second_generator = generator(1);
constexpr Generators third_generator = generator(2);

std::vector<Jet> to_jets(const std::vector<cl_R>& reals) { return {reals.begin(), reals.end()}; }

using OptionalValues = std::vector<std::optional<cl_R>>;

void scale_about(std::vector<Jet>& quantity, const OptionalValues& about, const Jet& s) {
  for (std::size_t i = 0; i < quantity.size(); ++i) {
    if (about[i]) quantity[i] = Jet(*about[i]) + s * (quantity[i] - Jet(*about[i]));
  }
}

/// The values of `expressions` at the parameters of `state`; none for an absent expression.
OptionalValues evaluate_optional(const Model& model,
                                 const std::vector<std::optional<ExpressionId>>& expressions,
                                 const State& state) {
  const Motion motion = make_motion(state);
  Evaluation at(model, motion);
  OptionalValues values;
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

State shorten_rationals(const State& state) {
  return map_leaves([](const cl_R& value) { return shorten_rationals(value, max_leaf_bits); },
                    state);
}

Motion make_motion(const State& state) {
  return map_leaves([](const cl_R& value) { return Jet(value); }, shorten_rationals(state));
}

std::optional<ExpansionPoint> expansion_point(const Model& model, const State& state) {
  if (!model.approximation) return std::nullopt;
  const Approximation& approximation = *model.approximation;
  ExpansionPoint point;
  point.order = approximation.order;
  point.q = evaluate_optional(model, approximation.coordinates, state);
  point.u = evaluate_optional(model, approximation.inputs, state);
  point.v.resize(model.velocities.size());
  for (std::size_t i = 0; i < point.q.size(); ++i) {
    if (!approximation.small[i]) point.q[i].reset();
    if (approximation.small[i]) point.v[model.coordinates[i].velocity] = cl_R(0);
  }
  const bool small_inputs = approximation.has_small_inputs;
  for (std::optional<cl_R>& value : point.u) {
    if (!small_inputs) value.reset();
    if (small_inputs && !value) value = cl_R(0);
  }
  return point;
}

Motion scale_towards(const ExpansionPoint& point, const Motion& motion, unsigned order) {
  const Jet s(graded_symbol(order), 1);
  Motion result = motion;
  scale_about(result.q, point.q, s);
  scale_about(result.v, point.v, s);
  scale_about(result.a, point.v, s);
  scale_about(result.u, point.u, s);
  return result;
}

Mechanics::Mechanics(const Model& model, const State& state, std::size_t evaluations)
    : model_(model),
      state_(shorten_rationals(state)),
      expansion_point_(expansion_point(model, state_)),
      base_(make_motion(state_)),
      evaluations_(model, evaluations) {
  base_.a.assign(model.velocities.size(), Jet());
  base_.u.assign(model.inputs.size(), Jet());
}

Motion Mechanics::motion_at_rest() const {
  Motion motion = base_;
  motion.v.assign(size(), Jet());
  return motion;
}

template <class Quantity>
Jet Mechanics::evaluate_expanded(unsigned order, const Motion& motion,
                                 const Quantity& quantity) const {
  if (!expansion_point_) return quantity(motion);
  return quantity(scale_towards(*expansion_point_, motion, order)).sum_grades();
}

Jet Mechanics::energy_at(EnergyFunction energy, const Motion& motion) {
  return evaluate_expanded(expansion_point_ ? expansion_point_->order + 1 : 0, motion,
                           [&](const Motion& moved) { return energy(evaluations_.at(moved)); });
}

Jet Mechanics::potential_at(const Motion& motion) {
  return has_combined_lagrangian(model_) ? -energy_at(lagrangian, motion)
                                         : energy_at(oracle::potential_energy, motion);
}

/// Coefficient of e0 e1 in L(q, v + w e0 + y e1). If L is quadratic, M does not depend on v, and
/// evaluation at rest is cheaper.
cl_R Mechanics::mass_product(const Direction& w, const Direction& y) {
  Motion motion = model_.is_quadratic ? motion_at_rest() : base_;
  displace(motion.v, w, first_generator);
  displace(motion.v, y, second_generator);
  return energy_at(lagrangian, motion).coefficient(first_generator | second_generator);
}

/// M_ij is the coefficient of e_i g_j in L(q, v + sum e_i w_i + sum g_j y_j), with unit vectors
/// w_i, y_j. If L is quadratic, one evaluation with six generators gives nine entries. Otherwise
/// each evaluation gives one entry, because functions of jets in six generators would cost more.
std::vector<cl_R> Mechanics::mass_matrix() {
  const std::size_t n = size();
  const std::size_t block = model_.is_quadratic ? 3 : 1;
  const auto first_of = [](std::size_t i) { return generator(static_cast<unsigned>(i)); };
  const auto second_of = [](std::size_t j) { return generator(static_cast<unsigned>(3 + j)); };
  std::vector<cl_R> values(n * n);
  for (std::size_t row = 0; row < n; row += block) {
    const std::size_t rows = std::min(block, n - row);
    for (std::size_t column = 0; column <= row; column += block) {
      const std::size_t columns = std::min(block, n - column);
      Motion motion = model_.is_quadratic ? motion_at_rest() : base_;
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

cl_R Mechanics::cross_mass_product(const Direction& w, const Direction& by, const Direction& y) {
  return model_.rotations.empty() ? 0 : mass_product(cross_on_rotations(model_, w, by), y);
}

/// Coefficient of e0 e1 e2 in L(q + x e2, w e0 + y e1).
cl_R Mechanics::mass_gradient(const Direction& x, const Direction& w, const Direction& y) {
  Motion motion = motion_at_rest();
  displace(motion.v, w, first_generator);
  displace(motion.v, y, second_generator);
  displace_position(model_, motion, x, third_generator);
  return energy_at(lagrangian, motion)
      .coefficient(first_generator | second_generator | third_generator);
}

cl_R Mechanics::momentum(const Direction& w) {
  Motion motion = base_;
  displace(motion.v, w, first_generator);
  return energy_at(lagrangian, motion).coefficient(first_generator);
}

/// p_i is the coefficient of e0 in L(v + w_i e0), w_i the i-th unit vector; v.dL/dv is the
/// coefficient of e0 in L(v + v e0).
void Mechanics::set_momenta_and_energy(Motion& motion) {
  motion.momenta.assign(size(), Jet());
  for (std::size_t i = 0; i < size(); ++i) {
    Motion pushed = motion;
    displace(pushed.v, unit(i), first_generator);
    motion.momenta[i] = energy_at(lagrangian, pushed).tangent(first_generator);
  }
  Motion scaled = motion;
  displace(scaled.v, motion.v, first_generator);
  const Jet value = energy_at(lagrangian, scaled);
  motion.E = value.tangent(first_generator) - value.without(first_generator);
}

cl_R Mechanics::position_gradient(const Direction& w) {
  Motion motion = base_;
  displace_position(model_, motion, w, first_generator);
  return energy_at(lagrangian, motion).coefficient(first_generator);
}

/// d/dt (w.dL/dv) is the coefficient of e0 e1 in L(q + dq/dt e1, v + a e1 + w e0, t + e1).
Jet Mechanics::residual(const Motion& at, const Direction& w, const Direction& a) {
  Motion moving = at;
  advance_time(model_, moving, a, second_generator);
  displace(moving.v, w, first_generator);
  Motion displaced = at;
  displace_position(model_, displaced, w, first_generator);
  const Jet momentum_rate =
      energy_at(lagrangian, moving).tangent(first_generator).tangent(second_generator);
  const Jet gradient = energy_at(lagrangian, displaced).tangent(first_generator);
  const Jet force = force_along(at, w);  // shares the evaluation at `displaced`
  const Jet sum = momentum_rate - gradient + friction_along(at, w) - force;
  if (model_.rotations.empty()) return sum;
  Motion turning = at;
  displace(turning.v, cross_on_rotations(model_, to_jets(w), at.v), first_generator);
  return sum + energy_at(lagrangian, turning).tangent(first_generator);
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
  at.u = to_jets(inputs);
  displace_position(model_, at, along.position, third_generator);
  displace(at.v, along.velocity, third_generator);
  return residual(at, w, a).coefficient(third_generator);
}

cl_R Mechanics::gravity(const Direction& w) {
  Motion motion = motion_at_rest();
  displace_position(model_, motion, w, first_generator);
  return potential_at(motion).coefficient(first_generator);
}

/// w.dD/dv
Jet Mechanics::friction_along(const Motion& motion, const Direction& w) {
  if (!model_.energies.D) return {};
  Motion resisted = motion;
  displace(resisted.v, w, first_generator);
  return energy_at(dissipation, resisted).tangent(first_generator);
}

cl_R Mechanics::dissipation_force(const Direction& w) { return friction_along(base_, w).real(); }

/// If no expansion point exists, exact_force_along(). Otherwise the force, expanded to the order of
/// the equations along small coordinates, and to one order more along all others.
Jet Mechanics::force_along(const Motion& motion, const Direction& w) {
  if (!expansion_point_) return exact_force_along(motion, w);
  Direction small = w;
  Direction others = w;
  for (std::size_t i = 0; i < w.size(); ++i) (expansion_point_->v[i] ? others : small)[i] = 0;
  const auto along = [&](unsigned order, const Direction& part) {
    return evaluate_expanded(order, motion,
                             [&](const Motion& at) { return exact_force_along(at, part); });
  };
  return along(expansion_point_->order, small) + along(expansion_point_->order + 1, others);
}

/// w.(Q + B u), exact in all leaves.
Jet Mechanics::exact_force_along(const Motion& motion, const Direction& w) {
  Jet sum;
  if (!model_.forces.empty()) sum = work_of_forces(motion, w);
  for (std::size_t k = 0; k < model_.inputs.size(); ++k) {
    if (model_.inputs[k].velocity) sum = sum + motion.u[k] * Jet(w[*model_.inputs[k].velocity]);
  }
  return sum;
}

/// sum Q_i w_i + sum F.(dp/dq w) + sum N.turn. The displacement along w is in generator e0; turn is
/// the rotation of the frame by this displacement.
Jet Mechanics::work_of_forces(const Motion& motion, const Direction& w) {
  Motion displaced = motion;
  displace_position(model_, displaced, w, first_generator);
  Evaluation& moving = evaluations_.at(displaced);
  // The spin is linear in the rates, so the spin at the rates w is the rotation along w.
  Motion turned = motion;
  for (std::size_t i = 0; i < turned.v.size(); ++i) turned.v[i] = Jet(first_generator, w[i]);
  Evaluation& turning = evaluations_.at(turned);
  const auto work = [&](Evaluation& at, const auto& place, const std::vector<ExpressionId>& force) {
    Jet sum;
    for (std::size_t c = 0; c < force.size(); ++c) {
      const Jet displacement = at.value(place[c]).tangent(first_generator);
      sum = sum + moving.value(force[c]).without(first_generator) * displacement;
    }
    return sum;
  };
  Jet sum;
  for (const Force& f : model_.forces) {
    if (f.velocity)
      sum = sum + moving.value(f.value[0]).without(first_generator) * Jet(w[*f.velocity]);
    if (f.frame) sum = sum + work(turning, model_.frames[*f.frame].spin, f.value);
    if (f.reaction_frame)
      sum = sum - work(turning, model_.frames[*f.reaction_frame].spin, f.reaction);
    if (f.point) sum = sum + work(moving, model_.points[*f.point].position, f.value);
    if (f.reaction_point)
      sum = sum - work(moving, model_.points[*f.reaction_point].position, f.value);
  }
  return sum;
}

cl_R Mechanics::applied_force(const Direction& w) { return force_along(base_, w).real(); }

cl_R Mechanics::input_force(const Direction& w, const Direction& y) {
  Motion motion = base_;
  displace(motion.u, y, second_generator);
  return force_along(motion, w).coefficient(second_generator);
}

cl_R Mechanics::kinetic_energy() {
  if (has_combined_lagrangian(model_)) return mass_product(state_.v, state_.v) / 2;
  return energy_at(oracle::kinetic_energy, base_).real();
}

cl_R Mechanics::potential_energy() {
  return has_combined_lagrangian(model_) ? potential_energy_at_rest() : potential_at(base_).real();
}

cl_R Mechanics::potential_energy_at_rest() { return potential_at(motion_at_rest()).real(); }

cl_R Mechanics::energy_function() {
  Motion motion = base_;
  displace(motion.v, state_.v, first_generator);
  const Jet value = energy_at(lagrangian, motion);
  return value.coefficient(first_generator) - value.real();
}

cl_R Mechanics::energy_magnitude() {
  return cln::abs(energy_function()) + energy_at(potential_magnitude, base_).real();
}

cl_R rotation_terms(Mechanics& at, const Direction& w, const Direction& y) {
  const Direction& v = at.state().v;
  return at.cross_mass_product(w, v, y) + at.cross_mass_product(w, y, v) -
         at.cross_mass_product(y, v, w);
}

cl_R velocity_force(Mechanics& at, const Direction& w) {
  const Direction& v = at.state().v;
  return at.mass_gradient(v, w, v) - at.mass_gradient(w, v, v) / 2 + at.cross_mass_product(w, v, v);
}

cl_R coriolis_matrix_product(Mechanics& at, const Direction& w, const Direction& y) {
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
