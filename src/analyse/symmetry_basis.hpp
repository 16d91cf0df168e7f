// The symmetries of a system in a basis with meaning in mechanics.
#pragma once

#include <vector>

#include "analyse/generators.hpp"
#include "elgen/analyse.hpp"

namespace elgen {

/// The unknowns of a generator in the order of the class.
using Generator = std::vector<Fraction>;

/// Replaces basis vectors by common rotations of all pairs, or triples, of coordinates if these are
/// symmetries. Each vector has a last unknown that is 0 in all others.
void prefer_common_rotations(ClosedForms& forms, const GeneratorClass& all,
                             std::vector<Generator>& basis);

/// The generator times the smallest product that clears the divisors of its unknowns.
[[nodiscard]] Generator without_divisors(ClosedForms& forms, Generator generator);

[[nodiscard]] SymmetryKind kind_of(ClosedForms& forms, const GeneratorClass& all,
                                   const Generator& generator);

}  // namespace elgen
