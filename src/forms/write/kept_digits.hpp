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

/// In every sum the pairs of terms, and in every logarithm the argument, that may cancel; none
/// where there is none. For a common factor C, angles or arguments a and b:
///
///     C sqrt(a) - b               (C^2 a - b^2)/(C sqrt(a) + b)   where that is shorter
///     1/a - 1/b                   (b - a)/(a b)
///     a^2 - b^2                   (a - b) (a + b)
///     exp(a) - 1, exp(a) - exp(b) expm1(a), 2 exp((a + b)/2) sinh((a - b)/2)
///     log(1 + a), log(a) - log(b) log1p(a), log1p((a - b)/b), which is log(a/b), too
///     1 - cos(a), cosh(a) - 1     2 sin(a/2)^2, 2 sinh(a/2)^2
///     1 - tanh(a)                 2/(1 + exp(2 a))
///     sin(a) - sin(b), cos(a) - cos(b), sinh, cosh, tan     products
///     atan(a) - atan(b)           atan2(a - b, 1 + a b)
///     pi/2 - atan(a)              atan2(1, a)
///     1 - cos(a) cos(b)           sin((a + b)/2)^2 + sin((a - b)/2)^2
///     a - sin(a)                  a^3 stumpff(a, 3)
///     a^2 + b^2 - 2 a b cos(c)    (a - b)^2 + 4 a b sin(c/2)^2, with + the cosine of c/2
[[nodiscard]] std::optional<Expressions> with_kept_digits(const Expressions& expressions,
                                                          Squares squares);

/// With fewer calls, where the calls that keep digits stand beside others of the same argument;
/// none where there are none:
///
///     expm1(a), exp(a)                  1 + expm1(a) for exp(a)
///     sin(a/2), sin(a), cos(a)          2 sin(a/2) cos(a/2) and 1 - 2 sin(a/2)^2 for the others
[[nodiscard]] std::optional<Expressions> with_fewer_calls(const Expressions& expressions);

}  // namespace elgen
