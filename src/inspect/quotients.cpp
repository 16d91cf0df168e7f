// Quotients of sines and cosines that are 0/0 at a state and that the stage check has not
// rewritten.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/inspect.hpp"
#include "elgen/references.hpp"

namespace elgen {
namespace {

bool contains_sinusoid(const Model& model, ExpressionId id) {
  return std::ranges::any_of(reachable_expressions(model, {id}), [&model](ExpressionId part) {
    const Expression& node = model.expressions[part];
    return node.kind == ExpressionKind::function && is_circular(node.function);
  });
}

}  // namespace

std::string quotient_hint(const Model& model, const State& state) {
  const auto is_zero = [&](ExpressionId id) {
    const std::optional<cln::cl_R> value = oracle_expression_value(model, id, state);
    return value && cln::zerop(*value);
  };
  for (const ExpressionId id : reachable_expressions(model, equation_and_output_roots(model))) {
    const Expression& node = model.expressions[id];
    const bool is_sought = node.kind == ExpressionKind::divide && is_zero(node.operands[1]) &&
                           is_zero(node.operands[0]) && contains_sinusoid(model, node.operands[0]);
    if (!is_sought) continue;
    return fmt::format(
        "`{}` is 0/0 there; `sinc(a)` is sin(a)/a and `cosc(a)` (1 - cos(a))/a^2, with values at 0",
        to_string(model, id));
  }
  return {};
}

}  // namespace elgen
