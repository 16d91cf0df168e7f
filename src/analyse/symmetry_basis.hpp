// The basis of the symmetries of a system in the terms of mechanics.
#pragma once

#include <vector>

#include "analyse/generators.hpp"
#include "elgen/analyse.hpp"

namespace elgen {

/// The unknowns of one, in the order of the class.
using Generator = std::vector<Fraction>;

/// Replaces vectors of the basis by common rotations of all pairs, or triples, of coordinates where
/// these are symmetries. Every vector has a last unknown that no other has.
void prefer_common_rotations(ClosedForms& forms, const GeneratorClass& all,
                             std::vector<Generator>& basis);

/// The generator times the least product that leaves none of its unknowns a divisor.
[[nodiscard]] Generator without_divisors(ClosedForms& forms, Generator generator);

[[nodiscard]] SymmetryKind kind_of(ClosedForms& forms, const GeneratorClass& all,
                                   const Generator& generator);

}  // namespace elgen
