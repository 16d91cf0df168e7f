// The passes of specialise over a Lagrangian.
#pragma once

#include <vector>

#include "derive/formulate/chain_rule.hpp"
#include "elgen/lagrangian.hpp"

namespace elgen {

/// Substitutes `values` for leaves in every energy, force, frame and output. Old definitions stay
/// in the list, but no energy, force, frame or output refers to them.
void substitute_leaves(UnreducedLagrangian& lagrangian, const Seeds& values);

/// Substitutes q_i = s(t), v_i = ds/dt and a_i = d2s/dt2 for each locked q_i, and removes its row
/// and column. If a reaction is requested, `reaction_source` keeps the Lagrangian in which q_i
/// moves.
void apply_locks(UnreducedLagrangian& lagrangian);

/// Removes cyclic coordinates: L becomes the Routhian R, in which their momenta are parameters.
void apply_routh_reduction(UnreducedLagrangian& lagrangian);

/// Substitutes `values`, then removes the rows, columns and leaves of `variables` (all locked or
/// all cyclic variables) and of the held inputs.
void remove_variables(UnreducedLagrangian& lagrangian, std::vector<HeldCoordinateMotion>& variables,
                      const Seeds& values);

/// Rewrites point masses, gravity and point forces as terms of T, V and the generalised forces.
void write_energy_sums(Lagrangian& lagrangian);

/// Replaces masses, energies and forces by the Taylor expansion that `lagrangian.expansion`
/// describes. User outputs stay exact.
[[nodiscard]] Lagrangian expand_energies(Lagrangian lagrangian);

}  // namespace elgen
