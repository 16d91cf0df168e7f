// factor: the factor common to most terms of a sum is multiplied once.
//
//     before:  m*a*c + m*b*c - d
//     after:   m*c*(a + b) - d
//
// Only products used nowhere else take part, since a shared product is paid for anyway. Greedy: the
// factor that most terms have goes first (the earlier in the order of the graph on a tie), then
// what is left, inside and outside.
//
// flatten, the inverse: a sum used once, as a term of a sum, is written out there; likewise a
// product in a product.
//
//     before:  p = a + b   s = p - c   t = m*u   w = t*x     (p and t used nowhere else)
//     after:               s = a + b - c          w = m*u*x
//
// A sum or product used twice stays: writing it out would compute it twice. With `all_products`,
// products are written out wherever they stand, so that factors of sums meet; sharing finds again
// what was worth it.
#pragma once

#include "program/graph/rebuild.hpp"

namespace elgen {

[[nodiscard]] Expressions factor(const Expressions& expressions);

/// Which products are written out in products; sums only where they are used once.
enum class Flattened : std::uint8_t { used_once, all_products };

[[nodiscard]] Expressions flatten(const Expressions& expressions,
                                  Flattened which = Flattened::used_once);

}  // namespace elgen
