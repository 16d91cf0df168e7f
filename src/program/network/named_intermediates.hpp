// named_intermediates: gives unnamed instructions the names of intermediate values. Passes change
// the instructions that derive produced, so the quantities that derive named are found again by
// their values at random leaves. The new names begin with intermediate_mark.
//
//     derived      moment_link5_y = m*l*cos(a + b)
//     after passes l*(cos(a)*cos(b) - sin(a)*sin(b))*m   is named   ~moment_link5_y
//                  -m*l*cos(a + b)                       is named   ~minus_moment_link5_y
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "program/graph/rebuild.hpp"

namespace elgen {

/// Magnitude of a value at random leaves -> its name, and true if the value is negative.
using NamedIntermediates = std::map<double, std::pair<std::string, bool>>;

/// The values of `named` and their names, one name per value: of equal values, only the first.
[[nodiscard]] NamedIntermediates named_intermediates(const Expressions& named,
                                                     const std::vector<std::string>& names,
                                                     const LeafNames& leaves);

/// Gives each unnamed instruction the name of the intermediate with the same value in `told`. The
/// leaves of `program` must be the `leaves` of named_intermediates().
void name_intermediates(const NamedIntermediates& named, const Program& program,
                        Function& function);

}  // namespace elgen
