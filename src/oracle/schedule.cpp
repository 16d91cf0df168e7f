// Schedule: depth-first order with an explicit stack, then time orders from users to operands.
#include "schedule.hpp"

#include <algorithm>

namespace elgen::oracle {
namespace {

constexpr std::uint32_t unvisited = ~std::uint32_t{0};

struct Visit {
  ExpressionId expression = 0;
  std::vector<ExpressionId> references = {};
  std::size_t next = 0;
};

/// Appends `root` and what it needs to the schedule, operands first.
void append(const Model& model, ExpressionId root, Schedule& schedule) {
  std::vector<Visit> stack;
  const auto enter = [&](ExpressionId id) {
    if (schedule.slots[id] == unvisited) stack.push_back({id, references(model, id), 0});
  };
  enter(root);
  while (!stack.empty()) {
    Visit& top = stack.back();
    if (top.next < top.references.size()) {
      enter(top.references[top.next++]);
      continue;
    }
    if (schedule.slots[top.expression] == unvisited) {
      schedule.slots[top.expression] = static_cast<std::uint32_t>(schedule.order.size());
      schedule.order.push_back(top.expression);
    }
    stack.pop_back();
  }
}

void raise(unsigned& order, unsigned to) { order = std::max(order, to); }

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

Schedule make_schedule(const Model& model, const std::vector<Root>& roots) {
  Schedule schedule;
  schedule.slots.assign(model.expressions.size(), unvisited);
  for (const Root& root : roots) append(model, root.expression, schedule);
  schedule.time_orders.assign(schedule.order.size(), 0);
  for (const Root& root : roots) {
    raise(schedule.time_orders[schedule.slots[root.expression]], root.time_order);
  }
  for (std::size_t slot = schedule.order.size(); slot-- > 0;) {
    const ExpressionId id = schedule.order[slot];
    const bool differentiates = model.expressions[id].kind == ExpressionKind::time_derivative;
    const unsigned needed = schedule.time_orders[slot] + (differentiates ? 1U : 0U);
    for (const ExpressionId reference : references(model, id)) {
      raise(schedule.time_orders[schedule.slots[reference]], needed);
    }
  }
  return schedule;
}

}  // namespace elgen::oracle
