// Energies L, T, V and D of a Model as jets: the energies of the file plus its points and bodies.
//
//     T = [energy].T + sum 1/2 m |dp/dt|^2 + sum 1/2 w.I w + sum 1/2 J v_i^2
//     V = [energy].V - sum m gravity.p
//     L = T - V, or [energy].L + sum 1/2 J v_i^2 if the file gives L
//
// With [routh] the Routhian R of the whole model replaces L. Two further generators give
// dL/dv_c and M_cc = d2L/dv_c2 for the cyclic velocities v_c:
//
//     R = L0 - 1/2 w.v_c,   M_cc v_c = w = p - dL/dv_c,   L0, dL/dv_c and M_cc at v_c = 0
#pragma once

#include <vector>

#include "oracle/evaluation.hpp"

namespace elgen::oracle {

[[nodiscard]] Jet kinetic_energy(Evaluation& at);
[[nodiscard]] Jet potential_energy(Evaluation& at);
/// The sum of the absolute summands of V: terms of [energy].V, and m g_i p_i of every mass and
/// axis.
[[nodiscard]] Jet potential_magnitude(Evaluation& at);
/// L, or R if the scene has [routh].
[[nodiscard]] Jet lagrangian(Evaluation& at);
/// `motion`, extended to the coordinates of the unreduced model: locked coordinates follow their
/// functions of time; cyclic coordinates and their rates are 0.
[[nodiscard]] Motion whole_motion(const Model& model, const Motion& motion);
/// v_c, in the order of ModelReduction::cyclic. OutsideDomain if M_cc is singular.
[[nodiscard]] std::vector<Jet> cyclic_rates(const Evaluation& at);
[[nodiscard]] Jet dissipation(Evaluation& at);

}  // namespace elgen::oracle
