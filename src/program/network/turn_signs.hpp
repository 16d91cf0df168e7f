// turn_signs: a value that is only needed negative is computed negative, where a difference can
// turn for nothing.
//
//     before:  s = a - b   result -s        p = product(m, a - b)   result -p
//     after:   s = b - a   result s         p = product(m, b - a)   result p
#pragma once

#include "program/network/network.hpp"

namespace elgen {

void turn_signs(Network& network);

}  // namespace elgen
