// expansion_text: what a scene's `[approximate]` makes of the equations, as a sentence.
//
//     Expanded about x = 0, theta = 0, u = 0: right to order 1 in the deviations from there, the
//     rates and the accelerations together.
#include <fmt/format.h>

#include "elgen/render.hpp"

namespace elgen {
namespace {

using Names = std::vector<std::string>;

/// Values of small coordinates, and of inputs where they are small.
Names point(const Model& model) {
  const Approximation& approximation = *model.approximation;
  Names values;
  for (std::size_t i = 0; i < model.coordinates.size(); ++i) {
    if (!approximation.small[i]) continue;
    values.push_back(fmt::format("{} = {}", model.coordinates[i].name,
                                 to_string(model, *approximation.coordinates[i])));
  }
  for (std::size_t i = 0; approximation.small_inputs && i < model.inputs.size(); ++i) {
    const std::optional<ExpressionId>& value = approximation.inputs[i];
    values.push_back(
        fmt::format("{} = {}", model.inputs[i].name, value ? to_string(model, *value) : "0"));
  }
  return values;
}

Names small_coordinates(const Model& model) {
  Names names;
  for (std::size_t i = 0; i < model.coordinates.size(); ++i) {
    if (model.approximation->small[i]) names.push_back(model.coordinates[i].name);
  }
  return names;
}

}  // namespace

std::string expansion_text(const Model& model) {
  if (!model.approximation) return {};
  const Approximation& approximation = *model.approximation;
  const std::string about = fmt::format("Expanded about {}: ", fmt::join(point(model), ", "));
  if (approximation.small_inputs) {
    return about + fmt::format(
                       "right to order {} in the deviations from there, the rates and the "
                       "accelerations together.",
                       approximation.order);
  }
  return about + fmt::format(
                     "right in the equations of {} to order {} (in others to order {}) in "
                     "the deviations from there, their rates and their accelerations "
                     "together; exact in all else.",
                     fmt::join(small_coordinates(model), ", "), approximation.order,
                     approximation.order + 1);
}

}  // namespace elgen
