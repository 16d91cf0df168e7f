// square_free: a sum of powers, by what it shares with its derivative in one coordinate.
//
//     before    x^4 - 2*a^2*x^2 + a^4      1/r^2 - 2/(p*r) + 1/p^2
//     after     (x^2 - a^2)^2              (r - p)^2/(p^2*r^2)
#pragma once

#include <optional>
#include <vector>

#include "forms/write/kept_digits.hpp"

namespace elgen {

/// The sum of 3 to 30 terms where it has a repeated factor: as a whole, or those of its terms that
/// hold one coordinate alone. Bases are kept in their turn.
[[nodiscard]] std::optional<Ref> square_free(Graph& graph, Keeping keeping,
                                             const std::vector<Ref>& terms);

}  // namespace elgen
