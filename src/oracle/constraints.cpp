// Evaluates constraints by jets, and solves linear systems by elimination of the whole matrix.
#include "oracle/constraints.hpp"

#include <algorithm>
#include <utility>

#include "numbers/echelon.hpp"
#include "oracle/real_functions.hpp"
#include "oracle/solved_dynamics.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;
using Values = std::vector<cl_R>;

constexpr Generators displacement_generator = generator(0);
constexpr Generators slope_generator = generator(1);

Jet constraint_rate(Evaluation& at, const Constraint& constraint) {
  return constraint.is_position ? at.rate(constraint.value) : at.value(constraint.value);
}

Jet constraint_second_rate(Evaluation& at, const Constraint& constraint) {
  return constraint.is_position ? at.second_rate(constraint.value) : at.rate(constraint.value);
}

/// dr/dt + 2 zeta omega r + omega^2 f at the motion's acceleration. The term in f is for position
/// constraints only.
Jet stabilised_acceleration(Evaluation& at, const Constraint& constraint) {
  Jet result = constraint_second_rate(at, constraint);
  if (!constraint.omega) return result;
  const Jet omega = at.value(*constraint.omega);
  const Jet zeta = at.value(*constraint.zeta);
  result = result + Jet(2) * zeta * omega * constraint_rate(at, constraint);
  if (!constraint.is_position) return result;
  return result + omega * omega * at.value(constraint.value);
}

/// `motion`, displaced along w: in position for a position constraint, in velocity for a velocity
/// constraint. The derivative of `constraint` along w is the entry of A w for `constraint`.
Motion displaced_motion(const Model& model, const Constraint& constraint, Motion motion,
                        const Direction& w) {
  if (constraint.is_position) {
    displace_position(model, motion, w, displacement_generator);
  } else {
    displace(motion.v, w, displacement_generator);
  }
  return motion;
}

/// The entry of A w for this constraint, as a jet in the generators that the motion already has.
Jet jacobian_product(const Model& model, const Constraint& constraint, const Motion& motion,
                     const Direction& w) {
  const Motion moved = displaced_motion(model, constraint, motion, w);
  return Evaluation(model, moved).value(constraint.value).tangent(displacement_generator);
}

Direction jacobian_row(const Model& model, const Constraint& constraint, const Motion& motion) {
  const std::size_t n = motion.v.size();
  Direction row;
  for (std::size_t j = 0; j < n; ++j) {
    row.push_back(jacobian_product(model, constraint, motion, unit_direction(n, j)).real());
  }
  return row;
}

/// `quantity` evaluated at a = 0, one value per constraint.
Values values_at_zero_acceleration(const Model& model, const State& state,
                                   Jet (*quantity)(Evaluation& at, const Constraint& constraint)) {
  Motion motion = make_motion(state);
  motion.a.assign(state.v.size(), Jet());
  Evaluation at(model, motion);
  Values values;
  for (const Constraint& constraint : model.constraints) {
    values.push_back(quantity(at, constraint).real());
  }
  return values;
}

Values difference(Values values, const Values& other) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = values[i] - other[i];
  return values;
}

/// The largest absolute coefficient of each row. The last column is the right side and not counted.
Values row_scales(const Values& matrix, std::size_t rows) {
  Values scales;
  for (std::size_t i = 0; i < rows; ++i) {
    cl_R largest = 0;
    for (std::size_t j = 0; j < rows; ++j) {
      largest = cln::max(largest, cln::abs(matrix[i * (rows + 1) + j]));
    }
    scales.push_back(largest);
  }
  return scales;
}

/// Solves a square system whose last column is the right side. Throws OutsideDomain if the system
/// is singular: pivots are compared with `scales`, one scale per row.
Values solve_by_elimination(const Values& matrix, const Values& scales) {
  const std::size_t n = scales.size();
  if (std::ranges::any_of(scales, [](const cl_R& scale) { return cln::zerop(scale); })) {
    throw OutsideDomain("singular constraints");
  }
  LargestPivot<cl_R> field(cln::expt(cl_R(10), -75), 0, scales);
  const Echelon<LargestPivot<cl_R>> echelon(field, matrix, n + 1, n);
  if (echelon.rank() < n) throw OutsideDomain("singular constraints");
  return *echelon.solution();
}

Values multiply(const Values& matrix, const Values& x) {
  Values result(matrix.size() / x.size());
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    result[k / x.size()] = result[k / x.size()] + matrix[k] * x[k % x.size()];
  }
  return result;
}

cl_R dot_product(const Values& x, const Values& y) { return multiply(x, y).front(); }

Values multiply_transposed(const Values& matrix, const Values& y, std::size_t columns) {
  Values result(columns);
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    result[k % columns] = result[k % columns] + matrix[k] * y[k / columns];
  }
  return result;
}

Values column_of(const Values& matrix, std::size_t column, std::size_t columns) {
  Values result;
  for (std::size_t k = column; k < matrix.size(); k += columns) result.push_back(matrix[k]);
  return result;
}

/// `x` with its dependent entries solved from A x = s; its `independent` entries stay unchanged.
Values solve_dependent(const std::vector<std::uint32_t>& independent, const Values& jacobian,
                       const Values& x, const Values& s) {
  const std::size_t n = x.size();
  const std::size_t m = s.size();
  std::vector<std::size_t> dependent;
  Values result(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_given = std::ranges::count(independent, i) > 0;
    is_given ? void(result[i] = x[i]) : dependent.push_back(i);
  }
  const Values of_given = multiply(jacobian, result);
  Values matrix;
  for (std::size_t k = 0; k < m; ++k) {
    for (const std::size_t i : dependent) matrix.push_back(jacobian[k * n + i]);
    matrix.push_back(s[k] - of_given[k]);
  }
  const Values others = solve_by_elimination(matrix, row_scales(matrix, m));
  for (std::size_t k = 0; k < m; ++k) result[dependent[k]] = others[k];
  return result;
}

}  // namespace

Values constraint_residual(const Model& model, const State& state) {
  const Motion motion = make_motion(state);
  Evaluation at(model, motion);
  Values values;
  for (const Constraint& constraint : model.constraints) {
    if (constraint.is_position) values.push_back(at.value(constraint.value).real());
  }
  for (const Constraint& constraint : model.constraints) {
    values.push_back(constraint_rate(at, constraint).real());
  }
  return values;
}

Values constraint_jacobian(const Model& model, const State& state) {
  const Motion motion = make_motion(state);
  Values values;
  for (const Constraint& constraint : model.constraints) {
    const Direction row = jacobian_row(model, constraint, motion);
    values.insert(values.end(), row.begin(), row.end());
  }
  return values;
}

Values constraint_bias(const Model& model, const State& state) {
  return values_at_zero_acceleration(model, state, constraint_second_rate);
}

Values stabilised_bias(const Model& model, const State& state) {
  return values_at_zero_acceleration(model, state, stabilised_acceleration);
}

Values stabilised_slope(const Model& model, const State& state, const Displacement& along,
                        const Direction& a) {
  Motion motion = make_motion(state);
  motion.a.assign(a.begin(), a.end());
  displace_position(model, motion, along.position, slope_generator);
  displace(motion.v, along.velocity, slope_generator);
  Evaluation at(model, motion);
  Values values;
  for (const Constraint& constraint : model.constraints) {
    values.push_back(stabilised_acceleration(at, constraint).coefficient(slope_generator));
  }
  return values;
}

cl_R constraint_force_slope(const Model& model, const State& state, const Direction& w,
                            const Direction& x, const Values& multipliers) {
  Motion motion = make_motion(state);
  displace_position(model, motion, x, slope_generator);
  cl_R sum = 0;
  for (std::size_t k = 0; k < multipliers.size(); ++k) {
    const Jet row = jacobian_product(model, model.constraints[k], motion, w);
    sum = sum + multipliers[k] * row.coefficient(slope_generator);
  }
  return sum;
}

ConstrainedMotion solve_constrained(const ConstrainedSystem& system, const Values& r,
                                    const Values& s) {
  const std::size_t n = r.size();
  const std::size_t m = s.size();
  const std::size_t columns = n + m + 1;
  Values matrix((n + m) * columns);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) matrix[i * columns + j] = system.mass[i * n + j];
    for (std::size_t k = 0; k < m; ++k) {
      matrix[i * columns + n + k] = system.jacobian[k * n + i];
      matrix[(n + k) * columns + i] = system.jacobian[k * n + i];
    }
    matrix[i * columns + n + m] = r[i];
  }
  for (std::size_t k = 0; k < m; ++k) matrix[(n + k) * columns + n + m] = s[k];
  const Values scales = row_scales(matrix, n + m);
  const Values all = solve_by_elimination(matrix, scales);
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(n);
  return {{all.begin(), middle}, negate({middle, all.end()})};
}

Values constraint_pivots(const Model& model, const ConstrainedSystem& system) {
  const std::size_t m = model.constraints.size();
  const std::size_t n = model.velocities.size();
  Values matrix;
  for (std::size_t i = 0; i < m; ++i) {
    const auto begin = system.jacobian.begin() + static_cast<std::ptrdiff_t>(i * n);
    const Values row(begin, begin + static_cast<std::ptrdiff_t>(n));
    const Values column = multiply(system.jacobian, solve_mass(model, system.mass, row).x);
    matrix.insert(matrix.end(), column.begin(), column.end());
  }
  return solve_symmetric(std::move(matrix), Values(m)).relative_pivots;
}

ConstrainedSystem constrained_system(Mechanics& at) {
  return {at.mass_matrix(), constraint_jacobian(at.model(), at.state())};
}

ConstrainedMotion solve_response(Mechanics& at, const ConstrainedSystem& system, const Values& r,
                                 const Values& s) {
  if (s.empty()) return {solve_mass(at.model(), system.mass, r).x, {}};
  return solve_constrained(system, r, s);
}

ConstrainedMotion constrained_motion(Mechanics& at, const ConstrainedSystem& system) {
  return solve_response(at, system, net_forces(at),
                        negate(stabilised_bias(at.model(), at.state())));
}

LinearisedConstraints linearise_positions(const Model& model, const State& state) {
  const Motion motion = make_motion(state);
  Evaluation at(model, motion);
  LinearisedConstraints shortage;
  for (const Constraint& constraint : model.constraints) {
    if (!constraint.is_position) continue;
    shortage.rows.push_back(jacobian_row(model, constraint, motion));
    shortage.right_side.push_back(-at.value(constraint.value).real());
  }
  return shortage;
}

LinearisedConstraints linearise_rates(const Model& model, const State& state) {
  const Motion motion = make_motion(state);
  Evaluation at(model, motion);
  LinearisedConstraints shortage;
  for (const Constraint& constraint : model.constraints) {
    shortage.rows.push_back(jacobian_row(model, constraint, motion));
    shortage.right_side.push_back(-constraint_rate(at, constraint).real());
  }
  return shortage;
}

Direction least_energy_correction(const Model& model, const State& state,
                                  const LinearisedConstraints& constraints,
                                  const std::vector<bool>& fixed) {
  const Values still(state.v.size());
  if (constraints.rows.empty()) return still;
  Mechanics at(model, state);
  ConstrainedSystem system{at.mass_matrix(), {}};
  for (const Direction& row : constraints.rows) {
    system.jacobian.insert(system.jacobian.end(), row.begin(), row.end());
  }
  const std::size_t n = fixed.size();
  for (std::size_t k = 0; k < system.jacobian.size() && n > 0; ++k) {
    if (fixed[k % n]) system.jacobian[k] = 0;
  }
  for (std::size_t k = 0; k < n * n; ++k) {
    if (fixed[k / n] || fixed[k % n]) system.mass[k] = k / n == k % n ? 1 : 0;
  }
  return solve_constrained(system, still, constraints.right_side).x;
}

State displaced_state(const Model& model, State state, const Direction& x) {
  const std::vector<Jet> moving(x.begin(), x.end());
  const std::vector<Jet> rates = coordinate_rates(model, make_motion(state).q, moving);
  for (std::size_t i = 0; i < rates.size(); ++i) state.q[i] = state.q[i] + rates[i].real();
  state.q = normalize_quaternions(model, std::move(state.q));
  return state;
}

Values project_state(const Model& model, const State& state) {
  const Direction dq = least_energy_correction(model, state, linearise_positions(model, state));
  const State moved = displaced_state(model, state, dq);
  const Direction dv = least_energy_correction(model, moved, linearise_rates(model, moved));
  Values values = moved.q;
  for (std::size_t i = 0; i < dv.size(); ++i) values.push_back(state.v[i] + dv[i]);
  return values;
}

Values complete_motion(const Model& model, const std::vector<std::uint32_t>& independent,
                       const State& state) {
  const Values jacobian = constraint_jacobian(model, state);
  State moving = state;
  moving.v.assign(state.v.size(), cl_R(0));
  const LinearisedConstraints at_rest = linearise_rates(model, moving);  // r is affine in v
  moving.v = solve_dependent(independent, jacobian, state.v, at_rest.right_side);
  const Values bias = negate(constraint_bias(model, moving));
  Values values = moving.v;
  const Values accelerations = solve_dependent(independent, jacobian, state.a, bias);
  values.insert(values.end(), accelerations.begin(), accelerations.end());
  return values;
}

/// Inputs u, multipliers and residual. u minimises |P (tau - B u)| in the M^-1 norm. P projects a
/// force r onto the motions with A x = 0: P r = M x, M x = r + A^T y, A x = 0. The normal equations
/// are B^T x = 0 for r = tau - B u.
Values constrained_inverse_dynamics(const Model& model, const State& state) {
  Mechanics at(model, state);
  const ConstrainedSystem system = constrained_system(at);
  const std::size_t n = state.v.size();
  const std::size_t inputs = state.u.size();
  const Values still(model.constraints.size());
  const Values b = input_matrix_entries(at);
  Values force;
  for (std::size_t i = 0; i < n; ++i) force.push_back(inverse_dynamics(at, at.unit(i)));
  const Values answer = solve_constrained(system, force, still).x;
  Values matrix(inputs * (inputs + 1));
  Values free;  // scales of the pivots: the diagonal of B^T M^-1 B, which ignores A
  for (std::size_t j = 0; j <= inputs; ++j) {
    const Values response =
        j == inputs ? answer : solve_constrained(system, column_of(b, j, inputs), still).x;
    const Values column = multiply_transposed(b, response, inputs);
    for (std::size_t i = 0; i < inputs; ++i) matrix[i * (inputs + 1) + j] = column[i];
    if (j == inputs) continue;
    const Values force_of_input = column_of(b, j, inputs);
    free.push_back(dot_product(force_of_input, solve_mass(model, system.mass, force_of_input).x));
  }
  Values values = solve_by_elimination(matrix, free);
  const Values rest = difference(force, multiply(b, values));
  const Values multipliers = negate(solve_constrained(system, rest, still).y);
  const Values unbalanced = difference(rest, multiply_transposed(system.jacobian, multipliers, n));
  values.insert(values.end(), multipliers.begin(), multipliers.end());
  values.insert(values.end(), unbalanced.begin(), unbalanced.end());
  return values;
}

}  // namespace elgen::oracle
