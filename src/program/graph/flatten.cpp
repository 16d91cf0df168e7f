// flatten: see flatten.hpp. The normal forms of sums and products then merge what has met.
#include "program/graph/flatten.hpp"

namespace elgen {
namespace {

class Flattening {
 public:
  Flattening(const Expressions& expressions, Flattened which)
      : uses_(use_counts(expressions.graph, expressions.values)), which_(which) {}

  Ref operator()(Graph& graph, const RebuildStep& step) const {
    const NodeKind kind = step.old_graph.node(step.old_node).kind;
    if (kind == NodeKind::sum) return sum(graph, step);
    if (kind == NodeKind::product) return product(graph, step);
    return copy(graph, step);
  }

 private:
  /// Of its user's kind, still so after its own renewal, and used once.
  bool is_spliced(const Graph& graph, const RebuildStep& step, const Operand& operand) const {
    const NodeKind kind = step.old_graph.node(step.old_node).kind;
    const bool is_wanted = uses_[operand.node] == 1 ||
                           (which_ == Flattened::all_products && kind == NodeKind::product);
    return is_wanted && step.old_graph.node(operand.node).kind == kind &&
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
      const bool is_power = operand.weight != 1 && which_ == Flattened::used_once;
      if (is_power || !is_spliced(graph, step, operand)) {
        factors.push_back({renewed, operand.weight});
        continue;
      }
      negative = negative != (renewed.negative && operand.weight % 2 != 0);
      for (const Operand& factor : graph.node(renewed.node).operands) {
        factors.push_back({{factor.node, false}, factor.weight * operand.weight});
      }
    }
    return with_sign(graph.product(factors), negative);
  }

  std::vector<std::uint32_t> uses_;
  Flattened which_;
};

}  // namespace

Expressions flatten(const Expressions& expressions, Flattened which) {
  return rebuild(expressions, Flattening(expressions, which));
}

}  // namespace elgen
