// Asks the oracle for every quotient, power and call that the output is made of.
#include "verify/states/undefined_expression.hpp"

#include <algorithm>

#include "elgen/outputs.hpp"
#include "elgen/references.hpp"
#include "inspect/roots.hpp"

namespace elgen {
namespace {

bool may_be_undefined(const Expression& node) {
  return node.kind == ExpressionKind::divide || node.kind == ExpressionKind::power ||
         node.kind == ExpressionKind::function;
}

}  // namespace

std::optional<ExpressionId> undefined_expression(const Model& model, const Function& function,
                                                 const std::vector<State>& states) {
  const auto roots = output_row(function.kind).of_user ? output_roots(model.outputs[function.user])
                                                       : equation_roots(model);
  for (const ExpressionId id : reached(model, roots)) {
    const auto is_undefined = [&](const State& state) {
      return !oracle_expression(model, id, state);
    };
    if (!may_be_undefined(model.expressions[id])) continue;
    if (std::all_of(states.begin(), states.end(), is_undefined)) return id;
  }
  return std::nullopt;
}

}  // namespace elgen
