// kept_digits: rewrites differences of nearly equal values so that nothing cancels.
//
//     before    sqrt(l^2 + x^2) - l           exp(x) - 1       log(1 + x)     1/(r - x) - 1/r
//     after     x^2/(sqrt(l^2 + x^2) + l)     expm1(x)         log1p(x)       x/(r (r - x))
//
// Each rewriting is equal to the original wherever the original is defined.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "program/graph/rebuild.hpp"

namespace elgen {

/// `factored`: differences of squares are factored too: a^2 - b^2 = (a - b) (a + b). The pattern
/// 1/sqrt(1 - a^2) - 1 is then no longer recognised.
enum class SquareHandling : std::uint8_t { unfactored, factored };

/// The state of one call of rewrite_to_keep_digits().
struct RewriteProgress {
  std::size_t remaining_sums = 0;                ///< how many sums may still be rewritten
  std::map<NodeId, SignedNode> logarithms = {};  ///< a call of asinh that is log(c)/2 -> c
};

/// How sums are rewritten, the depth of nested rewritings, and the progress, which may be null.
struct RewriteOptions {
  SquareHandling squares = SquareHandling::unfactored;
  int depth = 0;
  RewriteProgress* progress = nullptr;
};

/// The result of rewrite_to_keep_digits().
struct KeptDigits {
  std::optional<Expressions> rewriting = {};  ///< none if nothing is rewritten
  bool is_limited = false;                    ///< nothing is rewritten because of the limit
};

/// Rewrites terms of sums, and arguments of logarithms and arc cosines, that may cancel. Uses the
/// rows of digit_rows.def, kept_terms.hpp and
///
///     log(1 + a), log(a/b)        log1p(a), 2 asinh((a - b)/b/(2 sqrt(a/b)))
///     (l + x)^2 - l^2             2 l x + x^2
///
/// Gives up after a fixed number of rewritten sums, because quotients of sums of roots may produce
/// ever longer sums.
[[nodiscard]] KeptDigits rewrite_to_keep_digits(const Expressions& expressions,
                                                SquareHandling squares);

/// Rewrites one sum in its graph; none if nothing is rewritten.
[[nodiscard]] std::optional<SignedNode> rewrite_sum(Graph& graph, RewriteOptions options,
                                                    SignedNode value);

/// Replaces calls by other calls of `expressions` if nothing cancels in the replacements; none if
/// no call can be replaced:
///
///     expm1(a), exp(a)                 exp(a) = 1 + expm1(a)
///     sin(a/2), sin(a), cos(a)         sin(a) = 2 sin(a/2) cos(a/2), cos(a) = 1 - 2 sin(a/2)^2
[[nodiscard]] std::optional<Expressions> replace_redundant_calls(const Expressions& expressions);

}  // namespace elgen
