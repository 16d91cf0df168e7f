// The passes of specialise over a Lagrangian, one after another.
#pragma once

#include <vector>

#include "derive/formulate/chain_rule.hpp"
#include "elgen/lagrangian.hpp"

namespace elgen {

/// Every energy, force, frame and output over new definitions; the old ones stay in the list,
/// unreached.
void replace(WholeLagrangian& lagrangian, const Seeds& values);

/// q_i = s(t), v_i = ds/dt in every energy, force and frame; the row and the column of q_i are
/// gone. Where a reaction is wanted, the Lagrangian before is kept in `holding`.
void lock(WholeLagrangian& lagrangian);

/// Cyclic coordinates leave: L becomes R, a function of what is left and of their momenta.
void routh(WholeLagrangian& lagrangian);

/// Values take the place of the locked or of the cyclic variables of the Lagrangian, whose rows,
/// columns and leaves are gone, and the held inputs with them.
void remove_variables(WholeLagrangian& lagrangian, std::vector<HeldVariable>& variables,
                      const Seeds& values);

/// Masses, points and their forces become terms of T, V and the generalized forces.
void write_sums(Lagrangian& lagrangian);

/// Replaces masses, energies and forces by their expansions, as `lagrangian.expansion` says. User
/// outputs stay exact.
[[nodiscard]] Lagrangian expanded(Lagrangian lagrangian);

}  // namespace elgen
