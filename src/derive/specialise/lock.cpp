// lock: replaces each locked coordinate by its given function of time and removes its equation.
//
//     before    x = l*cos(q1) + l*cos(q1 + q2)     q = (q1, q2)     q1 locked at 0
//     after     x = l + l*cos(q2)                  q = (q2)
#include <memory>

#include "derive/specialise/passes.hpp"

namespace elgen {

namespace {

using GiNaC::ex;

/// q, v and a of the locked variables as functions of time.
Seeds locked_values(UnreducedLagrangian& lagrangian) {
  const Symbols& symbols = lagrangian.symbols;
  Definitions& definitions = lagrangian.definitions;
  Tangent passing(definitions, {{symbols.t, 1}}, "_dot");
  Seeds values;
  for (const HeldCoordinateMotion& locked : lagrangian.locked) {
    for (std::size_t i = 0; i < locked.values.size(); ++i) {
      values.emplace(symbols.q[locked.coordinate + i], locked.values[i]);
    }
    // A rotation can only be locked at constants.
    const ex rate =
        locked.is_rotation ? ex(0) : define(definitions, passing(locked.values.front()));
    const ex acceleration = define(definitions, passing(rate));
    for (std::uint32_t i = 0; i < locked.velocity_count(); ++i) {
      values.emplace(symbols.v[locked.velocity + i], rate);
      values.emplace(symbols.a[locked.velocity + i], acceleration);
    }
  }
  return values;
}

/// A copy of `lagrangian` with an empty list of definitions. Symbols in the copy still refer to the
/// list of `lagrangian`, to which definitions are only appended.
std::shared_ptr<const Lagrangian> without_definitions(Lagrangian& lagrangian) {
  Definitions definitions = std::move(lagrangian.definitions);
  lagrangian.definitions = {};
  auto copy = std::make_shared<const Lagrangian>(lagrangian);
  lagrangian.definitions = std::move(definitions);
  return copy;
}

}  // namespace

void apply_locks(UnreducedLagrangian& lagrangian) {
  for (const HeldCoordinateMotion& locked : lagrangian.locked) {
    for (const ex& value : locked.values) {
      const bool moves = dependence(lagrangian.definitions, value).has_any(Opcode::time);
      lagrangian.leaves.uses_time = lagrangian.leaves.uses_time || moves;
    }
  }
  ReactionSource holding;
  holding.velocities = velocities_with_reaction(lagrangian.locked);
  holding.values = locked_values(lagrangian);
  // Without the held inputs, the reaction is the whole force on a locked coordinate.
  for (const std::uint32_t input : lagrangian.held_inputs) {
    holding.values.emplace(lagrangian.symbols.u[input], 0);
  }
  if (!holding.velocities.empty()) holding.unreduced = without_definitions(lagrangian);
  remove_variables(lagrangian, lagrangian.locked, holding.values);
  if (holding.unreduced) lagrangian.reaction_source = std::move(holding);
}

}  // namespace elgen
