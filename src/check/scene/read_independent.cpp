// read_independent_velocities: the velocities from which `completed` computes all other velocities.
#include <algorithm>

#include "base/report.hpp"
#include "check/scene/scene.hpp"

namespace elgen {
namespace {

/// The velocity of a coordinate, or the three velocities of a rotation; none for an unknown name.
std::vector<std::uint32_t> find_velocities(const Model& model, const std::string& name) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < model.velocities.size(); ++i) {
    const Velocity& velocity = model.velocities[i];
    const std::string& own = velocity.rotation ? model.rotations[*velocity.rotation].name
                                               : model.coordinates[velocity.coordinate].name;
    if (own == name) found.push_back(i);
  }
  return found;
}

std::vector<std::string> names_of_variables(const Model& model) {
  std::vector<std::string> names = column_words(model.rotations, &Rotation::name);
  for (const Coordinate& coordinate : model.coordinates) {
    if (!coordinate.rotation) names.push_back(coordinate.name);
  }
  return names;
}

}  // namespace

std::vector<std::uint32_t> read_independent_velocities(Context& context, const FileSyntax* scene) {
  const KeySyntax* const output = find_key(scene, "outputs", "completed");
  const KeySyntax* const names = output == nullptr ? nullptr : output->value.find("independent");
  if (names == nullptr) return {};
  const Model& model = context.model;
  std::vector<std::uint32_t> independent;
  for (const ValueSyntax& item : names->value.items) {
    const Span& span = item.expression.span;
    const std::string name(covered_text(span));
    const std::vector<std::uint32_t> found = find_velocities(model, name);
    if (found.empty()) {
      context.report.add(Code::E612, span, "unknown coordinate " + quote_text(name),
                         suggestion(name, names_of_variables(model)));
      continue;
    }
    independent.insert(independent.end(), found.begin(), found.end());
  }
  std::ranges::sort(independent);
  independent.erase(std::unique(independent.begin(), independent.end()), independent.end());
  return independent;
}

}  // namespace elgen
