// steps: sentences that all derivations share.
#pragma once

#include <string_view>

namespace elgen {

inline constexpr std::string_view action_doc =
    "Hamilton's principle: the motion between two fixed ends makes S stationary.";
inline constexpr std::string_view rotation_variation_note =
    " For an angular velocity, delta q is a rotation about the axes of the body, and d/dt is the "
    "rate in the world frame.";
inline constexpr std::string_view constraints_doc =
    "Each constraint has an unknown multiplier; A = df/dq for positions, dphi/dv for velocities.";
inline constexpr std::string_view velocity_constraint_note =
    R"(\text{constraints on velocities add nothing to } L \text{: } {\delta} <q> \cdot A^{\top} )"
    R"(<lambda> \text{ is virtual work (d'Alembert)})";

inline constexpr std::string_view rotation_doc =
    "For an angular velocity, d/dt is the rate in the world frame and adds [w]x dL/dw; L is "
    "differentiated along a rotation about the axis of the body.";

}  // namespace elgen
