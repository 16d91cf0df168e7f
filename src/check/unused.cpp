// One pass over the arena marks what is used.
#include "unused.hpp"

#include <algorithm>
#include <vector>

namespace elgen::checking {
namespace {

/// By index in the Model: whether a leaf of this kind stands in an expression.
std::vector<bool> used(const Model& model, ExpressionKind kind, std::size_t count) {
  std::vector<bool> marks(count, false);
  for (const Expression& expression : model.expressions) {
    if (expression.kind == kind) marks[expression.index] = true;
  }
  return marks;
}

void report_parameters(const Model& model, Report& report) {
  const auto marks = used(model, ExpressionKind::parameter, model.parameters.size());
  for (const ParameterArray& array : model.parameter_arrays) {
    const auto first = marks.begin() + array.first;
    if (std::find(first, first + array.count, true) != first + array.count) continue;
    report.add(Code::E522, array.span, "parameter " + quoted(array.name) + " is used nowhere");
  }
}

void report_inputs(const Model& model, Report& report) {
  const auto marks = used(model, ExpressionKind::input, model.inputs.size());
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const Input& input = model.inputs[i];
    if (input.on || marks[i]) continue;
    report.add(Code::E522, input.span, "input " + quoted(input.name) + " acts on nothing",
               "give it `on`, or name it in a force");
  }
}

}  // namespace

void report_unused(Context& context) {
  report_parameters(context.model, context.report);
  report_inputs(context.model, context.report);
}

}  // namespace elgen::checking
