// flatten: see flatten.hpp. The normal forms of sums and products then merge what has met.
#include "flatten.hpp"

namespace elgen {
namespace {

class Flattening {
 public:
  explicit Flattening(const Expressions& expressions)
      : uses_(use_counts(expressions.graph, expressions.values)) {}

  Ref operator()(Graph& graph, const RebuildStep& step) const {
    const NodeKind kind = step.old_graph.node(step.old_node).kind;
    if (kind == NodeKind::sum) return sum(graph, step);
    if (kind == NodeKind::product) return product(graph, step);
    return copy(graph, step);
  }

 private:
  /// Used once, and still of its user's kind after its own renewal.
  bool is_spliced(const Graph& graph, const RebuildStep& step, const Operand& operand) const {
    const NodeKind kind = step.old_graph.node(step.old_node).kind;
    return uses_[operand.node] == 1 && step.old_graph.node(operand.node).kind == kind &&
           graph.node(step.renewed[operand.node].node).kind == kind;
  }

  Ref sum(Graph& graph, const RebuildStep& step) const {
    std::vector<Ref> terms;
    for (const Operand& operand : step.old_graph.node(step.old_node).operands) {
      const Ref renewed = with_sign(step.renewed[operand.node], operand.weight < 0);
      if (!is_spliced(graph, step, operand)) {
        terms.push_back(renewed);
        continue;
      }
      for (const Operand& term : graph.node(renewed.node).operands) {
        terms.push_back({term.node, (term.weight < 0) != renewed.negative});
      }
    }
    return graph.sum(terms);
  }

  Ref product(Graph& graph, const RebuildStep& step) const {
    std::vector<Power> factors;
    bool negative = false;
    for (const Operand& operand : step.old_graph.node(step.old_node).operands) {
      const Ref renewed = step.renewed[operand.node];
      if (operand.weight != 1 || !is_spliced(graph, step, operand)) {
        factors.push_back({renewed, operand.weight});
        continue;
      }
      negative = negative != renewed.negative;
      for (const Operand& factor : graph.node(renewed.node).operands) {
        factors.push_back({{factor.node, false}, factor.weight});
      }
    }
    return with_sign(graph.product(factors), negative);
  }

  std::vector<std::uint32_t> uses_;
};

}  // namespace

Expressions flatten(const Expressions& expressions) {
  return rebuild(expressions, Flattening(expressions));
}

}  // namespace elgen
