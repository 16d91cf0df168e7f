// digit_rows: rewrites terms of a sum, and calls, by the rows of digit_rows.def.
//
//     before    2*k - k*cos(x) - k*cos(y)
//     after     2*k*sin(x/2)^2 + 2*k*sin(y/2)^2
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "forms/write/graph_terms.hpp"
#include "forms/write/kept_digits.hpp"

namespace elgen {

enum class RowCondition : std::uint8_t { always, shorter, factored, anchored, computed };

/// A row of digit_rows.def.
struct DigitRow {
  std::string_view from;
  std::string_view to;
  RowCondition condition;
};

[[nodiscard]] std::span<const DigitRow> digit_rows();

/// A row as terms over a graph in which the letters are coordinates.
struct DigitPattern {
  std::vector<ScaledTerm> terms = {};  ///< the term with the most calls is first
  std::uint64_t functions = 0;         ///< called by the first term, as a bit set
  Ref to = {};
  RowCondition condition = RowCondition::always;

  /// True for one call and a constant: 1 - cos(a).
  [[nodiscard]] bool is_unit() const {
    return functions != 0 && terms.size() == 2 && terms[0].factors.size() == 1 &&
           terms[1].factors.empty();
  }
};

struct DigitPatterns {
  Graph graph = {};
  std::vector<DigitPattern> rows = {};
};

[[nodiscard]] const DigitPatterns& digit_patterns();

/// The index of the letter in a pattern: a letter, or a call or root of a letter; none for numbers.
[[nodiscard]] std::optional<std::size_t> letter_of(NodeId pattern);

/// The functions that a term calls, as a bit set.
[[nodiscard]] std::uint64_t functions_of(const Graph& graph, const ScaledTerm& term);

/// Replaces terms that match a row with calls, or several terms with one call each that share one
/// constant. False if no row matches.
[[nodiscard]] bool replace_by_row(Graph& graph, RewriteOptions keeping, std::vector<Ref>& terms);

/// Rewrites x + y by a row without calls; none if no row matches.
[[nodiscard]] std::optional<Ref> pair_by_row(Graph& graph, RewriteOptions keeping,
                                             const ScaledTerm& x, const ScaledTerm& y);

/// Rewrites a call by a row of a single term; none if no row matches.
[[nodiscard]] std::optional<Ref> call_by_row(Graph& graph, RewriteOptions keeping, NodeId call);

}  // namespace elgen
