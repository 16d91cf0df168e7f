// Notes that need no sampled states.
//
// E522: unused parameters and inputs, found by one pass over all expressions of the whole model.
// E619: outputs that the built-in scene `full` omits, one note per reason.
// E616: inputs on locked coordinates.
// E627: a force with tanh, which approximates dry friction, in a linearization that the scene
// names.
#include <fmt/ranges.h>

#include <algorithm>

#include "elgen/leaf_names.hpp"
#include "elgen/references.hpp"
#include "elgen/wording.hpp"
#include "inspect/checks.hpp"

namespace elgen {
namespace {

/// For each leaf of the kind: true if an expression of the model contains it.
std::vector<bool> used_leaves(const Model& model, Opcode kind) {
  std::vector<bool> marks(leaf_count(model, kind), false);
  for (const Expression& expression : model.expressions) {
    if (is_leaf(expression, kind)) marks[expression.index] = true;
  }
  return marks;
}

void add_unused_parameters(const Model& model, Diagnostics& found) {
  const auto marks = used_leaves(model, Opcode::parameter);
  for (const ParameterArray& array : model.parameter_arrays) {
    const auto first = marks.begin() + array.first;
    if (std::find(first, first + array.count, true) != first + array.count) continue;
    if (std::ranges::count(model.reduction.cyclic, array.first, &CyclicCoordinate::parameter) > 0)
      continue;
    found.push_back(
        {Code::E522, array.span, fmt::format("parameter `{}` is used nowhere", array.name)});
  }
}

void add_unused_inputs(const Model& model, Diagnostics& found) {
  const auto marks = used_leaves(model, Opcode::input);
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const Input& input = model.inputs[i];
    if (input.velocity || marks[i]) continue;
    found.push_back({Code::E522, input.span, fmt::format("input `{}` acts on nothing", input.name),
                     "give it `on`, or name it in a force"});
  }
}

/// The names of the outputs: "`mass_matrix`, `linearization`".
std::string quoted_names(const OmittedOutputs& left_out) {
  return fmt::format("`{}`", fmt::join(left_out.outputs, "`, `"));
}

Diagnostic omission_note(const OmittedOutputs& left_out) {
  if (left_out.reason == OmissionReason::too_many_entries) {
    return {Code::E619, left_out.span,
            fmt::format("not emitted because of more than {} entries: {}", max_entries_in_full,
                        quoted_names(left_out)),
            "name the output in a scene or in `--outputs`"};
  }
  return {Code::E619, left_out.span,
          "not emitted because a force with a kink has no derivatives: " + quoted_names(left_out),
          "use a smooth approximation: `tanh(x/width)` for `sign(x)`"};
}

/// The place of the first tanh of rates in a force; none if no force contains a tanh of rates.
std::optional<Span> find_smoothed_friction(const Model& model) {
  for (const ExpressionId id : reachable_expressions(model, filter_roots(model, is_force_value))) {
    const Expression& node = model.expressions[id];
    const bool is_tanh = node.kind == ExpressionKind::function && node.function == FunctionId::tanh;
    if (is_tanh && contains_leaf(model, id, Opcode::velocity)) return node.span;
  }
  return std::nullopt;
}

}  // namespace

Diagnostics inspect_unused_names(const InspectedModel& subject) {
  const Model& model = unreduced_model(subject.model);
  Diagnostics found;
  add_unused_parameters(model, found);
  add_unused_inputs(model, found);
  return found;
}

Diagnostics inspect_omissions(const InspectedModel& subject) {
  Diagnostics notes;
  for (const OmittedOutputs& left_out : subject.scene.omitted_outputs)
    notes.push_back(omission_note(left_out));
  const Model& whole = unreduced_model(subject.model);
  const RemainingIndices inputs = remaining_variables(whole).inputs;
  for (std::size_t i = 0; i < whole.inputs.size();) {
    // The components of a wrench are one entry, so they get one note.
    std::vector<std::string> names;
    const Span& span = whole.inputs[i].span;
    for (; i < whole.inputs.size() && whole.inputs[i].span == span; ++i) {
      if (!inputs[i]) names.push_back(quote_text(whole.inputs[i].name));
    }
    if (names.empty()) continue;
    notes.push_back({Code::E616, span,
                     fmt::format("{} {} only on locked coordinates, and {} of this scene",
                                 fmt::join(names, ", "), names.size() == 1 ? "acts" : "act",
                                 names.size() == 1 ? "is no input" : "are no inputs"),
                     "`reaction` is the whole force, this input included"});
  }
  return notes;
}

Diagnostics inspect_smoothed_friction(const InspectedModel& subject) {
  const Model& model = subject.model;
  const std::vector<OutputRequest>& outputs = subject.scene.outputs;
  const auto output = std::ranges::find(outputs, OutputKind::linearization, &OutputRequest::kind);
  const bool is_named = output != outputs.end() && output->span.source != nullptr;
  const auto friction = is_named ? find_smoothed_friction(model) : std::nullopt;
  if (!friction) return {};
  return {{Code::E627, *friction,
           fmt::format("`{}` contains this friction as a damper near rest", output->name),
           "its width sets the stiffness; remove the friction if the system slides or sticks"}};
}

}  // namespace elgen
