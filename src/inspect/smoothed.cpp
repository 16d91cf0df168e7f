// E627: a force with tanh, as it stands in for dry friction, in a linearization asked for by name.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/references.hpp"
#include "inspect/checks.hpp"

namespace elgen {
namespace {

bool contains_rate(const Model& model, ExpressionId root) {
  const std::vector<ExpressionId> parts = reached(model, {root});
  return std::any_of(parts.begin(), parts.end(), [&](ExpressionId id) {
    return model.expressions[id].kind == ExpressionKind::rate;
  });
}

/// tanh of something with a rate in it.
std::optional<Span> smoothed_friction(const Model& model) {
  std::vector<ExpressionId> values;
  for (const Force& force : model.forces) {
    values.insert(values.end(), force.value.begin(), force.value.end());
  }
  for (const ExpressionId id : reached(model, values)) {
    const Expression& node = model.expressions[id];
    const bool is_tanh = node.kind == ExpressionKind::function && node.function == FunctionId::tanh;
    if (is_tanh && contains_rate(model, id)) return node.span;
  }
  return std::nullopt;
}

}  // namespace

Diagnostics inspect_smoothed(const Inspected& subject) {
  const Model& model = subject.model;
  for (const OutputRequest& output : subject.scene.outputs) {
    const bool is_named = output.span.source != nullptr;
    if (output.kind != OutputKind::linearization || !is_named) continue;
    const auto friction = smoothed_friction(model);
    if (!friction) return {};
    return {{Code::E627, *friction,
             fmt::format("`{}` has this friction as a damper near rest", output.name),
             "its width decides how stiff; leave it out where the system slides or sticks"}};
  }
  return {};
}

}  // namespace elgen
