// References: one switch over what names stand for, and one depth-first order.
#include "elgen/references.hpp"

namespace elgen {
namespace {

/// An expression whose references are being entered.
struct Entered {
  ExpressionId expression = 0;
  std::vector<ExpressionId> references = {};
  std::size_t next = 0;
};

}  // namespace

std::vector<ExpressionId> references(const Model& model, ExpressionId expression) {
  const Expression& e = model.expressions[expression];
  switch (e.kind) {
    case ExpressionKind::prescribed:
      return {model.prescribed[e.index].value};
    case ExpressionKind::definition:
      return {model.definitions[e.index].value};
    case ExpressionKind::point_component:
      return {model.points[e.index / 3].at[e.index % 3]};
    case ExpressionKind::frame_component:
      return {component_of_frame(model, e.index)};
    default:
      return e.operands;
  }
}

std::vector<ExpressionId> reached(const Model& model, const std::vector<ExpressionId>& roots) {
  std::vector<bool> done(model.expressions.size(), false);
  std::vector<ExpressionId> order;
  std::vector<Entered> stack;
  const auto enter = [&](ExpressionId id) {
    if (!done[id]) stack.push_back({id, references(model, id), 0});
  };
  for (const ExpressionId root : roots) {
    enter(root);
    while (!stack.empty()) {
      Entered& top = stack.back();
      if (top.next < top.references.size()) {
        enter(top.references[top.next++]);
        continue;
      }
      if (!done[top.expression]) order.push_back(top.expression);
      done[top.expression] = true;
      stack.pop_back();
    }
  }
  return order;
}

}  // namespace elgen
