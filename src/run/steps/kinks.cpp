// KinkWatch: finds the calls with kinks in forces and laws, and evaluates their arguments.
#include "run/steps/kinks.hpp"

#include "elgen/references.hpp"
#include "elgen/wording.hpp"

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

KinkWatch::KinkWatch(SimulatedSystem& system) : system_(system) {
  const Model& model = system.model();
  std::vector<ExpressionId> of_laws;
  for (const InputLaw& law : system.laws()) {
    if (law.expression) of_laws.push_back(*law.expression);
  }
  for (const ExpressionId id : reachable_expressions(model, filter_roots(model, is_force_value)))
    add(id, false);
  for (const ExpressionId id : reachable_expressions(model, of_laws)) add(id, true);
}

void KinkWatch::add(ExpressionId call, bool is_of_law) {
  const Model& model = system_.model();
  const Expression& node = model.expressions[call];
  if (node.kind != ExpressionKind::function || !is_kinked(node.function)) return;
  if (is_constant_along_run(model, call)) return;
  Kink& kink = kinks_.emplace_back(Kink{call, is_of_law, only_rate(model, node.operands)});
  for (const ExpressionId argument : node.operands) {
    kink.arguments.push_back(system_.state_function(argument));
  }
}

std::vector<int> KinkWatch::sides(const Numbers& state, double t) {
  const double* const v = system_.v_of(state);
  std::vector<int> all;
  for (Kink& kink : kinks_) {
    const bool is_still = kink.is_of_law && system_.holds_inputs();
    const double* const q =
        kink.is_of_law ? system_.displayed_position(state.data()).data() : state.data();
    double side = is_still ? 0 : kink.arguments.front()(q, v, t);
    if (!is_still && kink.arguments.size() > 1) side -= kink.arguments.back()(q, v, t);
    all.push_back(side > 0 ? 1 : side < 0 ? -1 : 0);
  }
  return all;
}

std::string KinkWatch::kink_text(std::size_t kink) const {
  return in_backticks(system_.model().expressions[kinks_[kink].call].span);
}

}  // namespace elgen
