// Values of [[output]]s: slopes by jets along what the values are made of; a twist is linear in the
// rates, and its Jacobian are its coefficients.
#include "oracle/user_outputs.hpp"

#include <array>
#include <functional>

#include "oracle/mechanics.hpp"
#include "oracle/rotations.hpp"
#include "oracle/solved_dynamics.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;

/// Slopes of expressions along `count` changes of the motion, row-major.
Values slopes_of(const Question& of, const std::vector<ExpressionId>& ids, std::size_t count,
                 const std::function<void(Motion&, std::size_t)>& displaced) {
  Values values(ids.size() * count);
  for (std::size_t j = 0; j < count; ++j) {
    Motion motion = motion_of(of.state);
    displaced(motion, j);
    Evaluation at(of.model, motion);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      values[i * count + j] = at.value(ids[i]).coefficient(generator(0));
    }
  }
  return values;
}

/// By the leaves of one kind.
Values slopes_by(const Question& of, const std::vector<ExpressionId>& ids,
                 std::vector<Jet> Motion::*leaf) {
  const std::size_t count = (motion_of(of.state).*leaf).size();
  return slopes_of(of, ids, count, [leaf, count](Motion& motion, std::size_t j) {
    displace(motion.*leaf, unit_direction(count, j), generator(0));
  });
}

/// By q, along N.
Values slopes_by_position(const Question& of, const std::vector<ExpressionId>& ids) {
  const std::size_t n = of.state.v.size();
  return slopes_of(of, ids, n, [&of, n](Motion& motion, std::size_t j) {
    displace_position(of.model, motion, unit_direction(n, j), generator(0));
  });
}

/// dy/dq along N, dy/dv, dy/da, dy/du.
std::array<Values, 4> derivatives_of_user(const Question& of) {
  const std::vector<ExpressionId>& ids = of.of_user().values;
  return {slopes_by_position(of, ids), slopes_by(of, ids, &Motion::v),
          slopes_by(of, ids, &Motion::a), slopes_by(of, ids, &Motion::u)};
}

/// The fields of the equation of motion along y.
std::array<Values, 4> operational_fields(const Question& of) {
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

Values values_of_user(const Question& of) {
  const Motion motion = motion_of(of.state);
  Evaluation at(of.model, motion);
  Values values;
  for (const ExpressionId id : of.of_user().values) values.push_back(at.value(id).real());
  return values;
}

Values jacobian_of_user(const Question& of) {
  return of.is_twist() ? slopes_by(of, of.differentiated(), &Motion::v)
                       : slopes_by_position(of, of.differentiated());
}

Values bias_of_user(const Question& of) {
  Motion motion = motion_of(of.state);
  motion.a.assign(of.state.v.size(), Jet());
  Evaluation at(of.model, motion);
  Values values;
  for (const ExpressionId id : of.differentiated()) {
    values.push_back((of.is_twist() ? at.rate(id) : at.second_rate(id)).real());
  }
  return values;
}

Values all_derivatives_of_user(const Question& of) { return joined(derivatives_of_user(of)); }

cl_R contracted_derivatives(const Question& of, const Contraction& by) {
  return contracted_entries(derivatives_of_user(of).at(by.field), by);
}

Values operational_of_user(const Question& of) { return joined(operational_fields(of)); }

cl_R contracted_operational(const Question& of, const Contraction& by) {
  return contracted_entries(operational_fields(of).at(by.field), by);
}

}  // namespace elgen::oracle
