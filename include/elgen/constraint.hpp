// Constraint: an equation that the motion of a Model obeys.
#pragma once

#include <optional>
#include <string>

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

}  // namespace elgen
