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

/// Puts the terms together that a row with calls stands for, or those that share one constant;
/// false where there are none.
[[nodiscard]] bool replace_by_row(Graph& graph, Keeping keeping, std::vector<Ref>& terms);

/// x + y by a row without calls.
[[nodiscard]] std::optional<Ref> pair_by_row(Graph& graph, Keeping keeping, const ScaledTerm& x,
                                             const ScaledTerm& y);

/// A call by a row of its own.
[[nodiscard]] std::optional<Ref> call_by_row(Graph& graph, Keeping keeping, NodeId call);

}  // namespace elgen
