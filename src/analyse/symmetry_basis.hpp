// A basis of symmetries with mechanical meaning: translations, common rotations, boosts, time.
#pragma once

#include <vector>

#include "analyse/generators.hpp"
#include "elgen/analyse.hpp"

namespace elgen {

/// The unknowns of a generator, in the order of GeneratorLayout.
using Generator = std::vector<Fraction>;

/// Replaces basis vectors by common rotations of all pairs, or triples, of coordinates, if these
/// rotations are symmetries. Requires that the last non-zero unknown of each vector is 0 in all
/// other vectors.
void prefer_common_rotations(ClosedForms& forms, const GeneratorLayout& layout,
                             std::vector<Generator>& basis);

/// The generator, multiplied by the smallest product that clears the divisors of its unknowns.
[[nodiscard]] Generator without_divisors(ClosedForms& forms, Generator generator);

[[nodiscard]] SymmetryKind kind_of(ClosedForms& forms, const GeneratorLayout& all,
                                   const Generator& generator);

}  // namespace elgen
