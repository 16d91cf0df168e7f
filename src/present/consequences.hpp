// consequences: what was dropped from the parts -> what every output loses by it.
//
//     M loses dM, V0 loses dV     ->     C loses the Christoffel matrix of dM, p loses dM v,
//                                        T loses 1/2 v.dM v, g loses d(dV)/dq, tau loses dM a + …
//
// All of it is linear in what was dropped, so that what remains is the system without it.
#pragma once

#include <map>

#include "arithmetic.hpp"

namespace elgen::presenting {

using Values = std::vector<Value>;

/// What was dropped of each entry; empty where nothing of a part can be.
struct DroppedParts {
  Values mass_matrix = {};
  Values potential_energy = {};
  Values dissipation = {};
  Values applied_force = {};
  Values input_matrix = {};
};

class Consequences {
 public:
  /// Of a model without rotations; `size` velocities.
  Consequences(Arithmetic& arithmetic, const Algebra& algebra, std::size_t size,
               const DroppedParts& dropped)
      : arithmetic_(arithmetic), algebra_(algebra), size_(size), dropped_(dropped) {}

  /// One value per entry of the output, 0 where it loses nothing; empty for outputs that are never
  /// reduced. Each is computed once.
  [[nodiscard]] const Values& of(OutputKind output) &;

 private:
  Values found(OutputKind output);
  [[nodiscard]] Value mass(std::size_t i, std::size_t j) const;
  Value slope(const Value& x, std::size_t coordinate);
  Values times(const Values& matrix, Opcode vector);
  Values sum(Values x, const Values& y, int sign = 1);
  Values zeros(std::size_t count) const { return Values(count, Fraction{}); }

  Values coriolis();
  Values gravity();
  Values drift();
  Values bias();
  Values kinetic_energy();
  Values or_zeros(const Values& part, std::size_t count) const;

  Arithmetic& arithmetic_;
  const Algebra& algebra_;
  std::size_t size_;
  const DroppedParts& dropped_;
  std::map<OutputKind, Values> known_ = {};
};

}  // namespace elgen::presenting
