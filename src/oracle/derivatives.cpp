// Derivatives, column by column.
#include "oracle/derivatives.hpp"

#include <algorithm>

#include "oracle/solved_dynamics.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;
using Values = std::vector<cl_R>;

/// Columns of n entries as a row-major matrix.
Values matrix_of(const std::vector<Values>& columns, std::size_t rows) {
  Values values(rows * columns.size());
  for (std::size_t j = 0; j < columns.size(); ++j) {
    for (std::size_t i = 0; i < rows; ++i) values[i * columns.size() + j] = columns[j][i];
  }
  return values;
}

void append(Values& to, const Values& from) { to.insert(to.end(), from.begin(), from.end()); }

/// The state and what the residual is differentiated at.
struct ResidualPoint {
  Mechanics& at;
  Direction a;
  Direction u;
};

/// d(M a + bias - B u) along a displacement.
Values slope(ResidualPoint& point, const Displacement& along) {
  Values result;
  for (std::size_t i = 0; i < point.at.size(); ++i) {
    result.push_back(point.at.residual_slope(point.at.unit(i), along, point.a, point.u));
  }
  return result;
}

Direction rest(const Mechanics& at) { return Direction(at.size(), cl_R(0)); }

Displacement by_position(const Mechanics& at, std::size_t j) { return {at.unit(j), rest(at)}; }
Displacement by_velocity(const Mechanics& at, std::size_t j) { return {rest(at), at.unit(j)}; }

/// The residual's derivatives by q, then by v.
std::array<std::vector<Values>, 2> residual_columns(ResidualPoint& point) {
  std::array<std::vector<Values>, 2> columns;
  for (std::size_t j = 0; j < point.at.size(); ++j) {
    columns[0].push_back(slope(point, by_position(point.at, j)));
    columns[1].push_back(slope(point, by_velocity(point.at, j)));
  }
  return columns;
}

Values negative(Values values) {
  for (cl_R& value : values) value = -value;
  return values;
}

/// Columns of da/dq, da/dv and da/du.
std::array<std::vector<Values>, 3> acceleration_columns(Mechanics& at) {
  const Values mass = mass_matrix_values(at);
  ResidualPoint point{at, solved_dynamics(at, mass).x, at.state().u};
  const auto residual = residual_columns(point);
  std::array<std::vector<Values>, 3> columns;
  for (std::size_t part = 0; part < 2; ++part) {
    for (const Values& column : residual[part]) {
      columns[part].push_back(solve_mass(at.model(), mass, negative(column)).x);
    }
  }
  const std::size_t inputs = at.state().u.size();
  for (std::size_t k = 0; k < inputs; ++k) {
    Values force;
    for (std::size_t i = 0; i < at.size(); ++i) {
      force.push_back(at.input_force(at.unit(i), unit_direction(inputs, k)));
    }
    columns[2].push_back(solve_mass(at.model(), mass, force).x);
  }
  return columns;
}

/// w.(da/dx) along a displacement: z.(-dr) with M z = w.
cl_R along_acceleration(Mechanics& at, const Direction& w, const Displacement& along) {
  const Values mass = mass_matrix_values(at);
  const Direction z = solve_mass(at.model(), mass, w).x;
  return -at.residual_slope(z, along, solved_dynamics(at, mass).x, at.state().u);
}

/// w.(da/du) y: z.B y with M z = w.
cl_R along_inputs(Mechanics& at, const Direction& w, const Direction& y) {
  return at.input_force(solve_mass(at.model(), mass_matrix_values(at), w).x, y);
}

cl_R dot(const Direction& a, const Direction& b) {
  cl_R sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum = sum + a[i] * b[i];
  return sum;
}

bool is_zero(const Direction& d) {
  return std::all_of(d.begin(), d.end(), [](const cl_R& entry) { return cln::zerop(entry); });
}

/// The displacement of the first or second field of derivatives along y.
Displacement displacement(const Mechanics& at, const Contraction& by) {
  return by.field == 0 ? Displacement{by.y, rest(at)} : Displacement{rest(at), by.y};
}

}  // namespace

Values inverse_derivatives(Mechanics& at) {
  ResidualPoint point{at, at.state().a, Direction(at.state().u.size(), cl_R(0))};
  const auto columns = residual_columns(point);
  Values values = matrix_of(columns[0], at.size());
  append(values, matrix_of(columns[1], at.size()));
  return values;
}

cl_R inverse_contraction(Mechanics& at, const Contraction& by) {
  return at.residual_slope(by.w, displacement(at, by), at.state().a,
                           Direction(at.state().u.size(), cl_R(0)));
}

Values forward_derivatives(Mechanics& at) {
  Values values;
  for (const std::vector<Values>& columns : acceleration_columns(at)) {
    append(values, matrix_of(columns, at.size()));
  }
  return values;
}

cl_R forward_contraction(Mechanics& at, const Contraction& by) {
  return by.field == 2 ? along_inputs(at, by.w, by.y)
                       : along_acceleration(at, by.w, displacement(at, by));
}

/// The rates of x = (dq, dv) for unit changes: of a rotation vector dq the rate is dv - w x dq.
Values state_matrices(Mechanics& at) {
  const auto parts = acceleration_columns(at);
  const std::size_t n = at.size();
  std::vector<Values> of_state;
  for (std::size_t j = 0; j < 2 * n; ++j) {
    const bool is_position = j < n;
    const Direction unit = at.unit(j % n);
    Values column = is_position ? negative(at.across_velocity(unit)) : unit;
    append(column, parts[is_position ? 0 : 1][j % n]);
    of_state.push_back(std::move(column));
  }
  std::vector<Values> of_inputs;
  for (const Values& acceleration : parts[2]) {
    Values column = rest(at);
    append(column, acceleration);
    of_inputs.push_back(std::move(column));
  }
  Values values = matrix_of(of_state, 2 * n);
  append(values, matrix_of(of_inputs, 2 * n));
  return values;
}

/// w has positions first, then velocities; so has y, unless it is one of inputs.
cl_R state_contraction(Mechanics& at, const Contraction& by) {
  const auto middle = static_cast<std::ptrdiff_t>(at.size());
  const Direction w_position(by.w.begin(), by.w.begin() + middle);
  const Direction w_velocity(by.w.begin() + middle, by.w.end());
  if (by.field == 1) return is_zero(w_velocity) ? 0 : along_inputs(at, w_velocity, by.y);
  const Displacement along{{by.y.begin(), by.y.begin() + middle},
                           {by.y.begin() + middle, by.y.end()}};
  const cl_R rates = dot(w_position, along.y) - dot(w_position, at.across_velocity(along.x));
  return is_zero(w_velocity) ? rates : rates + along_acceleration(at, w_velocity, along);
}

}  // namespace elgen::oracle
