// Inputs that are forces of the world: a wrench on a frame, or a force on a point. One entry
// declares several of them, and the forces that they are components of:
//
//     wrench = "hand"    f[1] … f[3] torque in N*m, f[4] … f[6] force in N at the frame's origin
//     at = "toe"         f[1] … f[3] force in N
//
// along the axes of the world, or of the frame that `in` names; in a plane a torque has one
// component, and a force two. The order is that of the twist of an [[output]] with that frame, so
// that the columns of B are its Jacobian transposed.
#pragma once

#include <optional>

#include "check/expressions/values.hpp"

namespace elgen {

[[nodiscard]] bool is_wrench_input(const EntrySyntax& entry);

/// Adds the inputs, called NAME[1], NAME[2], …; the first one. E112 where the entry is repeated, or
/// names `on` or `unit` too.
std::optional<std::uint32_t> declare_wrench_input(Context& context, const EntrySyntax& entry,
                                                  const NewName& name);

/// How many of the inputs are components of a torque, and of a force.
struct WrenchComponents {
  std::uint32_t torque = 0;
  std::uint32_t force = 0;
};
[[nodiscard]] WrenchComponents wrench_components(const Context& context, const EntrySyntax& entry);

}  // namespace elgen
