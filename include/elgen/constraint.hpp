// Constraint: an equation that the motion of a Model obeys. Held: what a scene takes out of a
// model, locked variables and cyclic coordinates.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elgen/expression.hpp"
#include "elgen/source_text.hpp"
#include "elgen/units.hpp"

namespace elgen {

/// One equation of a [[constraint]]: f(q, t) = 0 of a position, or phi(q, v, t) = 0, affine in the
/// rates, of a velocity; `value` is its left side less its right side.
///
/// Along the motion A a + gamma = -2 zeta omega r - omega^2 f, with the rate r = df/dt or phi, A =
/// dr/dv, and gamma = dr/dt at a = 0. Its multiplier acts as A^T lambda on the side of the inputs.
struct Constraint {
  std::string name;        ///< "rod"; of several equations "loop_x", "loop_1", "link_2[3]"
  std::string identifier;  ///< "link_2_3"
  ExpressionId value = 0;
  bool is_position = true;
  std::optional<ExpressionId> omega = {};  ///< of `stabilise`; none: 0
  std::optional<ExpressionId> zeta = {};
  std::optional<Unit> unit = {};  ///< of f or phi; none: not known
  std::string doc = {};
  Span span = {};  ///< of the name of its entry
  Span equation_span = {};
};

inline constexpr std::uint32_t quaternion_size = 4;
inline constexpr std::uint32_t axis_count = 3;

/// A coordinate, or a rotation, that does not move freely.
struct Held {
  std::uint32_t coordinate = 0;  ///< the first one, if of a rotation
  std::uint32_t velocity = 0;    ///< likewise
  bool is_rotation = false;
  bool reaction = false;  ///< the force that holds it is wanted

  [[nodiscard]] std::uint32_t velocity_count() const { return is_rotation ? axis_count : 1; }
  [[nodiscard]] std::uint32_t coordinate_count() const { return is_rotation ? quaternion_size : 1; }
};

/// A variable that a scene holds at a function of time. It is taken out twice, on purpose: of the
/// Model by check, which is what the oracle sees, and of the Lagrangian by specialise, which is
/// what is derived from. Each is a check of the other.
struct Lock : Held {
  std::vector<ExpressionId> values = {};  ///< s(t); of a rotation the four of a unit quaternion
  Span span = {};
};

/// A cyclic coordinate that a scene takes out at a momentum that stays (`[routh]`), which becomes a
/// parameter. It is taken out twice, as locks are.
struct Cyclic : Held {
  std::uint32_t parameter = 0;
  /// Of numbers and parameters; none: that at the start.
  std::optional<ExpressionId> momentum = {};
  Span span = {};
};

}  // namespace elgen
