// digit_rows: terms of a sum, and calls, rewritten by the rows of digit_rows.def.
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

enum class RowCondition : std::uint8_t { always, shorter, apart, anchored, computed };

/// As digit_rows.def has it.
struct DigitRow {
  std::string_view from;
  std::string_view to;
  RowCondition condition;
};

[[nodiscard]] std::span<const DigitRow> digit_rows();

/// A row as terms of a graph, whose coordinates are the letters.
struct DigitPattern {
  std::vector<ScaledTerm> terms = {};  ///< first the one that is looked for first
  std::uint64_t functions = 0;         ///< that it calls, as bits
  Ref to = {};
  RowCondition condition = RowCondition::always;

  /// One call, and a constant.
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

/// The letter itself, or that of a call or root of one; none of numbers.
[[nodiscard]] std::optional<std::size_t> letter_of(NodeId pattern);

/// The functions that a term calls, as bits.
[[nodiscard]] std::uint64_t functions_of(const Graph& graph, const ScaledTerm& term);

/// Puts the terms together that a row with calls stands for, or those that share one constant;
/// false where there are none.
[[nodiscard]] bool replace_by_row(Graph& graph, Keeping keeping, std::vector<Ref>& terms);

/// x + y by a row without calls.
[[nodiscard]] std::optional<Ref> pair_by_row(Graph& graph, Keeping keeping, const ScaledTerm& x,
                                             const ScaledTerm& y);

/// A call by a row of its own.
[[nodiscard]] std::optional<Ref> call_by_row(Graph& graph, Keeping keeping, NodeId call);

}  // namespace elgen
