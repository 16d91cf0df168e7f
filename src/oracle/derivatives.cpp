// Derivatives of the dynamics, one directional derivative per entry.
#include <algorithm>

#include "oracle/constraints.hpp"
#include "oracle/output_values.hpp"
#include "oracle/solved_dynamics.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;
using Values = std::vector<cl_R>;

/// y as a displacement of positions for field 0 (d/dq), or of velocities for field 1 (d/dv).
Displacement make_displacement(const Mechanics& at, std::size_t field, const Direction& y) {
  const Direction rest(at.size(), cl_R(0));
  return field == 0 ? Displacement{y, rest} : Displacement{rest, y};
}

/// d(M a + bias - B u)/dq, then d/dv, each n x n row-major.
Values residual_derivatives(Mechanics& at, const Direction& a, const Direction& u) {
  const std::size_t n = at.size();
  Values values;
  for (std::size_t k = 0; k < 2 * n * n; ++k) {
    const Displacement along = make_displacement(at, k / (n * n), at.unit(k % n));
    values.push_back(at.residual_slope(at.unit(k / n % n), along, a, u));
  }
  return values;
}

/// Derivative of M a + bias - B u - A^T lambda along a displacement, one entry per velocity.
Values force_slopes(Mechanics& at, const ConstrainedMotion& motion, const Displacement& along) {
  Values values;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Direction w = at.unit(i);
    values.push_back(at.residual_slope(w, along, motion.x, at.state().u) -
                     constraint_force_slope(at.model(), at.state(), w, along.position, motion.y));
  }
  return values;
}

/// Writes `column` to column j of `matrix`, which is row-major with `columns` columns.
void write_column(const Values& column, std::size_t j, std::size_t columns, Values& matrix) {
  for (std::size_t i = 0; i < column.size(); ++i) matrix[i * columns + j] = column[i];
}

/// Derivatives of accelerations and multipliers along a displacement and a change of inputs. If
/// `inputs` is empty, the inputs do not change.
ConstrainedMotion constrained_motion_slope(Mechanics& at, const ConstrainedSystem& system,
                                           const ConstrainedMotion& motion,
                                           const Displacement& along, const Direction& inputs) {
  Values forces = negate(force_slopes(at, motion, along));
  for (std::size_t i = 0; i < forces.size() && !inputs.empty(); ++i) {
    forces[i] = forces[i] + at.input_force(at.unit(i), inputs);
  }
  const Values shortage = negate(stabilised_slope(at.model(), at.state(), along, motion.x));
  return solve_response(at, system, forces, shortage);
}

/// da/dq (field 0) or da/dv (field 1).
Values state_derivatives(Mechanics& at, const ConstrainedSystem& system,
                         const ConstrainedMotion& motion, std::size_t field) {
  const std::size_t n = at.size();
  Values matrix(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    const Displacement along = make_displacement(at, field, at.unit(j));
    write_column(constrained_motion_slope(at, system, motion, along, {}).x, j, n, matrix);
  }
  return matrix;
}

/// w.da = y.dc - z.dr, all derivatives along `along`, with M z = w + A^T y, A z = 0. Here r = M a +
/// bias - B u - A^T lambda and c = A a + stabilised bias.
cl_R acceleration_contraction(Mechanics& at, const Direction& w, const Displacement& along) {
  const ConstrainedSystem system = constrained_system(at);
  const ConstrainedMotion motion = constrained_motion(at, system);
  const ConstrainedMotion z = solve_response(at, system, w, Values(motion.y.size()));
  cl_R sum = constraint_force_slope(at.model(), at.state(), z.x, along.position, motion.y) -
             at.residual_slope(z.x, along, motion.x, at.state().u);
  const Values slopes = stabilised_slope(at.model(), at.state(), along, motion.x);
  for (std::size_t k = 0; k < slopes.size(); ++k) sum = sum + z.y[k] * slopes[k];
  return sum;
}

/// w.(da/du) y = z.B y with M z = w + A^T y', A z = 0.
cl_R input_contraction(Mechanics& at, const Direction& w, const Direction& y) {
  const Values still(at.model().constraints.size());
  return at.input_force(solve_response(at, constrained_system(at), w, still).x, y);
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

ConstrainedMotion motion_slope(Mechanics& at, const Displacement& along, const Direction& inputs) {
  const ConstrainedSystem system = constrained_system(at);
  return constrained_motion_slope(at, system, constrained_motion(at, system), along, inputs);
}

Values inverse_derivatives(Mechanics& at) {
  return residual_derivatives(at, at.state().a, Direction(at.state().u.size(), cl_R(0)));
}

cl_R inverse_contraction(Mechanics& at, const Contraction& by) {
  return at.residual_slope(by.w, make_displacement(at, by.field, by.y), at.state().a,
                           Direction(at.state().u.size(), cl_R(0)));
}

Values forward_derivatives(Mechanics& at) {
  const ConstrainedSystem system = constrained_system(at);
  const ConstrainedMotion motion = constrained_motion(at, system);
  Values values;
  for (const std::size_t field : {std::size_t{0}, std::size_t{1}}) {
    const Values matrix = state_derivatives(at, system, motion, field);
    values.insert(values.end(), matrix.begin(), matrix.end());
  }
  const std::size_t inputs = at.state().u.size();
  const Values of_inputs = input_matrix_entries(at);
  Values matrix(of_inputs.size());
  for (std::size_t j = 0; j < inputs; ++j) {
    Values column;
    for (std::size_t i = 0; i < at.size(); ++i) column.push_back(of_inputs[i * inputs + j]);
    write_column(solve_response(at, system, column, Values(motion.y.size())).x, j, inputs, matrix);
  }
  values.insert(values.end(), matrix.begin(), matrix.end());
  return values;
}

cl_R forward_contraction(Mechanics& at, const Contraction& by) {
  return by.field == 2 ? input_contraction(at, by.w, by.y)
                       : acceleration_contraction(at, by.w, make_displacement(at, by.field, by.y));
}

/// A = [-[w]x 1; da/dq da/dv], B = [0; da/du]
Values state_matrices(Mechanics& at) {
  const Values parts = forward_derivatives(at);
  const std::size_t n = at.size();
  const std::size_t inputs = at.state().u.size();
  const std::size_t b = 4 * n * n;  // offset of B
  Values values(b + 2 * n * inputs, cl_R(0));
  for (std::size_t j = 0; j < n; ++j) {
    const Direction across = at.cross_velocity(at.unit(j));
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

/// w.A y (field 0) or w.B y (field 1), with A and B of state_matrices(). w has position components,
/// then velocity components. For A, y has the same order.
cl_R state_contraction(Mechanics& at, const Contraction& by) {
  const auto middle = static_cast<std::ptrdiff_t>(at.size());
  const Direction w_position(by.w.begin(), by.w.begin() + middle);
  const Direction w_velocity(by.w.begin() + middle, by.w.end());
  if (by.field == 1) return is_zero(w_velocity) ? 0 : input_contraction(at, w_velocity, by.y);
  const Displacement along{{by.y.begin(), by.y.begin() + middle},
                           {by.y.begin() + middle, by.y.end()}};
  const cl_R rates =
      dot(w_position, along.velocity) - dot(w_position, at.cross_velocity(along.position));
  return is_zero(w_velocity) ? rates : rates + acceleration_contraction(at, w_velocity, along);
}

}  // namespace elgen::oracle
