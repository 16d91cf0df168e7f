// Reaction: rows of the Lagrangian in which everything moves, then brought to where it stands.
//
//     before    row of q1: (I1 + I2 + ...)*q1_ddot + ... - tau1
//     after     the same with q1 = s(t), q1_dot = ds/dt, q1_ddot = d2s/dt2
#include "derive/outputs/reaction.hpp"

#include "derive/outputs/forces.hpp"

namespace elgen {

Vector reaction(Derivation& derivation) {
  const Holding& holding = *derivation.lagrangian.holding;
  Lagrangian whole = *holding.whole;
  whole.definitions = derivation.definitions;
  Derivation moving(whole);
  const Vector rows = residual(moving, InputForces::acting, Bodies::all);
  Substitution standing(moving.definitions, holding.values);
  Vector result;
  for (const std::uint32_t velocity : holding.velocities) {
    const GiNaC::ex row = define(moving.definitions, rows[velocity]);
    result.push_back(standing(row));
  }
  // Only appended to, so that what the derivation knows of earlier ones stays true.
  derivation.definitions = std::move(moving.definitions);
  return result;
}

}  // namespace elgen
