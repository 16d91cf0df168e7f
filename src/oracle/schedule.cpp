// Schedule: the order of references, then time orders from users to operands.
#include "oracle/schedule.hpp"

#include <algorithm>

#include "elgen/references.hpp"

namespace elgen::oracle {
namespace {

void raise(unsigned& order, unsigned to) { order = std::max(order, to); }

}  // namespace

Schedule make_schedule(const Model& model, const std::vector<Root>& roots) {
  Schedule schedule;
  std::vector<ExpressionId> expressions;
  for (const Root& root : roots) expressions.push_back(root.expression);
  schedule.order = reached(model, expressions);
  schedule.slots.assign(model.expressions.size(), 0);
  for (std::uint32_t slot = 0; slot < schedule.order.size(); ++slot) {
    schedule.slots[schedule.order[slot]] = slot;
  }
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
