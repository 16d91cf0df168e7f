// digit_patterns: the rows of digit_rows.def as terms of a graph of their own, whose coordinates
// are the letters.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "forms/write/digit_rows.hpp"

namespace elgen {

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

}  // namespace elgen
