// Cycles: the names along a cycle of expressions, from the one that stands first in the file.
#include "check/expressions/cycles.hpp"

#include <algorithm>

#include "elgen/references.hpp"

namespace elgen {
namespace {

struct Named {
  std::string name;
  Span span;
};

template <class Row>
Named named(const Row& row) {
  return {row.name, row.span};
}

/// The entry that a node stands for, if that has a name and expressions of its own.
std::optional<Named> named_by(const Model& model, const Expression& node) {
  switch (node.kind) {
    case ExpressionKind::definition:
      return named(model.definitions[node.index]);
    case ExpressionKind::prescribed:
      return named(model.prescribed[node.index]);
    case ExpressionKind::point_component:
      return named(model.points[node.index / 3]);
    case ExpressionKind::frame_component:
      return named(model.frames[node.index / components_per_frame]);
    default:
      return std::nullopt;
  }
}

}  // namespace

bool check_cycles(Context& context) {
  const Model& model = context.model;
  std::vector<Named> cycle;
  for (const ExpressionId id : find_cycle(model)) {
    if (auto name = named_by(model, model.expressions[id])) cycle.push_back(*std::move(name));
  }
  if (cycle.empty()) return true;
  const auto earlier = [](const Named& a, const Named& b) { return a.span.begin < b.span.begin; };
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end(), earlier), cycle.end());
  std::string text;
  for (const Named& entry : cycle) text += entry.name + " -> ";
  const auto& [first, span] = cycle.front();
  context.report.add(Code::E206, span,
                     in_backticks(first) + " is defined by itself: " + text + first);
  return false;
}

}  // namespace elgen
