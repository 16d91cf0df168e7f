// steps: sentences and equations of a derivation. Hamilton's principle, with d'Alembert's principle
// for forces and constraints, has only the terms that the model has. The equations that end a
// derivation are short enough for paper: at most 12 lines of 78 columns, the same in every
// notation.
//
// Goldstein, Poole, Safko, Classical Mechanics, 3rd ed., sections 1.4, 2.3 and 2.4.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/page.hpp"

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

/// True if applied forces or inputs act, so that the equations contain Q.
[[nodiscard]] bool has_applied_force(const Model& model);

/// The lines of the section "Action" in the notation of latex_formula(): S, its variation, the
/// virtual work, and Lagrange's equation.
[[nodiscard]] std::vector<std::string> principle_lines(const Model& model);

/// d/dt dL/dv - dL/dq + dD/dv = Q + A^T lambda, in the notation of latex_formula().
[[nodiscard]] std::string lagrange_equation(const Model& model);

/// dE/dt = v (Q - dD/dv + A^T lambda) - dL/dt, in the notation of latex_formula(). The last term is
/// omitted if L does not contain t (`is_autonomous`).
[[nodiscard]] std::string energy_rate(const Model& model, bool is_autonomous);

/// "is conserved", with the condition on forces, dissipation and constraints.
[[nodiscard]] std::string energy_conservation(const Model& model);

/// The equations of some entries of program.readable[index], one field for each, with the
/// definitions that these entries need.
[[nodiscard]] FunctionEquations equations_of_entries(const Model& model, const Program& program,
                                                     std::size_t index,
                                                     const std::vector<std::uint32_t>& entries);

/// True if the equation left = first entry, and each definition, is short enough for paper.
[[nodiscard]] bool is_short_on_paper(const Formula& left, const FunctionEquations& equations);

/// The entries of forward dynamics that are short enough for paper, one field for each.
struct PaperSolution {
  FunctionEquations equations = {};
  Formulas left = {};  ///< the acceleration or multiplier of each field of `equations`
  std::vector<std::string> omitted = {};  ///< the others: "acceleration of x", "multiplier of rod"
};

[[nodiscard]] PaperSolution solution_on_paper(const Model& model, const Program& forward_dynamics);

}  // namespace elgen
