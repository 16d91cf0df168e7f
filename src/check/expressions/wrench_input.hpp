// Inputs that are external forces: a wrench on a frame, or a force at a point. One entry declares
// an input for each component, and the forces with these components:
//
//     wrench = "hand"    f_tx f_ty f_tz torque in N*m, f_fx f_fy f_fz force in N at the origin
//     at = "toe"         f_fx f_fy f_fz force in N
//
// Expressions may also write f[1], f[2], …. The components are in world axes, or in the axes of the
// frame that `in` names. In a plane they are f_tz, f_fx and f_fy. The order is the same as in the
// twist of an [[output]] with this frame, so the columns of B are the transposed Jacobian of the
// twist.
#pragma once

#include <optional>

#include "check/expressions/values.hpp"

namespace elgen {

[[nodiscard]] bool is_wrench_input(const EntrySyntax& entry);

/// Adds the inputs NAME_tx, NAME_ty, …; returns the index of the first. E112 if the entry is
/// repeated, or also has `on` or `unit`.
std::optional<std::uint32_t> declare_wrench_input(Context& context, const EntrySyntax& entry,
                                                  const NewName& name);

/// The numbers of inputs that are components of the torque and of the force.
struct WrenchComponentCounts {
  std::uint32_t torque = 0;
  std::uint32_t force = 0;
};
[[nodiscard]] WrenchComponentCounts count_wrench_components(const Context& context,
                                                            const EntrySyntax& entry);

}  // namespace elgen
