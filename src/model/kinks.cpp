// kinked_calls: finds calls with kinks in all expressions that determine a force or a law.
#include "model/kinks.hpp"

#include "elgen/references.hpp"

namespace elgen {
namespace {

/// The only velocity in the expressions, if their other leaves are parameters; none otherwise.
std::optional<std::size_t> only_rate(const Model& model, const std::vector<ExpressionId>& roots) {
  std::optional<std::size_t> rate;
  for (const ExpressionId id : reachable_expressions(model, roots)) {
    const Expression& node = model.expressions[id];
    if (node.kind == ExpressionKind::time_derivative) return std::nullopt;
    if (node.kind != ExpressionKind::leaf || is_leaf(node, Opcode::parameter)) continue;
    if (!is_leaf(node, Opcode::velocity) || (rate && *rate != node.index)) return std::nullopt;
    rate = node.index;
  }
  return rate;
}

}  // namespace

std::vector<ExpressionId> laws_of(const Model& model, const Scene& scene) {
  std::vector<ExpressionId> laws;
  for (const Input& input : model.inputs) {
    if (const ExpressionId* const law = find_law(scene, input)) laws.push_back(*law);
  }
  return laws;
}

std::vector<KinkedCall> kinked_calls(const Model& model, const std::vector<ExpressionId>& laws) {
  std::vector<KinkedCall> calls;
  const auto add_calls = [&](const std::vector<ExpressionId>& roots, bool is_of_law) {
    for (const ExpressionId id : reachable_expressions(model, roots)) {
      const Expression& node = model.expressions[id];
      const bool has_kink = node.kind == ExpressionKind::function && is_kinked(node.function);
      if (!has_kink || is_constant_along_run(model, id)) continue;
      calls.push_back({id, is_of_law, only_rate(model, node.operands)});
    }
  };
  add_calls(filter_roots(model, is_force_value), false);
  add_calls(laws, true);
  return calls;
}

}  // namespace elgen
