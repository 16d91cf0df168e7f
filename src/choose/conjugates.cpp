// conjugates: w sqrt(a) + b = (a - b^2)/(w sqrt(a) - b), w = +-1.
#include "choose/conjugates.hpp"

#include <algorithm>

namespace elgen {
namespace {

class Conjugates {
 public:
  explicit Conjugates(bool& has_any) : has_any_(has_any) {}

  Ref operator()(Graph& graph, const RebuildStep& step) const {
    const Ref same = copy(graph, step);
    if (graph.node(same.node).kind != NodeKind::sum) return same;
    const std::optional<Ref> better = conjugate(graph, same.node);
    if (!better) return same;
    has_any_ = true;
    return with_sign(*better, same.negative);
  }

 private:
  static std::optional<Ref> conjugate(Graph& graph, NodeId sum) {
    const std::vector<Operand> operands = graph.node(sum).operands;
    const auto is_root = [&](const Operand& operand) {
      return graph.node(operand.node).kind == NodeKind::square_root;
    };
    if (std::ranges::count_if(operands, is_root) != 1) return std::nullopt;
    const Operand root = *std::ranges::find_if(operands, is_root);
    std::vector<Ref> others;
    for (const Operand& operand : operands) {
      if (!is_root(operand)) others.push_back({operand.node, operand.weight < 0});
    }
    const Ref rest = graph.sum(others);
    const Operand radicand = graph.node(root.node).operands[0];
    const Ref square = graph.product({{rest, 2}});
    const Ref numerator = graph.sum({{radicand.node, radicand.weight < 0}, -square});
    if (terms(graph, numerator.node) >= terms(graph, radicand.node)) return std::nullopt;
    const Ref divisor = graph.sum({{root.node, root.weight < 0}, -rest});
    return graph.product({{numerator, 1}, {divisor, -1}});
  }

  static std::size_t terms(const Graph& graph, NodeId node) {
    return graph.node(node).kind == NodeKind::sum ? graph.node(node).operands.size() : 1;
  }

  bool& has_any_;
};

}  // namespace

std::optional<Expressions> with_conjugates(const Expressions& expressions) {
  bool has_any = false;
  Expressions result = rebuild(expressions, Conjugates(has_any));
  if (!has_any) return std::nullopt;
  return result;
}

}  // namespace elgen
