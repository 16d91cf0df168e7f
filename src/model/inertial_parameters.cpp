// inertial_parameters: the entries of pi, and the test whether an expression is affine in
// parameters.
#include "elgen/inertial_parameters.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "elgen/references.hpp"

namespace elgen {
namespace {

constexpr std::array<std::string_view, body_component_count> component_names{
    "m", "mx", "my", "mz", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"};
constexpr std::array<std::uint32_t, 4> planar_components{0, 1, 2, 6};

std::optional<Unit> unit_of_component(std::uint32_t component) {
  const int length = component == 0 ? 0 : component < first_inertia_component ? 1 : 2;
  return *find_unit("kg") * power(*find_unit("m"), {length, 1});
}

class InertialEntryCollector {
 public:
  explicit InertialEntryCollector(const Model& model) : model_(model) {}

  std::vector<InertialEntry> build() && {
    for (const bool in_frames : {true, false}) {
      for (std::uint32_t i = 0; i < model_.bodies.size(); ++i) {
        if (model_.bodies[i].local.has_value() == in_frames) add_body(i);
      }
    }
    for (std::uint32_t i = 0; i < model_.points.size(); ++i) {
      if (model_.points[i].mass) list_.push_back({InertialOwner::point, i});
    }
    for (std::uint32_t i = 0; i < model_.coordinates.size(); ++i) {
      if (model_.coordinates[i].armature) list_.push_back({InertialOwner::coordinate, i});
    }
    for (const std::uint32_t i : model_.affine_parameters) {
      list_.push_back({InertialOwner::parameter, i});
    }
    return std::move(list_);
  }

 private:
  void add_component(std::uint32_t body, std::uint32_t component) {
    list_.push_back({InertialOwner::body, body, component});
  }

  void add_body(std::uint32_t index) {
    const Body& body = model_.bodies[index];
    if (body.local && body.dimension == 2) {
      for (const std::uint32_t component : planar_components) add_component(index, component);
      return;
    }
    if (body.local || body.mass) add_component(index, 0);
    for (std::uint32_t i = first_moment_component; body.local && i < first_inertia_component; ++i) {
      add_component(index, i);
    }
    const bool turns = body.local || (!body.inertia.empty() && !body.spin.empty());
    const bool is_planar = !body.local && body.inertia.size() == 1;
    if (turns && is_planar) add_component(index, planar_components.back());
    for (std::uint32_t i = first_inertia_component; turns && !is_planar && i < body_component_count;
         ++i) {
      add_component(index, i);
    }
  }

  const Model& model_;
  std::vector<InertialEntry> list_ = {};
};

std::optional<Unit> unit_of_armature(const Model& model, const Coordinate& coordinate) {
  const std::optional<Unit>& rate = model.velocities[coordinate.velocity].unit;
  return rate ? std::optional(*find_unit("J") / (*rate * *rate)) : std::nullopt;
}

/// Finds two parameters whose product an expression contains, or a parameter in which the
/// expression is not affine. Each node is tested after its operands.
class CouplingSearch {
 public:
  CouplingSearch(const Model& model, const std::vector<std::uint32_t>& parameters)
      : model_(model), parameters_(parameters) {}

  std::optional<CoupledParameters> find_coupling(ExpressionId root) {
    for (const ExpressionId id : reachable_expressions(model_, {root})) {
      if (const auto coupled = check_node(id)) return coupled;
    }
    return std::nullopt;
  }

 private:
  using Found = std::optional<CoupledParameters>;

  /// Any parameter that the expression contains; null if it contains none.
  [[nodiscard]] const std::uint32_t* find_parameter(ExpressionId id) const {
    const auto found = first_.find(id);
    return found == first_.end() ? nullptr : &found->second;
  }

  Found check_node(ExpressionId id) {
    const Expression& e = model_.expressions[id];
    if (is_leaf(e, Opcode::parameter) && std::ranges::count(parameters_, e.index) > 0) {
      first_.emplace(id, e.index);
      return std::nullopt;
    }
    for (const ExpressionId operand : references(model_, id)) {
      const std::uint32_t* const next = find_parameter(operand);
      if (next == nullptr) continue;
      const auto [known, is_new] = first_.emplace(id, *next);
      const bool multiplies = e.kind == ExpressionKind::multiply && !is_new;
      const bool bends = e.kind == ExpressionKind::power || e.kind == ExpressionKind::function ||
                         is_leaf(e, Opcode::open_value) ||
                         (e.kind == ExpressionKind::divide && operand == e.operands[1]);
      if (multiplies || bends) return CoupledParameters{known->second, *next};
    }
    return std::nullopt;
  }

  const Model& model_;
  const std::vector<std::uint32_t>& parameters_;
  std::map<ExpressionId, std::uint32_t> first_ = {};
};

/// For each parameter: true if `roots` contain the parameter, directly or through names.
std::vector<bool> contained_parameters(const Model& model, const std::vector<ExpressionId>& roots) {
  std::vector<bool> found(model.parameters.size());
  for (const ExpressionId id : reachable_expressions(model, roots)) {
    const Expression& e = model.expressions[id];
    if (is_leaf(e, Opcode::parameter)) found[e.index] = true;
  }
  return found;
}

}  // namespace

std::vector<InertialEntry> inertial_entries(const Model& model) {
  return InertialEntryCollector(model).build();
}

InertialParameter inertial_parameter(const Model& model, const InertialEntry& place) {
  switch (place.owner) {
    case InertialOwner::body: {
      const std::string component(component_names[place.component]);
      return {place, model.bodies[place.index].name + "." + component,
              unit_of_component(place.component)};
    }
    case InertialOwner::point:
      return {place, model.points[place.index].name + ".m", find_unit("kg")};
    case InertialOwner::coordinate: {
      const Coordinate& coordinate = model.coordinates[place.index];
      return {place, "armature." + coordinate.name, unit_of_armature(model, coordinate)};
    }
    case InertialOwner::parameter:
      break;
  }
  const Parameter& parameter = model.parameters[place.index];
  return {place, parameter.name, parameter.unit};
}

std::vector<InertialParameter> inertial_parameters(const Model& model) {
  std::vector<InertialParameter> list;
  for (const InertialEntry& place : inertial_entries(model)) {
    list.push_back(inertial_parameter(model, place));
  }
  return list;
}

std::optional<CoupledParameters> find_coupled_parameters(
    const Model& model, ExpressionId expression, const std::vector<std::uint32_t>& parameters) {
  return CouplingSearch(model, parameters).find_coupling(expression);
}

std::vector<std::uint32_t> friction_parameters(const Model& model) {
  const std::vector<ExpressionId> roots = dissipation_roots(model);
  if (roots.empty()) return {};
  const ExpressionId dissipation = roots.front();
  std::vector<ExpressionId> others = equation_roots(model);
  std::erase(others, dissipation);
  const std::vector<bool> elsewhere = contained_parameters(model, others);
  const std::vector<bool> in_dissipation = contained_parameters(model, {dissipation});
  std::vector<std::uint32_t> parameters;
  for (std::uint32_t i = 0; i < model.parameters.size(); ++i) {
    if (in_dissipation[i] && !elsewhere[i]) parameters.push_back(i);
  }
  while (const auto coupled = find_coupled_parameters(model, dissipation, parameters)) {
    std::erase(parameters, coupled->first);
    std::erase(parameters, coupled->second);
  }
  return parameters;
}

}  // namespace elgen
