// kept_terms: rewritings of cancelling sums that a row of digit_rows.def cannot express:
// triangles, pairs, roots, logarithms, sums of powers.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "forms/write/graph_terms.hpp"
#include "forms/write/kept_digits.hpp"

namespace elgen {

/// The law of cosines without cancellation if a and b are nearly equal:
///
///     before    C a^2 + C b^2 - 2 C a b cos(c)
///     after     C ((a - b)^2 + 4 a b sin(c/2)^2)
///
/// SquareHandling::factored gives C ((a - b)^2 cos(c/2)^2 + (a + b)^2 sin(c/2)^2) instead, which
/// keeps all digits for any signs of a and b. For + 2 C a b cos(c), the sine and the cosine of c/2
/// are exchanged. Replaces three matching terms by one; false if no three terms match.
[[nodiscard]] bool replace_triangle(Graph& graph, RewriteOptions keeping,
                                    std::vector<SignedNode>& terms);

/// Combines two terms of a sum by rows without calls, or by rewritings that rows cannot express:
///
///     before    1/a - 1/b        a^2 - b^2 sin(c)^2
///     after     (b - a)/(a b)    (a - b) (a + b) + b^2 cos(c)^2
///
/// The second rewriting applies only to sums of exactly two terms, with SquareHandling::factored.
/// None if no rewriting applies.
[[nodiscard]] std::optional<SignedNode> rewrite_pair(Graph& graph, RewriteOptions keeping,
                                                     const std::vector<ScaledTerm>& terms,
                                                     std::size_t first, std::size_t second);

/// Rewrites a sum by its conjugate if exactly one term is a product with `roots` square roots:
///
///     before    C sqrt(a) - b                      sqrt(a) sqrt(b) - c
///     after     (C^2 a - b^2)/(C sqrt(a) + b)      (a b - c^2)/(sqrt(a) sqrt(b) + c)
[[nodiscard]] std::optional<SignedNode> rewrite_by_conjugate(Graph& graph, RewriteOptions keeping,
                                                             const std::vector<SignedNode>& terms,
                                                             std::ptrdiff_t roots);

/// Replaces logarithms whose linear parts cancel other terms, with R(c) = c - 1 - log(c) written
/// without cancellation; false if there are none:
///
///     before    a - log1p(a)    x/y - 1 - log(x/y)    (1 + a) log1p(a) - a     x log(x/y) - x + y
///     after     R(1 + a)        R(x/y)                (1 + a) R(1/(1 + a))     x R(y/x)
[[nodiscard]] bool replace_logarithms(Graph& graph, RewriteOptions keeping,
                                      std::vector<SignedNode>& terms);

/// log(a) for a = 1 + `less`: log1p(less) if less >= 0. Otherwise log1p(less) keeps no digit of a
/// small a, but 2 asinh(less/(2 sqrt(a))) does, because 2 sinh(log(a)/2) = sqrt(a) - 1/sqrt(a).
[[nodiscard]] SignedNode logarithm_near_one(Graph& graph, RewriteOptions keeping, SignedNode a,
                                            SignedNode less);

/// A quotient near 1 without its cancellation: above/below = 1 + less.
struct QuotientNearOne {
  SignedNode above = {};
  SignedNode below = {};
  SignedNode less = {};
};

/// b - L with L = log(1 + b), the value `logarithm`, and w = sqrt(1 + b), for ratio = 1 + b.
/// The largest measured error is 9 u for 1 + b from 1e-8 to 1e15.
///
///     (b^2 (1 - L/(1 + w)^2) + w L^3 stumpff(L/2, -3)/2)/(2 + b)
[[nodiscard]] SignedNode logarithm_remainder(Graph& graph, const QuotientNearOne& ratio,
                                             SignedNode logarithm);

/// Factors a sum of 3 to 30 terms that has a repeated factor: a common divisor of the sum and of
/// its derivative with respect to a coordinate or a call. Factors the whole sum, or only the terms
/// in which no other coordinate or call occurs:
///
///     before    x^4 - 2*a^2*x^2 + a^4    1/r^2 - 2/(p*r) + 1/p^2    exp(-2*x) - 2*exp(-x) + 1
///     after     (x^2 - a^2)^2            (r - p)^2/(p^2*r^2)        expm1(-x)^2
///
/// The base of each power is rewritten by rewrite_sum(). None if no factor is repeated.
[[nodiscard]] std::optional<SignedNode> factor_square_free(Graph& graph, RewriteOptions keeping,
                                                           const std::vector<SignedNode>& terms);

}  // namespace elgen
