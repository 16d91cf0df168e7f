// factor: the factor common to most terms of a sum is multiplied once.
//
//     before:  m*a*c + m*b*c - d
//     after:   m*c*(a + b) - d
//
// Only products used nowhere else take part, since a shared product is paid for anyway. Greedy: the
// factor that most terms have goes first (the earlier in the order of the graph on a tie), then
// what is left, inside and outside.
#pragma once

#include "program/graph/rebuild.hpp"

namespace elgen {

[[nodiscard]] Expressions factor(const Expressions& expressions);

}  // namespace elgen
