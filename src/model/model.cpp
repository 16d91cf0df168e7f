// Model: adds coordinates with their velocities, renumbers variables after held variables are
// removed, and finds open values by linear search, because a model has few open values.
#include "elgen/model.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "elgen/references.hpp"
#include "model/elimination.hpp"

namespace elgen {

std::uint32_t append_coordinate(Model& model, Coordinate coordinate) {
  const auto index = static_cast<std::uint32_t>(model.coordinates.size());
  coordinate.velocity = static_cast<std::uint32_t>(model.velocities.size());
  Velocity velocity;
  velocity.name = coordinate.name;
  velocity.identifier = coordinate.identifier;
  velocity.coordinate = index;
  velocity.span = coordinate.span;
  if (coordinate.unit) velocity.unit = *coordinate.unit / *find_unit("s");
  model.velocities.push_back(std::move(velocity));
  model.coordinates.push_back(std::move(coordinate));
  return index;
}

std::uint32_t append_rotation(Model& model, Rotation rotation) {
  static constexpr std::array<const char*, quaternion_size> components{"_w", "_x", "_y", "_z"};
  const auto index = static_cast<std::uint32_t>(model.rotations.size());
  rotation.first_coordinate = static_cast<std::uint32_t>(model.coordinates.size());
  rotation.first_velocity = static_cast<std::uint32_t>(model.velocities.size());
  for (const char* component : components) {
    Coordinate coordinate;
    coordinate.name = rotation.name + component;
    coordinate.identifier = rotation.identifier + component;
    coordinate.unit = Unit{};
    coordinate.velocity = rotation.first_velocity;
    coordinate.rotation = index;
    coordinate.span = rotation.span;
    model.coordinates.push_back(std::move(coordinate));
  }
  model.coordinates[rotation.first_coordinate].start_value = 1;
  for (std::uint32_t axis = 1; axis <= axis_count; ++axis) {
    Velocity velocity;
    velocity.name = rotation.name + "[" + std::to_string(axis) + "]";
    velocity.identifier = rotation.identifier + "_" + std::to_string(axis);
    velocity.coordinate = rotation.first_coordinate;
    velocity.rotation = index;
    velocity.unit = Unit{} / *find_unit("s");
    velocity.span = rotation.span;
    model.velocities.push_back(std::move(velocity));
  }
  model.rotations.push_back(std::move(rotation));
  return index;
}

namespace {

/// The velocities on which a force does work: none, only locked velocities, or free velocities too.
enum class WorkTarget : std::uint8_t { nothing, locks, others };

WorkTarget work_target(const Model& whole, const Force& force) {
  if (force.velocity)
    return has_velocity(whole.reduction.locks, *force.velocity) ? WorkTarget::locks
                                                                : WorkTarget::others;
  WorkTarget reach = WorkTarget::nothing;
  for (const ExpressionId id : reachable_expressions(whole, work_expressions(whole, force))) {
    const Expression& node = whole.expressions[id];
    const bool is_place = is_leaf(node, Opcode::coordinate);
    if (!is_place && !is_leaf(node, Opcode::velocity)) continue;
    const std::uint32_t velocity = is_place ? whole.coordinates[node.index].velocity : node.index;
    if (!has_velocity(whole.reduction.locks, velocity)) return WorkTarget::others;
    reach = WorkTarget::locks;
  }
  return reach;
}

RemainingIndices remaining_inputs(const Model& whole) {
  RemainingIndices left(whole.inputs.size());
  if (whole.reduction.locks.empty()) return left;
  std::vector<WorkTarget> reaches(whole.inputs.size(), WorkTarget::nothing);
  const auto note = [&](WorkTarget reach, const std::vector<ExpressionId>& roots) {
    for (const ExpressionId id : reachable_expressions(whole, roots)) {
      const Expression& node = whole.expressions[id];
      if (!is_leaf(node, Opcode::input)) continue;
      reaches[node.index] = std::max(reaches[node.index], reach);
    }
  };
  for (const Force& force : whole.forces) note(work_target(whole, force), force.value);
  for (const UserOutput& output : whole.outputs) {
    if (output.is_requested) note(WorkTarget::others, output.values);
  }
  for (std::uint32_t i = 0; i < whole.inputs.size(); ++i) {
    const std::optional<std::uint32_t>& on = whole.inputs[i].velocity;
    if (on)
      reaches[i] =
          std::max(reaches[i], has_velocity(whole.reduction.locks, *on) ? WorkTarget::locks
                                                                        : WorkTarget::others);
  }
  const std::vector<WorkTarget> alone = reaches;
  for (std::uint32_t i = 0; i < whole.inputs.size(); ++i) {
    // An input that does no work is removed if its wrench has an input that acts only on locks.
    for (std::uint32_t k = 0; k < whole.inputs.size() && alone[i] == WorkTarget::nothing; ++k) {
      const bool is_of_wrench =
          whole.inputs[i].is_external && whole.inputs[k].span == whole.inputs[i].span;
      if (is_of_wrench && alone[k] == WorkTarget::locks) reaches[i] = WorkTarget::locks;
    }
    if (reaches[i] == WorkTarget::locks) left.remove(i, 1);
  }
  return left;
}

}  // namespace

RemainingVariables remaining_variables(const Model& whole) {
  RemainingVariables left{RemainingIndices(whole.coordinates.size()),
                          RemainingIndices(whole.velocities.size()), remaining_inputs(whole)};
  for (const HeldCoordinate& held : whole.reduction.locks) left.remove(held);
  for (const HeldCoordinate& held : whole.reduction.cyclic) left.remove(held);
  return left;
}

bool has_plane_vectors(const Model& model) {
  const auto is_in_plane = [](const auto& entry) { return entry.dimension == 2; };
  return std::ranges::all_of(model.points, is_in_plane) &&
         std::ranges::all_of(model.bodies, is_in_plane);
}

bool eliminates_backward(const Model& model) {
  if (!model.frames.empty() && model.velocities.size() >= min_articulated_velocities) return true;
  std::vector<bool> carries(model.frames.size(), false);
  for (const Frame& frame : model.frames) {
    if (!frame.parent) continue;
    if (carries[*frame.parent]) return true;
    carries[*frame.parent] = true;
  }
  return false;
}

std::optional<std::uint32_t> find_open_value(const Model& model, std::uint32_t function,
                                             std::vector<std::uint32_t> by) {
  std::ranges::sort(by);
  for (std::uint32_t i = 0; i < model.open_values.size(); ++i) {
    const OpenValue& value = model.open_values[i];
    if (value.function == function && value.derivative_arguments == by) return i;
  }
  return std::nullopt;
}

std::optional<std::uint32_t> find_open_derivative(const Model& model, std::uint32_t value,
                                                  std::uint32_t argument) {
  std::vector<std::uint32_t> by = model.open_values[value].derivative_arguments;
  by.push_back(argument);
  return find_open_value(model, model.open_values[value].function, std::move(by));
}

}  // namespace elgen
