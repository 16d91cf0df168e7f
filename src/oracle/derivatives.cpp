// Derivatives, entry by entry.
#include "oracle/derivatives.hpp"

#include <algorithm>

#include "oracle/solved_dynamics.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;
using Values = std::vector<cl_R>;

/// A change of positions (the first field of derivatives) or of velocities (the second) along y.
Displacement displacement(const Mechanics& at, std::size_t field, const Direction& y) {
  const Direction rest(at.size(), cl_R(0));
  return field == 0 ? Displacement{y, rest} : Displacement{rest, y};
}

/// d(M a + bias - B u)/dq, then d/dv.
Values residual_derivatives(Mechanics& at, const Direction& a, const Direction& u) {
  const std::size_t n = at.size();
  Values values;
  for (std::size_t k = 0; k < 2 * n * n; ++k) {
    const Displacement along = displacement(at, k / (n * n), at.unit(k % n));
    values.push_back(at.residual_slope(at.unit(k / n % n), along, a, u));
  }
  return values;
}

/// Replaces a matrix of so many columns, which begins at an entry of `values`, by M^-1 times it.
void solve_columns(Mechanics& at, const Values& mass, std::size_t columns,
                   const Values::iterator& begin) {
  const auto place = [&](std::size_t row, std::size_t column) {
    return begin + static_cast<std::ptrdiff_t>(row * columns + column);
  };
  for (std::size_t j = 0; j < columns; ++j) {
    Values column;
    for (std::size_t i = 0; i < at.size(); ++i) column.push_back(*place(i, j));
    const Values solution = solve_mass(at.model(), mass, column).x;
    for (std::size_t i = 0; i < at.size(); ++i) *place(i, j) = solution[i];
  }
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

}  // namespace

/// B_ij = e_i.B e_j
Values input_entries(Mechanics& at) {
  const std::size_t inputs = at.state().u.size();
  Values values;
  for (std::size_t k = 0; k < at.size() * inputs; ++k) {
    values.push_back(at.input_force(at.unit(k / inputs), unit_direction(inputs, k % inputs)));
  }
  return values;
}

Values inverse_derivatives(Mechanics& at) {
  return residual_derivatives(at, at.state().a, Direction(at.state().u.size(), cl_R(0)));
}

cl_R inverse_contraction(Mechanics& at, const Contraction& by) {
  return at.residual_slope(by.w, displacement(at, by.field, by.y), at.state().a,
                           Direction(at.state().u.size(), cl_R(0)));
}

Values forward_derivatives(Mechanics& at) {
  const Values mass = mass_matrix_values(at);
  Values values = residual_derivatives(at, solved_dynamics(at, mass).x, at.state().u);
  for (cl_R& value : values) value = -value;
  const Values inputs = input_entries(at);
  values.insert(values.end(), inputs.begin(), inputs.end());
  const std::size_t n = at.size();
  auto begin = values.begin();
  for (const std::size_t columns : {n, n, at.state().u.size()}) {
    solve_columns(at, mass, columns, begin);
    begin += static_cast<std::ptrdiff_t>(n * columns);
  }
  return values;
}

cl_R forward_contraction(Mechanics& at, const Contraction& by) {
  return by.field == 2 ? along_inputs(at, by.w, by.y)
                       : along_acceleration(at, by.w, displacement(at, by.field, by.y));
}

/// A = [-[w]x 1; da/dq da/dv], B = [0; da/du]
Values state_matrices(Mechanics& at) {
  const Values parts = forward_derivatives(at);
  const std::size_t n = at.size();
  const std::size_t inputs = at.state().u.size();
  const std::size_t b = 4 * n * n;  // where B begins
  Values values(b + 2 * n * inputs, cl_R(0));
  for (std::size_t j = 0; j < n; ++j) {
    const Direction across = at.across_velocity(at.unit(j));
    values[2 * n * j + n + j] = 1;
    for (std::size_t i = 0; i < n; ++i) {
      values[2 * n * i + j] = -across[i];
      values[2 * n * (n + i) + j] = parts[n * i + j];
      values[2 * n * (n + i) + n + j] = parts[n * n + n * i + j];
    }
  }
  std::copy(parts.begin() + static_cast<std::ptrdiff_t>(2 * n * n), parts.end(),
            values.begin() + static_cast<std::ptrdiff_t>(b + n * inputs));
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
