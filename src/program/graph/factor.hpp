// factor: multiplies a sum once by the factor that most of its terms share.
//
//     before:  m*a*c + m*b*c - d
//     after:   m*c*(a + b) - d
//
// Only products used nowhere else take part, because a shared product is computed anyway. Greedy:
// the factor that most terms have goes first, on a tie the earlier factor in the order of the
// graph. Then the inner sum and the remaining terms are factored.
//
// flatten, the inverse: expands a sum that is used once, as a term of a sum, and a product that is
// used once, as a factor of a product.
//
//     before:  p = a + b   s = p - c   t = m*u   w = t*x     (p and t used nowhere else)
//     after:               s = a + b - c          w = m*u*x
//
// A sum or product with two uses stays, because expanding it would compute it twice. `all_products`
// expands every product, so that factors of sums meet; common-subexpression elimination restores
// the shared products that pay.
#pragma once

#include "program/graph/rebuild.hpp"

namespace elgen {

[[nodiscard]] Expressions factor(const Expressions& expressions);

/// Products that are expanded in products. Sums are expanded only if they are used once.
enum class FlattenedProducts : std::uint8_t { used_once, all_products };

[[nodiscard]] Expressions flatten(const Expressions& expressions,
                                  FlattenedProducts which = FlattenedProducts::used_once);

}  // namespace elgen
