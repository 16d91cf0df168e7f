// consequences: what was dropped from the parts -> what every output loses by it.
//
//     M loses dM, V0 loses dV     ->     C loses the Christoffel matrix of dM, p loses dM v,
//                                        T loses 1/2 v.dM v, g loses d(dV)/dq, tau loses dM a + …
//
// All of it is linear in what was dropped, so that what remains is the system without it. The
// derivation has routes of its own to C, g and bias, along the bodies of a Lagrangian; they are not
// taken here on purpose: no Lagrangian has the reduced M, and the terms of these sums are what is
// listed and bounded.
#pragma once

#include <map>

#include "present/arithmetic.hpp"

namespace elgen {

using Values = std::vector<Value>;

/// The terms dropped from each entry of M, V0, dD/dv, Q and B, of those that have terms to drop.
using DroppedParts = std::map<OutputKind, Values>;

class Consequences {
 public:
  /// Of a model without rotations; `size` velocities.
  Consequences(Arithmetic& arithmetic, const Algebra& algebra, std::size_t size,
               const DroppedParts& dropped);

  /// One value per entry of the output, 0 where it loses nothing; empty for outputs that are never
  /// reduced. Each is computed once.
  [[nodiscard]] const Values& of(OutputKind output) &;

 private:
  Values found(OutputKind output);
  Value slope(const Value& x, std::size_t coordinate);
  Values times(const Values& matrix, Opcode vector);
  Values sum(Values x, const Values& y, int sign = 1);
  [[nodiscard]] static Values zeros(std::size_t count) { return Values(count, Fraction{}); }

  Values coriolis();
  Values gravity();
  Values drift();
  Values position_gradient();
  Values bias();
  Values inverse_dynamics();
  Values energy();
  Values kinetic_energy();

  Arithmetic& arithmetic_;
  const Algebra& algebra_;
  std::size_t size_;
  std::map<OutputKind, Values> known_;
};

}  // namespace elgen
