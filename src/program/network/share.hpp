// share: sub-sums and sub-products that several operations have in common are computed once.
//
//     before:  y = product(m, l, c)   z = product(m, l, s)
//     after:   p = product(m, l)   y = product(p, c)   z = product(p, s)
//
// The only common-subexpression elimination. Greedy: the pair of operands found in most operations
// becomes an operation; pairs of a sum count up to sign, a - b as b - a. Ties go to the pair that
// comes first in the network.
#pragma once

#include "program/network/network.hpp"

namespace elgen {

void share(Network& network);

}  // namespace elgen
