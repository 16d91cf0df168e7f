// What a scene takes out of a model: locked variables, and cyclic coordinates.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "elgen/expression.hpp"
#include "elgen/source_text.hpp"

namespace elgen {

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
