// steps: sentences that all derivations share. `<q>` is a vector.
//
// Hamilton's principle, together with d'Alembert's principle if forces do work or constraints hold:
// Goldstein, Poole, Safko, Classical Mechanics, 3rd ed., sections 1.4, 2.3 and 2.4.
#pragma once

#include <array>
#include <string_view>

namespace elgen {

inline constexpr std::string_view action_doc =
    "Hamilton's principle: the motion between two fixed ends makes S stationary.";
inline constexpr std::string_view rotation_variation_note =
    " For an angular velocity, delta q is a rotation about the axes of the body, and d/dt is the "
    "rate in the world frame.";

/// S, its variation, the integration by parts, and the boundary terms.
inline constexpr std::array<std::string_view, 4> variation_lines{
    R"(S = \int L dt)",
    R"({\delta} S = \int \left( \frac{\partial L}{\partial <q>} \cdot {\delta} <q> + )"
    R"(\frac{\partial L}{\partial <v>} \cdot \frac{d}{dt} {\delta} <q> \right) dt)",
    R"({\delta} S = \int \left( \frac{\partial L}{\partial <q>} - )"
    R"(\frac{d}{dt} \frac{\partial L}{\partial <v>} \right) \cdot {\delta} <q> dt + )"
    R"(\left[ \frac{\partial L}{\partial <v>} \cdot {\delta} <q> \right] \text{ by parts})",
    R"(\left[ \frac{\partial L}{\partial <v>} \cdot {\delta} <q> \right] = 0 )"
    R"(\text{, as } {\delta} <q> = <0> \text{ at both ends})"};

/// Hamilton's principle, and d'Alembert's principle for forces that do work.
inline constexpr std::string_view stationary_action =
    R"({\delta} S = 0 \text{ for every } {\delta} <q> \text{, so } )"
    R"(\frac{d}{dt} \frac{\partial L}{\partial <v>} - \frac{\partial L}{\partial <q>} = <0>)";
inline constexpr std::string_view virtual_work =
    R"({\delta} W = \left( <Q> - \frac{\partial D}{\partial <v>} \right) \cdot {\delta} <q> )"
    R"(\text{ is the virtual work of forces (d'Alembert)})";
inline constexpr std::string_view virtual_work_balance =
    R"({\delta} S + \int {\delta} W dt = 0 \text{ for every } {\delta} <q> \text{, so } )";
inline constexpr std::string_view lagrange_equation =
    R"(\frac{d}{dt} \frac{\partial L}{\partial <v>} - \frac{\partial L}{\partial <q>} + )"
    R"(\frac{\partial D}{\partial <v>} = <Q>)";

/// d'Alembert's principle with constraints.
inline constexpr std::string_view constrained_virtual_work =
    R"({\delta} W = \left( <Q> - \frac{\partial D}{\partial <v>} + A^{\top} <lambda> )"
    R"(\right) \cdot {\delta} <q> )"
    R"(\text{ is the virtual work of forces and constraints (d'Alembert)})";
inline constexpr std::string_view constraint_forces = R"( + A^{\top} <lambda>)";
inline constexpr std::string_view constraints_doc =
    "Each constraint has an unknown multiplier; A = df/dq for positions, dphi/dv for velocities.";
inline constexpr std::string_view velocity_constraint_note =
    R"(\text{constraints on velocities add nothing to } L \text{: } {\delta} <q> \cdot A^{\top} )"
    R"(<lambda> \text{ is virtual work (d'Alembert)})";

inline constexpr std::string_view rotation_doc =
    "For an angular velocity, d/dt is the rate in the world frame and adds [w]x dL/dw; L is "
    "differentiated along a rotation about the axis of the body.";

inline constexpr const char* free_energy_rate = "dE/dt = -dL/dt at fixed q and v.";
inline constexpr const char* driven_energy_rate =
    "dE/dt = v (Q - dD/dv) - dL/dt, with dL/dt at fixed q and v.";
inline constexpr const char* constrained_energy_rate =
    "dE/dt = v (Q - dD/dv + A^T lambda) - dL/dt, with dL/dt at fixed q and v.";
inline constexpr const char* driven_conservation =
    "is conserved if forces and dissipation do no work";
inline constexpr const char* constrained_conservation =
    "is conserved if forces, dissipation and constraints do no work";

}  // namespace elgen
