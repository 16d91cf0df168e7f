// principle: Hamilton's principle, with d'Alembert's principle for forces and constraints. The
// lines contain only the terms that the model has.
//
// Goldstein, Poole, Safko, Classical Mechanics, 3rd ed., sections 1.4, 2.3 and 2.4.
#pragma once

#include <string>
#include <vector>

#include "elgen/model.hpp"

namespace elgen {

/// True if applied forces or inputs act: Q or B u.
[[nodiscard]] bool has_applied_force(const Model& model);
/// True if no force, dissipation or constraint acts, so that L alone determines the motion.
[[nodiscard]] bool is_free(const Model& model);

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

}  // namespace elgen
