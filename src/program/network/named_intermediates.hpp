// named_intermediates: passes change the instructions of the derivation. Its named intermediates
// are found again by their numeric values, to name instructions that have no name.
//
//     moment_link5_y = m*l*cos(a + b)       ~moment_link5_y of  l*(cos(a)*cos(b) - sin(a)*sin(b))*m
//                                           ~minus_moment_link5_y of its opposite
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "program/graph/rebuild.hpp"

namespace elgen {

/// Magnitude with random leaves -> the name, and whether the value is negative.
using NamedIntermediates = std::map<double, std::pair<std::string, bool>>;

/// `names`: one for each value of `told`. Of equal values the first name counts.
[[nodiscard]] NamedIntermediates named_intermediates(const Expressions& told,
                                                     const std::vector<std::string>& names,
                                                     const LeafNames& leaves);

/// Names the instructions without a name. The leaves of `program` must be the `leaves` of
/// named_intermediates.
void name_intermediates(const NamedIntermediates& told, const Program& program, Function& function);

}  // namespace elgen
