// Mechanics: each quantity is the coefficient of its generators in one evaluation of an energy.
#include "oracle/mechanics.hpp"

#include "oracle/rotations.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;

constexpr Generators first = generator(0);
constexpr Generators second = generator(1);
constexpr Generators third = generator(2);

std::vector<Root> force_roots(const Model& model) {
  std::vector<Root> roots;
  const auto append_point = [&](std::uint32_t point) {
    for (const ExpressionId id : model.points[point].at) roots.push_back({id, 0});
  };
  for (const Force& force : model.forces) {
    for (const ExpressionId id : force.value) roots.push_back({id, 0});
    for (const ExpressionId id : force.reaction) roots.push_back({id, 0});
    if (force.at) append_point(*force.at);
    if (force.from) append_point(*force.from);
  }
  return roots;
}

/// Spins of the frames that torques act on.
std::vector<Root> spin_roots(const Model& model) {
  std::vector<Root> roots;
  const auto append_frame = [&](std::optional<std::uint32_t> frame) {
    if (!frame) return;
    for (const ExpressionId id : model.frames[*frame].spin) roots.push_back({id, 0});
  };
  for (const Force& force : model.forces) {
    append_frame(force.frame);
    append_frame(force.from_frame);
  }
  return roots;
}

std::vector<Jet> jets(const std::vector<cl_R>& reals) { return {reals.begin(), reals.end()}; }

}  // namespace

Direction unit_direction(std::size_t n, std::size_t i) {
  Direction direction(n, cl_R(0));
  direction[i] = 1;
  return direction;
}

Motion motion_of(const State& state) {
  return map_leaves([](const cl_R& value) { return Jet(value); }, state);
}

void displace(std::vector<Jet>& quantity, const Direction& direction, Generators generators) {
  for (std::size_t i = 0; i < quantity.size(); ++i) {
    quantity[i] = quantity[i] + Jet(generators, direction[i]);
  }
}

void displace_position(const Model& model, Motion& motion, const Direction& direction,
                       Generators generators) {
  const std::vector<Jet> rates = coordinate_rates(model, motion.q, jets(direction));
  for (std::size_t i = 0; i < rates.size(); ++i) {
    motion.q[i] = motion.q[i] + rates[i] * Jet(generators, 1);
  }
}

Mechanics::Mechanics(const Model& model, const State& state)
    : model_(model),
      state_(state),
      point_(expansion_point(model, state)),
      base_(motion_of(state)),
      lagrangian_(make_schedule(model, lagrangian_roots(model))),
      potential_(make_schedule(model, potential_roots(model))),
      dissipation_(make_schedule(model, dissipation_roots(model))),
      forces_(make_schedule(model, force_roots(model))),
      spins_(make_schedule(model, spin_roots(model))) {
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
  return quantity(towards(*point_, motion, order)).ungraded();
}

Jet Mechanics::lagrangian_at(const Motion& motion) {
  return expanded(energy_order(), motion, [this](const Motion& at) {
    return lagrangian(model_, Evaluation(model_, lagrangian_, at, functions_), at);
  });
}

Jet Mechanics::kinetic_energy_at(const Motion& motion) {
  return expanded(energy_order(), motion, [this](const Motion& at) {
    return oracle::kinetic_energy(model_, Evaluation(model_, lagrangian_, at, functions_), at);
  });
}

Jet Mechanics::potential_at(const Motion& motion) {
  if (model_.energies.L) return -lagrangian_at(motion);
  return expanded(energy_order(), motion, [this](const Motion& at) {
    return oracle::potential_energy(model_, Evaluation(model_, potential_, at, functions_));
  });
}

Jet Mechanics::dissipation_at(const Motion& motion) {
  return expanded(energy_order(), motion, [this](const Motion& at) {
    return dissipation(model_, Evaluation(model_, dissipation_, at, functions_));
  });
}

/// Coefficient of e0 e1 in L(q, v + w e0 + y e1). Where L is quadratic M has no v in it, and rest
/// is cheaper.
cl_R Mechanics::mass(const Direction& w, const Direction& y) {
  Motion motion = model_.quadratic ? at_rest() : base_;
  displace(motion.v, w, first);
  displace(motion.v, y, second);
  return lagrangian_at(motion).coefficient(first | second);
}

cl_R Mechanics::turned_mass(const Direction& w, const Direction& by, const Direction& y) {
  return model_.rotations.empty() ? 0 : mass(turned(model_, w, by), y);
}

/// Coefficient of e0 e1 e2 in L(q + x e2, w e0 + y e1).
cl_R Mechanics::mass_gradient(const Direction& x, const Direction& w, const Direction& y) {
  Motion motion = at_rest();
  displace(motion.v, w, first);
  displace(motion.v, y, second);
  displace_position(model_, motion, x, third);
  return lagrangian_at(motion).coefficient(first | second | third);
}

cl_R Mechanics::momentum(const Direction& w) {
  Motion motion = base_;
  displace(motion.v, w, first);
  return lagrangian_at(motion).coefficient(first);
}

/// d/dt (w.dL/dv) is the coefficient of e0 e1 in L(q + dq/dt e1, v + a e1 + w e0, t + e1).
Jet Mechanics::residual(const Motion& at, const Direction& w, const Direction& a) {
  Motion moving = at;
  const std::vector<Jet> rates = coordinate_rates(model_, at.q, at.v);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    moving.q[i] = moving.q[i] + rates[i] * Jet(second, 1);
  }
  displace(moving.v, a, second);
  displace(moving.v, w, first);
  moving.t = moving.t + Jet(second, 1);
  Motion displaced = at;
  displace_position(model_, displaced, w, first);
  Motion resisted = at;
  displace(resisted.v, w, first);
  Jet sum = lagrangian_at(moving).tangent(first).tangent(second) -
            lagrangian_at(displaced).tangent(first) + dissipation_at(resisted).tangent(first) -
            force_along(at, w);
  if (model_.rotations.empty()) return sum;
  Motion turning = at;
  const std::vector<Jet> across = turned(model_, jets(w), at.v);
  for (std::size_t i = 0; i < across.size(); ++i) {
    turning.v[i] = turning.v[i] + across[i] * Jet(first, 1);
  }
  return sum + lagrangian_at(turning).tangent(first);
}

cl_R Mechanics::inverse_dynamics(const Direction& w, const Direction& a) {
  return residual(base_, w, a).real();
}

Direction Mechanics::across_velocity(const Direction& d) const {
  return turned(model_, state_.v, d);
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
  return dissipation_at(motion).coefficient(first);
}

/// Of what is small to the order of the equations, of all else to one more.
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

/// sum Q_i w_i + sum F.(dp/dq w), where e0 displaces along w.
Jet Mechanics::exact_force_along(const Motion& motion, const Direction& w) {
  Motion displaced = motion;
  displace_position(model_, displaced, w, first);
  const Evaluation at(model_, forces_, displaced, functions_);
  const auto work = [&](const Force& force, std::uint32_t point) {
    Jet sum;
    for (std::size_t c = 0; c < force.value.size(); ++c) {
      const Jet displacement = at.value(model_.points[point].at[c]).tangent(first);
      sum = sum + at.value(force.value[c]).without(first) * displacement;
    }
    return sum;
  };
  // The spin is linear in the rates, so at the rates w it is the rotation per displacement.
  Motion turning = motion;
  for (std::size_t i = 0; i < turning.v.size(); ++i) turning.v[i] = Jet(first, w[i]);
  const Evaluation spinning(model_, spins_, turning, functions_);
  const auto turn = [&](const Force& force) {
    Jet work_of_torque;
    const auto add = [&](std::uint32_t frame, const std::vector<ExpressionId>& torque, int sign) {
      for (std::size_t c = 0; c < torque.size(); ++c) {
        const Jet rotation = spinning.value(model_.frames[frame].spin[c]).tangent(first);
        work_of_torque = work_of_torque + Jet(sign) * at.value(torque[c]).without(first) * rotation;
      }
    };
    add(*force.frame, force.value, 1);
    if (force.from_frame) add(*force.from_frame, force.reaction, -1);
    return work_of_torque;
  };
  Jet sum;
  for (const Force& force : model_.forces) {
    if (force.on) sum = sum + at.value(force.value[0]).without(first) * Jet(w[*force.on]);
    if (force.frame) sum = sum + turn(force);
    if (force.at) sum = sum + work(force, *force.at);
    if (force.from) sum = sum - work(force, *force.from);
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
  if (model_.energies.L) return mass(state_.v, state_.v) / 2;
  return kinetic_energy_at(base_).real();
}

cl_R Mechanics::potential_energy() {
  return model_.energies.L ? potential_energy_at_rest() : potential_at(base_).real();
}

cl_R Mechanics::potential_energy_at_rest() { return potential_at(at_rest()).real(); }

cl_R Mechanics::energy_function() {
  Motion motion = base_;
  displace(motion.v, state_.v, first);
  const Jet value = lagrangian_at(motion);
  return value.coefficient(first) - value.real();
}

cl_R Mechanics::energy_magnitude() {
  const Jet terms = expanded(energy_order(), base_, [this](const Motion& at) {
    return potential_magnitude(model_, Evaluation(model_, potential_, at, functions_));
  });
  return cln::abs(energy_function()) + terms.real();
}

}  // namespace elgen::oracle
