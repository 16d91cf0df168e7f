// kept_terms: what is written for some terms of a sum that may cancel, beside the rows of
// digit_rows.def: triangles, pairs, sums of powers.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "forms/write/graph_terms.hpp"
#include "forms/write/kept_digits.hpp"

namespace elgen {

/// The law of cosines without what cancels where a and b are alike:
///
///     before    C a^2 + C b^2 - 2 C a b cos(c)
///     after     C ((a - b)^2 + 4 a b sin(c/2)^2)
///
/// Where squares are taken apart it is C ((a - b)^2 cos(c/2)^2 + (a + b)^2 sin(c/2)^2), which has
/// all digits whatever the signs of a and b are. With + the sine and the cosine of c/2 change
/// places. Puts three such terms together as one; false where there are none.
[[nodiscard]] bool replace_triangle(Graph& graph, Keeping keeping, std::vector<Ref>& terms);

/// Two of the terms of a sum as one, by rows without calls, and by what rows cannot say:
///
///     before    1/a - 1/b        a^2 - b^2 sin(c)^2
///     after     (b - a)/(a b)    (a - b) (a + b) + b^2 cos(c)^2
///
/// The second is of sums of two terms alone, where squares are taken apart. None where there is
/// nothing of the kind.
[[nodiscard]] std::optional<Ref> kept_pair(Graph& graph, Keeping keeping,
                                           const std::vector<ScaledTerm>& terms, std::size_t first,
                                           std::size_t second);

/// A sum of 3 to 30 terms that has a repeated factor, by what it shares with its derivative in one
/// coordinate, as a whole, or those of its terms that hold one coordinate alone:
///
///     before    x^4 - 2*a^2*x^2 + a^4      1/r^2 - 2/(p*r) + 1/p^2
///     after     (x^2 - a^2)^2              (r - p)^2/(p^2*r^2)
///
/// Bases are kept in their turn.
[[nodiscard]] std::optional<Ref> square_free(Graph& graph, Keeping keeping,
                                             const std::vector<Ref>& terms);

}  // namespace elgen
