// Values of [[output]]s. Jacobians are directional derivatives by jets; a twist is linear in the
// rates, and its Jacobian contains the coefficients of the rates.
#include "oracle/user_outputs.hpp"

#include <array>

#include "oracle/mechanics.hpp"
#include "oracle/output_values.hpp"
#include "oracle/rotations.hpp"
#include "oracle/solved_dynamics.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;

/// The state as jets; if the output solves for the motion, with the accelerations and multipliers
/// of the dynamics.
Motion make_user_motion(const OutputQuery& query) {
  Motion motion = make_motion(query.state);
  if (!query.user_output().solves_motion) return motion;
  Mechanics at(query.model, query.state);
  const ConstrainedMotion own = constrained_motion(at, constrained_system(at));
  motion.a.assign(own.x.begin(), own.x.end());
  motion.multipliers.assign(own.y.begin(), own.y.end());
  return motion;
}

/// A direction of q (along N), v, a and u.
struct MotionChange {
  Displacement along = {};
  Direction a = {};
  Direction inputs = {};
};

/// The derivative of y along a change. If the output solves for the motion, accelerations and
/// multipliers change with the state.
Values directional_derivatives(const OutputQuery& query, Motion motion,
                               const MotionChange& change) {
  constexpr Generators moving = generator(0);
  displace_position(query.model, motion, change.along.position, moving);
  displace(motion.v, change.along.velocity, moving);
  displace(motion.a, change.a, moving);
  displace(motion.u, change.inputs, moving);
  if (query.user_output().solves_motion) {
    Mechanics at(query.model, query.state);
    const ConstrainedMotion own = motion_slope(at, change.along, change.inputs);
    displace(motion.a, own.x, moving);
    displace(motion.multipliers, own.y, moving);
  }
  Evaluation at(query.model, motion);
  Values values;
  for (const ExpressionId id : query.differentiated_values()) {
    values.push_back(at.value(id).coefficient(moving));
  }
  return values;
}

/// The derivatives of y along each unit vector of one member of MotionChange, row-major.
Values derivatives_by_member(const OutputQuery& query, std::size_t count,
                             Direction& (*member)(MotionChange&)) {
  const std::size_t n = query.state.v.size();
  const MotionChange still{
      {Direction(n), Direction(n)}, Direction(n), Direction(query.state.u.size())};
  const Motion motion = make_user_motion(query);
  Values values(query.differentiated_values().size() * count);
  for (std::size_t j = 0; j < count; ++j) {
    MotionChange change = still;
    member(change)[j] = 1;
    const Values column = directional_derivatives(query, motion, change);
    for (std::size_t i = 0; i < column.size(); ++i) values[i * count + j] = column[i];
  }
  return values;
}

Direction& position_of(MotionChange& change) { return change.along.position; }
Direction& velocity_of(MotionChange& change) { return change.along.velocity; }
Direction& acceleration_of(MotionChange& change) { return change.a; }
Direction& inputs_of(MotionChange& change) { return change.inputs; }

/// One field of the derivatives: dy/dq along N, dy/dv, dy/da or dy/du. dy/da is empty if the output
/// solves for the motion, because a is then no argument.
Values user_output_derivative(const OutputQuery& query, std::size_t field) {
  constexpr std::size_t acceleration = 2;
  constexpr std::array parts{position_of, velocity_of, acceleration_of, inputs_of};
  if (field == acceleration && query.user_output().solves_motion) return {};
  const bool is_by_input = field + 1 == parts.size();
  return derivatives_by_member(query, is_by_input ? query.state.u.size() : query.state.v.size(),
                               parts.at(field));
}

/// The fields of user_operational_dynamics().
std::array<Values, 4> operational_fields(const OutputQuery& query) {
  Mechanics at(query.model, query.state);
  const std::size_t n = at.size();
  const Values jacobian = user_output_jacobian(query);
  const Values bias_of_task = user_output_bias(query);
  const std::size_t k = bias_of_task.size();
  const Values mass = at.mass_matrix();
  Values forces;
  for (std::size_t i = 0; i < n; ++i) forces.push_back(bias(at, at.unit(i)));
  std::vector<Values> responses;  // columns of M^-1 J^T, then M^-1 bias
  for (std::size_t j = 0; j <= k; ++j) {
    const auto begin = jacobian.begin() + static_cast<std::ptrdiff_t>(j * n);
    const Values right = j == k ? forces : Values(begin, begin + static_cast<std::ptrdiff_t>(n));
    responses.push_back(solve_mass(query.model, mass, right).x);
  }
  const auto along = [&](std::size_t i, const Values& response) {
    cl_R sum = 0;
    for (std::size_t l = 0; l < n; ++l) sum = sum + jacobian[i * n + l] * response[l];
    return sum;
  };
  Values mobility(k * k);
  Values acceleration(k);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) mobility[i * k + j] = along(i, responses[j]);
    acceleration[i] = along(i, responses[k]) - bias_of_task[i];
  }
  std::array<Values, 4> fields{Values(k * k), Values(n * k)};
  for (std::size_t j = 0; j < k; ++j) {
    const Values column = solve_symmetric(mobility, unit_direction(k, j)).x;
    for (std::size_t i = 0; i < k; ++i) fields[0][i * k + j] = column[i];
    for (std::size_t l = 0; l < n * k; ++l) {
      cl_R& entry = fields[1][l / k * k + j];
      entry = entry + responses[l % k][l / k] * column[l % k];
    }
  }
  SymmetricSolution solution = solve_symmetric(mobility, acceleration);
  fields[2] = std::move(solution.x);
  fields[3] = std::move(solution.relative_pivots);
  return fields;
}

Values concatenate_fields(const std::array<Values, 4>& fields) {
  Values all;
  for (const Values& field : fields) all.insert(all.end(), field.begin(), field.end());
  return all;
}

}  // namespace

Values user_output_values(const OutputQuery& query) {
  const Motion motion = make_user_motion(query);
  Evaluation at(query.model, motion);
  Values values;
  for (const ExpressionId id : query.user_output().values) values.push_back(at.value(id).real());
  return values;
}

Values user_output_jacobian(const OutputQuery& query) {
  return derivatives_by_member(query, query.state.v.size(),
                               query.is_twist() ? velocity_of : position_of);
}

Values user_output_bias(const OutputQuery& query) {
  Motion motion = make_motion(query.state);
  motion.a.assign(query.state.v.size(), Jet());
  Evaluation at(query.model, motion);
  Values values;
  for (const ExpressionId id : query.differentiated_values()) {
    values.push_back((query.is_twist() ? at.rate(id) : at.second_rate(id)).real());
  }
  return values;
}

Values user_output_derivatives(const OutputQuery& query) {
  return concatenate_fields({user_output_derivative(query, 0), user_output_derivative(query, 1),
                             user_output_derivative(query, 2), user_output_derivative(query, 3)});
}

Values user_operational_dynamics(const OutputQuery& query) {
  return concatenate_fields(operational_fields(query));
}

}  // namespace elgen::oracle
