// scene_notes: facts about a scene that a reader of its equations needs.
#include <fmt/ranges.h>

#include "elgen/page.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

using Lines = std::vector<std::string>;

Lines fixed_parameters(const Model& model, const Scene& scene) {
  Lines values;
  for (const auto& [index, value] : scene.specialisation.fixed) {
    values.push_back(
        fmt::format("{} = {}", model.parameters[index].name, exact_text(value.number)));
  }
  return values;
}

/// "q1 = 1/6*pi" for each locked coordinate; a rotation gives one text per component.
Lines locked_coordinates(const Model& model) {
  const Model& whole = unreduced_model(model);
  Lines values;
  for (const LockedCoordinate& lock : model.reduction.locks) {
    for (std::uint32_t i = 0; i < lock.values.size(); ++i) {
      values.push_back(fmt::format("{} = {}", whole.coordinates[lock.coordinate + i].name,
                                   to_string(whole, lock.values[i])));
    }
  }
  return values;
}

/// "phi at p_phi = 0.6"
Lines cyclic_coordinates(const Model& model) {
  Lines values;
  for (const CyclicCoordinate& cyclic : model.reduction.cyclic) {
    const Parameter& momentum = model.parameters[cyclic.parameter];
    values.push_back(fmt::format("{} at {} = {}",
                                 unreduced_model(model).coordinates[cyclic.coordinate].name,
                                 momentum.name, short_number_text(momentum.value)));
  }
  return values;
}

/// "Left out, with more than 4096 entries: mass_matrix, linearization. …"
std::string omission_text(const OmittedOutputs& left_out) {
  const std::string names = fmt::format("{}", fmt::join(left_out.outputs, ", "));
  if (left_out.reason == OmissionReason::too_many_entries) {
    return fmt::format(
        "Left out, with more than {} entries: {}. To emit one, name it in a scene or with "
        "--outputs.",
        max_entries_in_full, names);
  }
  return fmt::format("Left out, because forces with abs, sign, min or max have no derivatives: {}.",
                     names);
}

/// The expansion point, as "x = 0" for each small coordinate, and for each input if inputs are
/// small.
Lines expansion_point_values(const Model& model) {
  const Approximation& approximation = *model.approximation;
  Lines values;
  for (std::size_t i = 0; i < model.coordinates.size(); ++i) {
    if (!approximation.small[i]) continue;
    values.push_back(fmt::format("{} = {}", model.coordinates[i].name,
                                 to_string(model, *approximation.coordinates[i])));
  }
  for (std::size_t i = 0; approximation.has_small_inputs && i < model.inputs.size(); ++i) {
    const std::optional<ExpressionId>& value = approximation.inputs[i];
    values.push_back(
        fmt::format("{} = {}", model.inputs[i].name, value ? to_string(model, *value) : "0"));
  }
  return values;
}

Lines small_coordinates(const Model& model) {
  Lines names;
  for (std::size_t i = 0; i < model.coordinates.size(); ++i) {
    if (model.approximation->small[i]) names.push_back(model.coordinates[i].name);
  }
  return names;
}

}  // namespace

/// "Expanded about x = 0, theta = 0, u = 0: correct to order 1 in the deviations, the rates and the
/// accelerations together."; "" without an approximation.
std::string expansion_text(const Model& model) {
  if (!model.approximation) return {};
  const Approximation& approximation = *model.approximation;
  const std::string about =
      fmt::format("Expanded about {}: ", fmt::join(expansion_point_values(model), ", "));
  if (approximation.has_small_inputs) {
    return about + fmt::format(
                       "correct to order {} in the deviations, the rates and the accelerations "
                       "together.",
                       approximation.order);
  }
  return about + fmt::format(
                     "correct to order {1} in the equations of {0}, and to order {2} in other "
                     "equations. The order counts the deviations, their rates and their "
                     "accelerations together. All other variables are exact.",
                     fmt::join(small_coordinates(model), ", "), approximation.order,
                     approximation.order + 1);
}

std::vector<std::string> scene_notes(const Model& model, const Scene& scene) {
  Lines notes;
  if (!scene.doc.empty()) notes.push_back(scene.doc);
  const auto add = [&notes](const char* what, const Lines& values) {
    if (!values.empty()) notes.push_back(fmt::format("{}: {}.", what, fmt::join(values, ", ")));
  };
  add("Fixed", fixed_parameters(model, scene));
  add("Locked", locked_coordinates(model));
  add("Eliminated, at constant momentum", cyclic_coordinates(model));
  if (model.approximation) notes.push_back(expansion_text(model));
  for (const OmittedOutputs& left_out : scene.omitted_outputs)
    notes.push_back(omission_text(left_out));
  return notes;
}

}  // namespace elgen
