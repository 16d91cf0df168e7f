// Determines the inputs of a scene from the text of the model.
#include <algorithm>

#include "random/model.hpp"

namespace elgen::test::random {

namespace {

bool names_input(const Expression& expression, const std::string& input) {
  if (!expression) return false;
  if (expression->kind == NodeKind::name && expression->text == input) return true;
  return std::ranges::any_of(
      expression->operands, [&](const Expression& operand) { return names_input(operand, input); });
}

bool is_locked(const Scene& scene, const std::string& on) {
  return std::ranges::any_of(scene.locks, [&](const Lock& lock) {
    return on == lock.coordinate || on.starts_with(lock.coordinate + "[");
  });
}

/// The coordinates on which `force` acts; "" if `force` acts on a point or frame, which several
/// coordinates move.
std::vector<std::string> acted_on(const Force& force) {
  if (force.repeat == 0 || force.on.empty()) return {force.on};
  std::vector<std::string> all;
  for (int i = 1; i <= force.repeat; ++i) {
    std::string on = force.on;
    all.push_back(on.replace(on.find("[i]"), 3, "[" + std::to_string(i) + "]"));
  }
  return all;
}

}  // namespace

std::vector<std::size_t> acting_inputs(const System& system) {
  std::vector<std::size_t> acting;
  for (std::size_t k = 0; k < system.model.inputs.size(); ++k) {
    const Input& input = system.model.inputs[k];
    std::vector<std::string> places;
    if (!input.on.empty()) places.push_back(input.on);
    for (const Force& force : system.model.forces) {
      const bool is_named = std::ranges::any_of(
          force.value, [&](const Expression& value) { return names_input(value, input.name); });
      if (!is_named) continue;
      for (std::string& on : acted_on(force)) places.push_back(std::move(on));
    }
    const auto is_held = [&](const std::string& on) {
      return !on.empty() && is_locked(system.scene, on);
    };
    if (places.empty() || !std::ranges::all_of(places, is_held)) acting.push_back(k);
  }
  return acting;
}

}  // namespace elgen::test::random
