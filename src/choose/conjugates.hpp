// conjugates: differences with a root, where both sides are nearly the same.
//
//     before    sqrt(l^2 + x^2) - l                 no digit is right where x is small
//     after     x^2/(sqrt(l^2 + x^2) + l)
#pragma once

#include <optional>

#include "lower/graph/rebuild.hpp"

namespace elgen {

/// Sums of a root and other terms, whose squares differ by less than they hold; nothing where there
/// is none.
[[nodiscard]] std::optional<Expressions> with_conjugates(const Expressions& expressions);

}  // namespace elgen
