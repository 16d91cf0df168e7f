// E522: parameters in no expression, inputs that act on nothing. One pass over the arena, before
// anything was locked, marks what is used.
#include <fmt/format.h>

#include <algorithm>

#include "inspect/checks.hpp"

namespace elgen {
namespace {

/// By index in the Model: whether a leaf of this kind stands in an expression.
std::vector<bool> used(const Model& model, ExpressionKind kind, std::size_t count) {
  std::vector<bool> marks(count, false);
  for (const Expression& expression : model.expressions) {
    if (expression.kind == kind) marks[expression.index] = true;
  }
  return marks;
}

Diagnostics unused_parameters(const Model& model) {
  Diagnostics found;
  const auto marks = used(model, ExpressionKind::parameter, model.parameters.size());
  for (const ParameterArray& array : model.parameter_arrays) {
    const auto first = marks.begin() + array.first;
    if (std::find(first, first + array.count, true) != first + array.count) continue;
    found.push_back(
        {Code::E522, array.span, fmt::format("parameter `{}` is used nowhere", array.name)});
  }
  return found;
}

Diagnostics unused_inputs(const Model& model) {
  Diagnostics found;
  const auto marks = used(model, ExpressionKind::input, model.inputs.size());
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const Input& input = model.inputs[i];
    if (input.on || marks[i]) continue;
    found.push_back({Code::E522, input.span, fmt::format("input `{}` acts on nothing", input.name),
                     "give it `on`, or name it in a force"});
  }
  return found;
}

}  // namespace

Diagnostics inspect_unused(const Inspected& subject) {
  const Model& model = subject.model.unlocked ? *subject.model.unlocked : subject.model;
  Diagnostics found = unused_parameters(model);
  const Diagnostics inputs = unused_inputs(model);
  found.insert(found.end(), inputs.begin(), inputs.end());
  return found;
}

}  // namespace elgen
