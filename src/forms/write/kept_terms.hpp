// kept_terms: rewritings of cancelling sums that a row of digit_rows.def cannot express:
// triangles, pairs, sums of powers.
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

/// Factors a sum of 3 to 30 terms that has a repeated factor: a common divisor of the sum and of
/// its derivative with respect to a coordinate or an exponential. Factors the whole sum, or only
/// the terms in which no other coordinate occurs:
///
///     before    x^4 - 2*a^2*x^2 + a^4      1/r^2 - 2/(p*r) + 1/p^2
///     after     (x^2 - a^2)^2              (r - p)^2/(p^2*r^2)
///
/// The base of each power is rewritten by rewrite_sum(). None if no factor is repeated.
[[nodiscard]] std::optional<SignedNode> factor_square_free(Graph& graph, RewriteOptions keeping,
                                                           const std::vector<SignedNode>& terms);

}  // namespace elgen
