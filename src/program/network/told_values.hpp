// told_values: passes make other instructions of what was derived; by their values, names are found
// again for those that have none.
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

/// By magnitude, where all leaves are drawn at random: the name, and whether the value is negative.
using ToldValues = std::map<double, std::pair<std::string, bool>>;

/// `names`: of the values of `told`, one each; the first of those that have one value counts.
[[nodiscard]] ToldValues told_values(const Expressions& told, const std::vector<std::string>& names,
                                     const LeafNames& leaves);

/// The leaves of the program are those of told_values.
void name_told(const ToldValues& told, const Program& program, Function& function);

}  // namespace elgen
