// Output values: the definitions of the output table, one function each.
#include "output_values.hpp"

#include "contraction.hpp"
#include "derivatives.hpp"
#include "reaction.hpp"
#include "rotations.hpp"
#include "solved_dynamics.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;
using Values = std::vector<cl_R>;

/// entry(e_i, e_j) = entry(e_j, e_i)
template <class Entry>
Values symmetric(std::size_t n, const Entry& entry) {
  Values values(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) values[i * n + j] = values[j * n + i] = entry(i, j);
  }
  return values;
}

/// C_ij = 1/2 (dM_ij/dt + R_ij - R_ji + turning) with dM/dt along v and R_ij = d/dq_j (M v)_i
Values coriolis_matrix(Mechanics& at) {
  const std::size_t n = at.size();
  const Direction& v = at.state().v;
  Values c = symmetric(
      n, [&](std::size_t i, std::size_t j) { return at.mass_gradient(v, at.unit(i), at.unit(j)); });
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const cl_R r = at.mass_gradient(at.unit(j), at.unit(i), v);
      c[i * n + j] = c[i * n + j] + r + turning(at, at.unit(i), at.unit(j));
      c[j * n + i] = c[j * n + i] - r;
    }
  }
  for (cl_R& entry : c) entry = entry / 2;
  return c;
}

Values column(OutputKind kind, Mechanics& at) {
  Values values;
  for (std::size_t i = 0; i < at.size(); ++i) {
    values.push_back(contracted_column(kind, at, at.unit(i)));
  }
  return values;
}

Values input_matrix(Mechanics& at) {
  const std::size_t inputs = at.state().u.size();
  Values values;
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (std::size_t k = 0; k < inputs; ++k) {
      values.push_back(at.input_force(at.unit(i), unit_direction(inputs, k)));
    }
  }
  return values;
}

/// M a = B u - bias: a, then the relative pivots.
Values forward_dynamics(Mechanics& at) {
  const Solution solution = solved_dynamics(at, mass_matrix_values(at));
  Values values = solution.x;
  values.insert(values.end(), solution.relative_pivots.begin(), solution.relative_pivots.end());
  return values;
}

std::vector<Root> roots_of(const UserOutput& output, unsigned time_order) {
  std::vector<Root> roots;
  for (const ExpressionId id : output.values) roots.push_back({id, time_order});
  return roots;
}

std::vector<Root> twist_roots(const UserOutput& output, unsigned time_order) {
  std::vector<Root> roots;
  for (const ExpressionId id : output.twist) roots.push_back({id, time_order});
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

/// The twist is linear in the rates: its coefficient of each.
Values twist_jacobian(const Model& model, const UserOutput& output, const State& state) {
  JetFunctions functions;
  const Schedule schedule = make_schedule(model, twist_roots(output, 0));
  const std::size_t n = state.v.size();
  Values values(output.twist.size() * n);
  for (std::size_t j = 0; j < n; ++j) {
    Motion motion = motion_of(state);
    displace(motion.v, unit_direction(n, j), generator(0));
    const Evaluation at(model, schedule, motion, functions);
    for (std::size_t i = 0; i < output.twist.size(); ++i) {
      values[i * n + j] = at.value(output.twist[i]).coefficient(generator(0));
    }
  }
  return values;
}

/// d twist/dt at a = 0
Values twist_bias(const Model& model, const UserOutput& output, const State& state) {
  JetFunctions functions;
  const Schedule schedule = make_schedule(model, twist_roots(output, 1));
  Motion motion = motion_of(state);
  motion.a.assign(state.v.size(), Jet());
  const Evaluation at(model, schedule, motion, functions);
  Values values;
  for (const ExpressionId id : output.twist) values.push_back(at.rate(id).real());
  return values;
}

Values user_jacobian(const Model& model, const UserOutput& output, const State& state) {
  JetFunctions functions;
  const Schedule schedule = make_schedule(model, roots_of(output, 0));
  const std::size_t n = state.v.size();
  if (output.frame) return twist_jacobian(model, output, state);
  Values values(output.values.size() * n);
  for (std::size_t j = 0; j < n; ++j) {
    Motion motion = motion_of(state);
    displace_position(model, motion, unit_direction(n, j), generator(0));
    const Evaluation at(model, schedule, motion, functions);
    for (std::size_t i = 0; i < output.values.size(); ++i) {
      values[i * n + j] = at.value(output.values[i]).coefficient(generator(0));
    }
  }
  return values;
}

/// d2/dt2 of the value at a = 0
Values user_bias(const Model& model, const UserOutput& output, const State& state) {
  if (output.frame) return twist_bias(model, output, state);
  JetFunctions functions;
  const Schedule schedule = make_schedule(model, roots_of(output, 2));
  Motion motion = motion_of(state);
  motion.a.assign(state.v.size(), Jet());
  const Evaluation at(model, schedule, motion, functions);
  Values values;
  for (const ExpressionId id : output.values) values.push_back(at.second_rate(id).real());
  return values;
}

Values rates_of_coordinates(const Model& model, const State& state) {
  const Motion motion = motion_of(state);
  Values values;
  for (const Jet& rate : coordinate_rates(model, motion.q, motion.v)) values.push_back(rate.real());
  return values;
}

Values mechanical_values(OutputKind kind, Mechanics at) {
  if (output_row(kind).differentiates) return derivative_values(kind, at);
  if (is_contractible_column(kind)) return column(kind, at);
  switch (kind) {
    case OutputKind::mass_matrix:
      return mass_matrix_values(at);
    case OutputKind::coriolis_matrix:
      return coriolis_matrix(at);
    case OutputKind::input_matrix:
      return input_matrix(at);
    case OutputKind::potential_energy:
      return {at.potential_energy_at_rest()};
    case OutputKind::kinetic_energy:
      return {at.kinetic_energy()};
    case OutputKind::total_energy:
      return {at.kinetic_energy() + at.potential_energy()};
    case OutputKind::energy_function:
      return {at.energy_function()};
    case OutputKind::forward_dynamics:
      return forward_dynamics(at);
    default:
      return {};
  }
}

}  // namespace

Values output_values(const Model& model, const OutputRequest& output, const State& state) {
  switch (output.kind) {
    case OutputKind::coordinate_rates:
      return rates_of_coordinates(model, state);
    case OutputKind::normalized:
      return normalized(model, state.q);
    case OutputKind::reaction:
      return reaction(model, state);
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

cl_R contracted_values(const Model& model, const OutputRequest& output, const State& state,
                       const Contraction& by) {
  if (is_contractible_column(output.kind)) {
    Mechanics at(model, state);
    return contracted_column(output.kind, at, by.w);
  }
  if (is_contractible_matrix(output.kind)) {
    Mechanics at(model, state);
    return contracted_matrix(output.kind, at, by.w, by.y);
  }
  if (output_row(output.kind).differentiates) {
    Mechanics at(model, state);
    return contracted_derivative(output.kind, at, by);
  }
  const Values values = output_values(model, output, state);
  const std::size_t columns = by.y.empty() ? 1 : by.y.size();
  cl_R sum = 0;
  for (std::size_t k = 0; k < by.w.size() * columns; ++k) {
    sum = sum + by.w[k / columns] * values[k] * (by.y.empty() ? cl_R(1) : by.y[k % columns]);
  }
  return sum;
}

}  // namespace elgen::oracle
