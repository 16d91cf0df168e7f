// kept_digits: differences of nearly equal values, written so that nothing cancels.
//
//     before    sqrt(l^2 + x^2) - l           exp(x) - 1       log(1 + x)     1/(r - x) - 1/r
//     after     x^2/(sqrt(l^2 + x^2) + l)     expm1(x)         log1p(x)       x/(r (r - x))
//
// Each is equal to what it replaces wherever that has a value.
#pragma once

#include <cstdint>
#include <optional>

#include "program/graph/rebuild.hpp"

namespace elgen {

/// Whether differences of squares are taken apart. Then 1/sqrt(1 - a^2) - 1, whose radicand is one,
/// has no other form.
enum class Squares : std::uint8_t { whole, apart };

/// How a sum is rewritten, and how deep it stands in what was written for others.
struct Keeping {
  Squares squares = Squares::whole;
  int depth = 0;
};

/// In every sum the terms, and in every logarithm and arc cosine the argument, that may cancel, by
/// the rows of digit_rows.def, by kept_terms.hpp, and, for a common factor C:
///
///     C sqrt(a) - b               (C^2 a - b^2)/(C sqrt(a) + b)   where that is shorter
///     log(1 + a), log(a/b)        log1p(a), log1p((a - b)/b)
///     (l + x)^2 - l^2             2 l x + x^2
///
/// None where there is none.
[[nodiscard]] std::optional<Expressions> with_kept_digits(const Expressions& expressions,
                                                          Squares squares);

/// One sum, so rewritten in the graph that it stands in.
[[nodiscard]] std::optional<Ref> kept_sum(Graph& graph, Keeping keeping, Ref value);

/// With fewer calls, where the calls that keep digits stand beside others of the same argument;
/// none where there are none:
///
///     expm1(a), exp(a)                  1 + expm1(a) for exp(a)
///     sin(a/2), sin(a), cos(a)          2 sin(a/2) cos(a/2) and 1 - 2 sin(a/2)^2 for the others
[[nodiscard]] std::optional<Expressions> with_fewer_calls(const Expressions& expressions);

}  // namespace elgen
