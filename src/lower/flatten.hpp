// flatten: a sum used once, as a term of a sum, is written out there; likewise a product in a
// product.
//
//     before:  p = a + b   s = p - c   t = m*u   w = t*x     (p and t used nowhere else)
//     after:               s = a + b - c          w = m*u*x
//
// What is used twice stays: writing it out would compute it twice.
#pragma once

#include "rebuild.hpp"

namespace elgen {

[[nodiscard]] Expressions flatten(const Expressions& expressions);

}  // namespace elgen
