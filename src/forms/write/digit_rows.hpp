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

enum class RuleCondition : std::uint8_t { always, shorter, factored, anchored, computed };

/// A row of digit_rows.def.
struct RewriteRule {
  std::string_view from;
  std::string_view to;
  RuleCondition condition;
};

[[nodiscard]] std::span<const RewriteRule> rewrite_rules();

/// A row as terms over a graph in which the letters are coordinates.
struct RulePattern {
  std::vector<ScaledTerm> terms = {};  ///< the term with the most calls is first
  std::uint64_t functions = 0;         ///< the functions that the first term calls, as a bit set
  SignedNode to = {};
  RuleCondition condition = RuleCondition::always;

  /// True for one call and a constant: 1 - cos(a).
  [[nodiscard]] bool is_call_and_constant() const {
    return functions != 0 && terms.size() == 2 && terms[0].factors.size() == 1 &&
           terms[1].factors.empty();
  }
};

struct RulePatternTable {
  Graph graph = {};
  std::vector<RulePattern> rows = {};
};

[[nodiscard]] const RulePatternTable& rule_patterns();

/// The index of the letter a in the pattern a, f(a) or sqrt(a); none if `pattern` is a number.
[[nodiscard]] std::optional<std::size_t> pattern_variable(NodeId pattern);

/// The functions that a term calls, as a bit set.
[[nodiscard]] std::uint64_t called_function_bits(const Graph& graph, const ScaledTerm& term);

/// Applies a row that contains calls: the result of the row replaces the matching terms. Several
/// terms, with one call each, may share one constant. False if no row matches.
[[nodiscard]] bool rewrite_terms_by_rule(Graph& graph, RewriteOptions keeping,
                                         std::vector<SignedNode>& terms);

/// Rewrites x + y by a row without calls; none if no row matches.
[[nodiscard]] std::optional<SignedNode> rewrite_pair_by_rule(Graph& graph, RewriteOptions keeping,
                                                             const ScaledTerm& x,
                                                             const ScaledTerm& y);

/// Rewrites a call by a row of a single term; none if no row matches.
[[nodiscard]] std::optional<SignedNode> rewrite_call_by_rule(Graph& graph, RewriteOptions keeping,
                                                             NodeId call);

}  // namespace elgen
