// Energies: L, T, V and D of a Model as jets, summed from what the file gives and its points and
// bodies.
//
//     T = [energy].T + sum 1/2 m |dp/dt|^2 + sum 1/2 w.I w + sum 1/2 J v_i^2
//     V = [energy].V - sum m gravity.p
//     L = T - V, or [energy].L (+ armatures) where that is given
#pragma once

#include "elgen/model.hpp"
#include "oracle/evaluation.hpp"
#include "oracle/schedule.hpp"

namespace elgen::oracle {

/// Everything an energy is made of, as roots of a schedule.
[[nodiscard]] std::vector<Root> kinetic_roots(const Model& model);
[[nodiscard]] std::vector<Root> potential_roots(const Model& model);
[[nodiscard]] std::vector<Root> lagrangian_roots(const Model& model);
[[nodiscard]] std::vector<Root> dissipation_roots(const Model& model);

/// Values; the evaluation's schedule must hold the roots above. The motion gives the rates of
/// armatures.
[[nodiscard]] Jet kinetic_energy(const Model& model, const Evaluation& at, const Motion& motion);
[[nodiscard]] Jet potential_energy(const Model& model, const Evaluation& at);
/// Its summands without their signs: what V gives as a sum, and m g_i p_i of every mass and axis.
[[nodiscard]] Jet potential_magnitude(const Model& model, const Evaluation& at);
[[nodiscard]] Jet lagrangian(const Model& model, const Evaluation& at, const Motion& motion);
[[nodiscard]] Jet dissipation(const Model& model, const Evaluation& at);

}  // namespace elgen::oracle
