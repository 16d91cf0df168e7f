// Output values: the definitions of the output table, one function each.
#include "output_values.hpp"

#include "linear_solve.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;
using Values = std::vector<cl_R>;

Values operator+(Values x, const Values& y) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = x[i] + y[i];
  return x;
}

Values operator-(Values x, const Values& y) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = x[i] - y[i];
  return x;
}

/// entry(e_i) for every unit vector.
template <class Entry>
Values along_units(const Mechanics& at, const Entry& entry) {
  Values values;
  for (std::size_t i = 0; i < at.size(); ++i) values.push_back(entry(at.unit(i)));
  return values;
}

/// entry(e_i, e_j) = entry(e_j, e_i)
template <class Entry>
Values symmetric(std::size_t n, const Entry& entry) {
  Values values(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) values[i * n + j] = values[j * n + i] = entry(i, j);
  }
  return values;
}

Values mass_matrix(Mechanics& at) {
  return symmetric(at.size(),
                   [&](std::size_t i, std::size_t j) { return at.mass(at.unit(i), at.unit(j)); });
}

/// C_ij = 1/2 (dM_ij/dt + R_ij - R_ji) with dM/dt along v and R_ij = d/dq_j (M v)_i
Values coriolis_matrix(Mechanics& at) {
  const std::size_t n = at.size();
  const Direction& v = at.state().v;
  Values c = symmetric(
      n, [&](std::size_t i, std::size_t j) { return at.mass_gradient(v, at.unit(i), at.unit(j)); });
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const cl_R r = at.mass_gradient(at.unit(j), at.unit(i), v);
      c[i * n + j] = c[i * n + j] + r;
      c[j * n + i] = c[j * n + i] - r;
    }
  }
  for (cl_R& entry : c) entry = entry / 2;
  return c;
}

/// w.C v = d/dq (w.M v) v - 1/2 d/dq (v.M v) w
Values velocity_force(Mechanics& at) {
  const Direction& v = at.state().v;
  return along_units(at, [&](const Direction& w) {
    return at.mass_gradient(v, w, v) - at.mass_gradient(w, v, v) / 2;
  });
}

Values gravity(Mechanics& at) {
  return along_units(at, [&](const Direction& w) { return at.gravity(w); });
}

Values dissipation(Mechanics& at) {
  return along_units(at, [&](const Direction& w) { return at.dissipation_force(w); });
}

Values applied_force(Mechanics& at) {
  return along_units(at, [&](const Direction& w) { return at.applied_force(w); });
}

Values inverse_dynamics(Mechanics& at, const Direction& a) {
  return along_units(at, [&](const Direction& w) { return at.inverse_dynamics(w, a); });
}

Values bias(Mechanics& at) { return inverse_dynamics(at, Direction(at.size(), cl_R(0))); }

Values drift(Mechanics& at) {
  return bias(at) - velocity_force(at) - gravity(at) - dissipation(at) + applied_force(at);
}

Values momentum(Mechanics& at) {
  return along_units(at, [&](const Direction& w) { return at.momentum(w); });
}

Values input_matrix(Mechanics& at) {
  Values values;
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (std::size_t k = 0; k < at.state().u.size(); ++k) {
      values.push_back(at.input_force(at.unit(i), k));
    }
  }
  return values;
}

/// M a = B u - bias: a, then the relative pivots.
Values forward_dynamics(Mechanics& at) {
  const Values b = input_matrix(at);
  const Direction& u = at.state().u;
  Values right_side = Values(at.size(), cl_R(0)) - bias(at);
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (std::size_t k = 0; k < u.size(); ++k) {
      right_side[i] = right_side[i] + b[i * u.size() + k] * u[k];
    }
  }
  const Solution solution = solve_symmetric(mass_matrix(at), right_side);
  Values values = solution.x;
  values.insert(values.end(), solution.relative_pivots.begin(), solution.relative_pivots.end());
  return values;
}

std::vector<Root> roots_of(const UserOutput& output, unsigned time_order) {
  std::vector<Root> roots;
  for (const ExpressionId id : output.values) roots.push_back({id, time_order});
  return roots;
}

Values user_value(const Model& model, const UserOutput& output, const State& state) {
  JetFunctions functions;
  const Schedule schedule = make_schedule(model, roots_of(output, 0));
  const Motion motion = motion_of(state);
  const Evaluation at(model, schedule, motion, functions);
  Values values;
  for (const ExpressionId id : output.values) values.push_back(at.value(id).real());
  return values;
}

Values user_jacobian(const Model& model, const UserOutput& output, const State& state) {
  JetFunctions functions;
  const Schedule schedule = make_schedule(model, roots_of(output, 0));
  const std::size_t n = state.q.size();
  Values values(output.values.size() * n);
  for (std::size_t j = 0; j < n; ++j) {
    Motion motion = motion_of(state);
    displace(motion.q, unit_direction(n, j), generator(0));
    const Evaluation at(model, schedule, motion, functions);
    for (std::size_t i = 0; i < output.values.size(); ++i) {
      values[i * n + j] = at.value(output.values[i]).coefficient(generator(0));
    }
  }
  return values;
}

/// d2/dt2 of the value at a = 0
Values user_bias(const Model& model, const UserOutput& output, const State& state) {
  JetFunctions functions;
  const Schedule schedule = make_schedule(model, roots_of(output, 2));
  Motion motion = motion_of(state);
  motion.a.assign(state.q.size(), Jet());
  const Evaluation at(model, schedule, motion, functions);
  Values values;
  for (const ExpressionId id : output.values) values.push_back(at.second_rate(id).real());
  return values;
}

Values mechanical_values(OutputKind kind, Mechanics at) {
  switch (kind) {
    case OutputKind::mass_matrix:
      return mass_matrix(at);
    case OutputKind::coriolis_matrix:
      return coriolis_matrix(at);
    case OutputKind::velocity_force:
      return velocity_force(at);
    case OutputKind::gravity:
      return gravity(at);
    case OutputKind::potential_energy:
      return {at.potential_energy_at_rest()};
    case OutputKind::drift:
      return drift(at);
    case OutputKind::dissipation:
      return dissipation(at);
    case OutputKind::applied_force:
      return applied_force(at);
    case OutputKind::bias:
      return bias(at);
    case OutputKind::momentum:
      return momentum(at);
    case OutputKind::kinetic_energy:
      return {at.kinetic_energy()};
    case OutputKind::total_energy:
      return {at.kinetic_energy() + at.potential_energy()};
    case OutputKind::energy_function:
      return {at.energy_function()};
    case OutputKind::input_matrix:
      return input_matrix(at);
    case OutputKind::inverse_dynamics:
      return inverse_dynamics(at, at.state().a);
    case OutputKind::forward_dynamics:
      return forward_dynamics(at);
    default:
      return {};
  }
}

}  // namespace

Values output_values(const Model& model, const OutputRequest& output, const State& state) {
  switch (output.kind) {
    case OutputKind::user_value:
      return user_value(model, model.outputs[output.user], state);
    case OutputKind::user_jacobian:
      return user_jacobian(model, model.outputs[output.user], state);
    case OutputKind::user_bias:
      return user_bias(model, model.outputs[output.user], state);
    default:
      return mechanical_values(output.kind, Mechanics(model, state));
  }
}

}  // namespace elgen::oracle
