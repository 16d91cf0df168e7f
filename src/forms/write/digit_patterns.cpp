// digit_patterns: parses the rows of digit_rows.def into terms over a common graph.
#include <algorithm>
#include <array>
#include <string>

#include "forms/write/digit_rows.hpp"
#include "program/graph/graph_reader.hpp"

namespace elgen {
namespace {

constexpr std::array rule_table{
#define ELGEN_DIGIT_ROW(from, to, condition) RewriteRule{from, to, RuleCondition::condition},
#include "forms/write/digit_rows.def"
#undef ELGEN_DIGIT_ROW
};

RulePattern parse_rule(Graph& graph, const RewriteRule& row) {
  const std::vector<std::string> letters{"a", "b", "c"};
  const SignedNode from = read_value(graph, std::string(row.from), letters).value();
  const SignedNode to = read_value(graph, std::string(row.to), letters).value();
  const GraphTermBuilder reader(graph);
  RulePattern pattern{.to = to, .condition = row.condition};
  const bool is_sum = graph.node(from.node).kind == NodeKind::sum;
  for (const SignedNode term :
       is_sum ? reader.terms_of(from.node) : std::vector<SignedNode>{from}) {
    pattern.terms.push_back(reader.split_term(negate_if(term, is_sum && from.is_negative)));
  }
  // The number of calls if all factors are calls of letters; otherwise 0.
  const auto calls = [&graph](const ScaledTerm& term) {
    const auto count = std::ranges::count_if(term.factors, [&graph](const Operand& factor) {
      return graph.node(factor.node).kind == NodeKind::call && !graph.is_constant(factor.node);
    });
    return static_cast<std::size_t>(count) == term.factors.size() ? count : 0;
  };
  std::iter_swap(pattern.terms.begin(), std::ranges::max_element(pattern.terms, {}, calls));
  pattern.functions = called_function_bits(graph, pattern.terms.front());
  return pattern;
}

}  // namespace

std::span<const RewriteRule> rewrite_rules() { return rule_table; }

const RulePatternTable& rule_patterns() {
  static const RulePatternTable all = [] {
    RulePatternTable table;
    for (const RewriteRule& row : rule_table) table.rows.push_back(parse_rule(table.graph, row));
    return table;
  }();
  return all;
}

std::optional<std::size_t> pattern_variable(NodeId pattern) {
  const Graph& graph = rule_patterns().graph;
  const Node& node = graph.node(pattern);
  const Node& inner = node.operands.empty() ? node : graph.node(node.operands[0].node);
  return inner.kind == NodeKind::leaf ? std::optional<std::size_t>(inner.index) : std::nullopt;
}

std::uint64_t called_function_bits(const Graph& graph, const ScaledTerm& term) {
  std::uint64_t functions = 0;
  for (const Operand& factor : term.factors) {
    const Node& node = graph.node(factor.node);
    if (node.kind == NodeKind::call)
      functions |= std::uint64_t{1} << static_cast<int>(node.function);
  }
  return functions;
}

}  // namespace elgen
