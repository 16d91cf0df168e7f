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

/// The state as a motion. If the output uses the motion, the accelerations and multipliers of the
/// dynamics are set.
Motion motion_of_user(const OutputQuery& of) {
  Motion motion = motion_of(of.state);
  if (!of.of_user().motion) return motion;
  Mechanics at(of.model, of.state);
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

/// The derivative of y along a change. If the output uses the motion, accelerations and multipliers
/// change with the state.
Values slopes_along(const OutputQuery& of, Motion motion, const MotionChange& change) {
  constexpr Generators moving = generator(0);
  displace_position(of.model, motion, change.along.x, moving);
  displace(motion.v, change.along.y, moving);
  displace(motion.a, change.a, moving);
  displace(motion.u, change.inputs, moving);
  if (of.of_user().motion) {
    Mechanics at(of.model, of.state);
    const ConstrainedMotion own = motion_slope(at, change.along, change.inputs);
    displace(motion.a, own.x, moving);
    displace(motion.multipliers, own.y, moving);
  }
  Evaluation at(of.model, motion);
  Values values;
  for (const ExpressionId id : of.differentiated()) {
    values.push_back(at.value(id).coefficient(moving));
  }
  return values;
}

/// The derivatives of y along each unit vector of one member of MotionChange, row-major.
Values slopes_by(const OutputQuery& of, std::size_t count, Direction& (*part)(MotionChange&)) {
  const std::size_t n = of.state.v.size();
  const MotionChange still{
      {Direction(n), Direction(n)}, Direction(n), Direction(of.state.u.size())};
  const Motion motion = motion_of_user(of);
  Values values(of.differentiated().size() * count);
  for (std::size_t j = 0; j < count; ++j) {
    MotionChange change = still;
    part(change)[j] = 1;
    const Values column = slopes_along(of, motion, change);
    for (std::size_t i = 0; i < column.size(); ++i) values[i * count + j] = column[i];
  }
  return values;
}

Direction& position_of(MotionChange& change) { return change.along.x; }
Direction& velocity_of(MotionChange& change) { return change.along.y; }
Direction& acceleration_of(MotionChange& change) { return change.a; }
Direction& inputs_of(MotionChange& change) { return change.inputs; }

/// One field of the derivatives: dy/dq along N, dy/dv, dy/da or dy/du. dy/da is empty if the output
/// uses the motion, because a is then no argument.
Values derivative_of_user(const OutputQuery& of, std::size_t field) {
  constexpr std::size_t acceleration = 2;
  constexpr std::array parts{position_of, velocity_of, acceleration_of, inputs_of};
  if (field == acceleration && of.of_user().motion) return {};
  const bool is_by_input = field + 1 == parts.size();
  return slopes_by(of, is_by_input ? of.state.u.size() : of.state.v.size(), parts.at(field));
}

/// The fields of operational_of_user().
std::array<Values, 4> operational_fields(const OutputQuery& of) {
  Mechanics at(of.model, of.state);
  const std::size_t n = at.size();
  const Values jacobian = jacobian_of_user(of);
  const Values bias_of_task = bias_of_user(of);
  const std::size_t k = bias_of_task.size();
  const Values mass = at.mass_matrix();
  Values forces;
  for (std::size_t i = 0; i < n; ++i) forces.push_back(bias(at, at.unit(i)));
  std::vector<Values> responses;  // columns of M^-1 J^T, then M^-1 bias
  for (std::size_t j = 0; j <= k; ++j) {
    const auto begin = jacobian.begin() + static_cast<std::ptrdiff_t>(j * n);
    const Values right = j == k ? forces : Values(begin, begin + static_cast<std::ptrdiff_t>(n));
    responses.push_back(solve_mass(of.model, mass, right).x);
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
  Solution solution = solve_symmetric(mobility, acceleration);
  fields[2] = std::move(solution.x);
  fields[3] = std::move(solution.relative_pivots);
  return fields;
}

Values joined(const std::array<Values, 4>& fields) {
  Values all;
  for (const Values& field : fields) all.insert(all.end(), field.begin(), field.end());
  return all;
}

}  // namespace

cl_R contracted_entries(const Values& values, const Contraction& by) {
  const std::size_t columns = by.y.empty() ? 1 : by.y.size();
  cl_R sum = 0;
  for (std::size_t k = 0; k < by.w.size() * columns; ++k) {
    sum = sum + by.w[k / columns] * values[k] * (by.y.empty() ? cl_R(1) : by.y[k % columns]);
  }
  return sum;
}

Values values_of_user(const OutputQuery& of) {
  const Motion motion = motion_of_user(of);
  Evaluation at(of.model, motion);
  Values values;
  for (const ExpressionId id : of.of_user().values) values.push_back(at.value(id).real());
  return values;
}

Values jacobian_of_user(const OutputQuery& of) {
  return slopes_by(of, of.state.v.size(), of.is_twist() ? velocity_of : position_of);
}

Values bias_of_user(const OutputQuery& of) {
  Motion motion = motion_of(of.state);
  motion.a.assign(of.state.v.size(), Jet());
  Evaluation at(of.model, motion);
  Values values;
  for (const ExpressionId id : of.differentiated()) {
    values.push_back((of.is_twist() ? at.rate(id) : at.second_rate(id)).real());
  }
  return values;
}

Values all_derivatives_of_user(const OutputQuery& of) {
  return joined({derivative_of_user(of, 0), derivative_of_user(of, 1), derivative_of_user(of, 2),
                 derivative_of_user(of, 3)});
}

cl_R contracted_derivatives(const OutputQuery& of, const Contraction& by) {
  return contracted_entries(derivative_of_user(of, by.field), by);
}

Values operational_of_user(const OutputQuery& of) { return joined(operational_fields(of)); }

cl_R contracted_operational(const OutputQuery& of, const Contraction& by) {
  return contracted_entries(operational_fields(of).at(by.field), by);
}

}  // namespace elgen::oracle
