// Generators of symmetries: infinitesimal changes of a motion. The unknowns are constants: a matrix
// A, vectors b and c, a time shift dt, and for each rotation a turn s about world axes and a turn
// sigma about body axes.
//
//     dq = A q + b + c t,  dv = A v + c,  da = A a     for coordinates other than rotations
//     eta = C^T s + sigma,  dw = w x sigma,  dw' = w' x sigma    for a rotation: turn eta, angular
//                          velocity w in body axes, matrix C (body to world)
//
// Let R = d/dt dL/dv - dL/dq (plus [w]x dL/dw for rotations). A change is a symmetry (dL is a total
// derivative) if and only if
//
//     dR + A^T R = 0    for all q, v, a, t;  for a rotation A = -[sigma]x
//
// because the characteristic Q = dq - dt v satisfies E(X L) = X E(L) + D_Q^* E(L) with Euler's
// operator E (Olver, Applications of Lie Groups to Differential Equations, 2nd ed., sec. 5.3). No
// ansatz for F in dL = dF/dt is needed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "elgen/model.hpp"

namespace elgen {

/// The unknowns in order: A by rows, c, b, then s and sigma of each rotation, then dt.
struct GeneratorLayout {
  explicit GeneratorLayout(const Model& model) : velocity_count(model.velocities.size()) {
    for (std::uint32_t i = 0; i < model.coordinates.size(); ++i) {
      if (model.coordinates[i].rotation) continue;
      coordinates.push_back(i);
      velocities.push_back(model.coordinates[i].velocity);
    }
    for (const Rotation& rotation : model.rotations) {
      rotations.push_back({rotation.first_coordinate, rotation.first_velocity});
    }
  }

  std::vector<std::uint32_t> coordinates = {};  ///< indices in q, without rotations
  std::vector<std::uint32_t> velocities = {};   ///< of `coordinates`, in the same order
  struct RotationIndices {
    std::uint32_t first_coordinate = 0;
    std::uint32_t first_velocity = 0;
  };
  std::vector<RotationIndices> rotations = {};
  std::size_t velocity_count = 0;

  [[nodiscard]] std::size_t scalar_count() const { return coordinates.size(); }
  [[nodiscard]] std::size_t size() const { return time_index() + 1; }
  [[nodiscard]] std::size_t a_index(std::size_t i, std::size_t k) const {
    return i * scalar_count() + k;
  }
  [[nodiscard]] std::size_t c_index(std::size_t i) const {
    return scalar_count() * scalar_count() + i;
  }
  [[nodiscard]] std::size_t b_index(std::size_t i) const { return c_index(scalar_count()) + i; }
  [[nodiscard]] std::size_t world_turn_index(std::size_t rotation, std::size_t axis) const {
    return b_index(scalar_count()) + std::size_t{2} * axis_count * rotation + axis;
  }
  [[nodiscard]] std::size_t body_turn_index(std::size_t rotation, std::size_t axis) const {
    return world_turn_index(rotation, axis) + axis_count;
  }
  [[nodiscard]] std::size_t time_index() const { return world_turn_index(rotations.size(), 0); }
};

/// A point of a motion and R at this point, as numbers or closed forms.
template <class Number>
struct MotionPoint {
  std::vector<Number> q = {};
  std::vector<Number> v = {};
  std::vector<Number> a = {};
  Number t = {};
  std::vector<Number> residual = {};
};

/// dR/dq N (with dq/dt = N v), dR/dv and dR/da at a point, n x n, row-major; and dR/dt, n entries.
template <class Number>
struct ResidualSlopes {
  std::vector<Number> by_position = {};
  std::vector<Number> by_velocity = {};
  std::vector<Number> by_acceleration = {};
  std::vector<Number> by_time = {};
};

/// Row j of the matrix of a unit quaternion: the j-th world axis in body axes.
template <class Field>
std::array<typename Field::Number, axis_count> world_axis(
    Field& field, const std::vector<typename Field::Number>& q, std::uint32_t first,
    std::size_t j) {
  using Number = typename Field::Number;
  const Number& w = q[first];
  const auto component = [&](std::size_t i) -> const Number& { return q[first + 1 + i]; };
  const std::size_t k = (j + 1) % axis_count;
  const std::size_t l = (j + 2) % axis_count;
  const auto twice = [&](const Number& x) { return field.add(x, x); };
  const Number squares = field.add(field.multiply(component(k), component(k)),
                                   field.multiply(component(l), component(l)));
  const auto mixed = [&](std::size_t i, int sign) {
    const std::size_t third = axis_count - j - i;
    const Number turned = field.multiply(w, component(third));
    return twice(field.add(field.multiply(component(j), component(i)),
                           sign < 0 ? field.negate(turned) : turned));
  };
  std::array<Number, axis_count> row;
  row[j] = field.add(field.integer(1), field.negate(twice(squares)));
  row[k] = mixed(k, -1);
  row[l] = mixed(l, 1);
  return row;
}

/// Column j of [y]x, the cross product of y and the j-th unit vector; y starts at x[first].
template <class Field>
std::array<typename Field::Number, axis_count> cross_with_unit(
    Field& field, const std::vector<typename Field::Number>& x, std::size_t first, std::size_t j) {
  const std::size_t k = (j + 1) % axis_count;
  const std::size_t l = (j + 2) % axis_count;
  std::array<typename Field::Number, axis_count> result;
  result[j] = field.integer(0);
  result[k] = x[first + l];
  result[l] = field.negate(x[first + k]);
  return result;
}

/// The change of a point by a generator: dq, dv, da and A^T R, each with one entry per velocity.
template <class Number>
struct PointChange {
  std::vector<Number> position = {};
  std::vector<Number> velocity = {};
  std::vector<Number> acceleration = {};
  std::vector<Number> transposed_residual = {};
};

/// The change of `at` by the generator with the unknowns x.
template <class Field>
PointChange<typename Field::Number> apply_generator(Field& field, const GeneratorLayout& layout,
                                                    const MotionPoint<typename Field::Number>& at,
                                                    const std::vector<typename Field::Number>& x) {
  using Number = typename Field::Number;
  const std::vector<Number> none(layout.velocity_count, field.integer(0));
  PointChange<Number> change{none, none, none, none};
  const auto add = [&](Number& to, const Number& factor, const Number& term) {
    if (!field.is_zero(factor)) to = field.add(to, field.multiply(factor, term));
  };
  for (std::size_t i = 0; i < layout.scalar_count(); ++i) {
    const std::uint32_t own = layout.velocities[i];
    for (std::size_t k = 0; k < layout.scalar_count(); ++k) {
      const Number& factor = x[layout.a_index(i, k)];
      const std::uint32_t other = layout.velocities[k];
      add(change.position[own], factor, at.q[layout.coordinates[k]]);
      add(change.velocity[own], factor, at.v[other]);
      add(change.acceleration[own], factor, at.a[other]);
      add(change.transposed_residual[other], factor, at.residual[own]);
    }
    add(change.position[own], x[layout.c_index(i)], at.t);
    add(change.position[own], x[layout.b_index(i)], field.integer(1));
    add(change.velocity[own], x[layout.c_index(i)], field.integer(1));
  }
  for (std::size_t r = 0; r < layout.rotations.size(); ++r) {
    const auto& [first_coordinate, first] = layout.rotations[r];
    for (std::size_t j = 0; j < axis_count; ++j) {
      const Number& world = x[layout.world_turn_index(r, j)];
      const Number& body = x[layout.body_turn_index(r, j)];
      const auto axis = world_axis(field, at.q, first_coordinate, j);
      const auto velocity = cross_with_unit(field, at.v, first, j);
      const auto acceleration = cross_with_unit(field, at.a, first, j);
      const auto residual = cross_with_unit(field, at.residual, first, j);
      for (std::size_t k = 0; k < axis_count; ++k) {
        add(change.position[first + k], world, axis[k]);
        add(change.velocity[first + k], body, velocity[k]);
        add(change.acceleration[first + k], body, acceleration[k]);
        // A^T R = [sigma]x R = -(R x r)
        add(change.transposed_residual[first + k], field.negate(body), residual[k]);
      }
      add(change.position[first + j], body, field.integer(1));
    }
  }
  return change;
}

/// to + sum_k slope_ik change_k
template <class Field>
typename Field::Number plus_slope_product(Field& field, typename Field::Number to,
                                          const std::vector<typename Field::Number>& slope,
                                          std::size_t i,
                                          const std::vector<typename Field::Number>& change) {
  for (std::size_t k = 0; k < change.size(); ++k) {
    if (field.is_zero(change[k])) continue;
    to = field.add(to, field.multiply(slope[i * change.size() + k], change[k]));
  }
  return to;
}

/// The coefficients of all unknowns x in dR_i + (A^T R)_i: n rows of `all.size()` entries. For a
/// symmetry, the product of each row with x is 0.
template <class Field>
std::vector<std::vector<typename Field::Number>> symmetry_conditions(
    Field& field, const GeneratorLayout& all, const MotionPoint<typename Field::Number>& at,
    const ResidualSlopes<typename Field::Number>& slopes) {
  using Number = typename Field::Number;
  const std::size_t n = all.velocity_count;
  std::vector rows(n, std::vector<Number>(all.size(), field.integer(0)));
  std::vector<Number> unit(all.size(), field.integer(0));
  for (std::size_t u = 0; u + 1 < all.size(); ++u) {
    unit[u] = field.integer(1);
    const PointChange<Number> change = apply_generator(field, all, at, unit);
    unit[u] = field.integer(0);
    for (std::size_t i = 0; i < n; ++i) {
      Number sum = plus_slope_product(field, change.transposed_residual[i], slopes.by_position, i,
                                      change.position);
      sum = plus_slope_product(field, sum, slopes.by_velocity, i, change.velocity);
      rows[i][u] = plus_slope_product(field, sum, slopes.by_acceleration, i, change.acceleration);
    }
  }
  for (std::size_t i = 0; i < n; ++i) rows[i][all.time_index()] = slopes.by_time[i];
  return rows;
}

}  // namespace elgen
