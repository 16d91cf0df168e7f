// factor: pulls the factor that most terms of a sum share out of these terms.
//
//     before:  m*a*c + m*b*c - d
//     after:   m*c*(a + b) - d
//
// Only products that are used nowhere else are factored, because a shared product is computed
// anyway. Greedy: the factor of most terms is pulled out first; of several such factors, the first
// in the order of the graph. Then the inner sum and the remaining terms are factored.
//
// flatten, the inverse: if a sum is used only once, as a term of a sum, its terms move to the outer
// sum. If a product is used only once, as a factor of a product, its factors move to the outer
// product.
//
//     before:  p = a + b   s = p - c   t = m*u   w = t*x     (p and t used nowhere else)
//     after:               s = a + b - c          w = m*u*x
//
// A sum or product with two uses stays, because expanding it would compute it twice. `all_products`
// expands every product, so that factor sees all factors of each term; common-subexpression
// elimination restores the shared products that pay.
#pragma once

#include "program/graph/rebuild.hpp"

namespace elgen {

[[nodiscard]] Expressions factor(const Expressions& expressions);

/// The products that are expanded inside other products: products used only once, or all products.
/// A sum is expanded inside another sum only if it is used once.
enum class FlattenedProducts : std::uint8_t { used_once, all_products };

[[nodiscard]] Expressions flatten(const Expressions& expressions,
                                  FlattenedProducts which = FlattenedProducts::used_once);

}  // namespace elgen
