// Marks the requested outputs of a model; adds the outputs that an animated page needs.
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "check/scene/scene.hpp"
#include "elgen/references.hpp"
#include "model/kinks.hpp"
#include "model/requests.hpp"
#include "model/shown_places.hpp"

namespace elgen {
namespace {

/// Adds an output with an unused name; nothing if `values` is empty. Laws and integrals may contain
/// t even if the equations do not.
void add_shown_output(Model& model, Scene& scene, ShownValues shown,
                      std::vector<ExpressionId> values, LeafSet takes = {}) {
  if (values.empty()) return;
  UserOutput output;
  output.name = fmt::format("shown_{}", name_of(shown));
  while (std::ranges::count(model.outputs, output.name, &UserOutput::name) > 0) output.name += '_';
  output.values = std::move(values);
  output.argument_kinds = takes;
  const auto names_time = [&](ExpressionId id) { return contains_leaf(model, id, Opcode::time); };
  if (std::ranges::any_of(output.values, names_time)) output.argument_kinds |= Opcode::time;
  scene.page_outputs[static_cast<std::uint32_t>(model.outputs.size())] = shown;
  output.span = model.name_span;
  model.outputs.push_back(std::move(output));
}

std::vector<ExpressionId> shown_place_coordinates(const Model& model) {
  std::vector<ExpressionId> rows;
  for (const ShownPlace& place : shown_places(model)) {
    const std::vector<ExpressionId> more = place_coordinates(model, place);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

std::vector<ExpressionId> shown_place_masses(const Model& model) {
  std::vector<ExpressionId> masses;
  for (const ShownPlace& place : shown_places(model)) {
    if (place.mass) masses.push_back(*place.mass);
  }
  return masses;
}

/// The arguments of all calls with kinks.
std::vector<ExpressionId> kink_arguments(const Model& model, const Scene& scene) {
  std::vector<ExpressionId> arguments;
  for (const KinkedCall& kink : kinked_calls(model, laws_of(model, scene))) {
    const std::vector<ExpressionId>& operands = model.expressions[kink.call].operands;
    arguments.insert(arguments.end(), operands.begin(), operands.end());
  }
  return arguments;
}

}  // namespace

void mark_wanted_outputs(Model& model, const FileSyntax* scene, const SceneOptions& options) {
  const EntrySyntax* const outputs = find_entry(scene, "outputs");
  if (outputs == nullptr) return;
  for (UserOutput& output : model.outputs) output.is_requested = is_of_scene(model, output.span);
  const auto want = [&](std::string_view name) {
    const std::optional<OutputRequest> request = find_request(model, name);
    const bool is_user = request && output_row(request->kind).is_user_output;
    if (is_user) model.outputs[request->user].is_requested = true;
  };
  for (const Span& word : option_words(options.outputs)) want(covered_text(word));
  for (const KeySyntax& key : outputs->keys) {
    const bool is_refused = key.value.kind == ValueKind::boolean && !key.value.boolean;
    if (!is_refused) want(key.key);
  }
}

void add_shown_outputs(Model& model, Scene& scene) {
  add_shown_output(model, scene, ShownValues::places, shown_place_coordinates(model));
  add_shown_output(model, scene, ShownValues::masses, shown_place_masses(model));
  add_shown_output(model, scene, ShownValues::laws, laws_of(model, scene), Opcode::velocity);
  add_shown_output(model, scene, ShownValues::integrals, shown_integrals(model), Opcode::velocity);
  add_shown_output(model, scene, ShownValues::kinks, kink_arguments(model, scene),
                   Opcode::velocity);
}

}  // namespace elgen
