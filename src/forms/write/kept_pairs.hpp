// kept_pairs: two terms of a sum that may cancel, by rows, and by what rows cannot say:
//
//     before    a^2 - b^2 sin(c)^2            a - b cos(c)                             1/a - 1/b
//     after     (a - b) (a + b) + b^2 cos(c)^2    (a - b) cos(c/2)^2 + (a + b) sin(c/2)^2    (b -
//     a)/(a b)
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "forms/write/graph_terms.hpp"
#include "forms/write/kept_digits.hpp"

namespace elgen {

/// Two of the terms of a sum as one; none where nothing of the kind is found. Cranks are sums of
/// two terms alone.
[[nodiscard]] std::optional<Ref> kept_pair(Graph& graph, Keeping keeping,
                                           const std::vector<ScaledTerm>& terms, std::size_t first,
                                           std::size_t second);

}  // namespace elgen
