// Variables that a scene holds: `[lock] NAME = { value, reaction }` for a coordinate ("q[2]") or a
// rotation; `[routh] NAME = true`, or NAME = its momentum, which becomes a parameter.
#include <algorithm>
#include <utility>

#include "base/reason.hpp"
#include "check/expressions/node_builder.hpp"
#include "check/expressions/parameters.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"
#include "check/scene/scene.hpp"

namespace elgen {
namespace {

/// Reports E208 or E612 for a key that names neither a coordinate nor a rotation.
void report_unknown_coordinate(Context& context, const KeySyntax& key) {
  const SymbolTable& symbols = context.symbols;
  const DeclaredName* symbol = symbols.find(key.key);
  if (symbol != nullptr && symbol->kind == SymbolKind::coordinate && symbol->is_array) {
    context.report.add(Code::E208, key.key_span,
                       quote_text(key.key) + " needs an index: " + elements_of(key.key, *symbol));
    return;
  }
  context.report.add(
      Code::E612, key.key_span, "unknown coordinate " + quote_text(key.key),
      symbols.suggest(key.key, symbols.names({SymbolKind::coordinate, SymbolKind::rotation})));
}

/// The coordinate or rotation that a key names; none after E208 or E612.
std::optional<HeldCoordinate> find_held_coordinate(Context& context, const KeySyntax& key) {
  const Model& model = context.model;
  const auto rotation = std::ranges::find(model.rotations, key.key, &Rotation::name);
  if (rotation != model.rotations.end()) {
    return HeldCoordinate{rotation->first_coordinate, rotation->first_velocity, true, false,
                          key.key_span};
  }
  const auto found = std::ranges::find(model.coordinates, key.key, &Coordinate::name);
  if (found == model.coordinates.end() || found->rotation) {
    report_unknown_coordinate(context, key);
    return std::nullopt;
  }
  const auto index = static_cast<std::uint32_t>(found - model.coordinates.begin());
  return HeldCoordinate{index, found->velocity, false, false, key.key_span};
}

class HeldCoordinateReader {
 public:
  explicit HeldCoordinateReader(Context& context)
      : context_(context), model_(context.model), values_(context) {}

  void read_locks(const EntrySyntax& entry) {
    std::vector<LockedCoordinate>& locks = model_.reduction.locks;
    for (const KeySyntax& key : entry.keys) read_lock(key);
    std::ranges::sort(locks, {}, &LockedCoordinate::velocity);
    if (!locks.empty() && is_immobile()) {
      report_lock_error(entry.span, "every coordinate is locked, so nothing moves");
    }
  }

  void read_cyclic(const EntrySyntax& entry) {
    std::vector<CyclicCoordinate>& cyclic = model_.reduction.cyclic;
    for (const KeySyntax& key : entry.keys) read_cyclic(key);
    std::ranges::sort(cyclic, {}, &CyclicCoordinate::velocity);
    if (!cyclic.empty() && is_immobile()) {
      context_.report.add(Reason::nothing_moves, entry.span,
                          "every coordinate is removed or locked, so nothing moves");
    }
    for (CyclicCoordinate& item : cyclic) declare_momentum(item);
  }

 private:
  void read_lock(const KeySyntax& key) {
    const KeySyntax* value = key.value.find("value");
    if (value == nullptr) return;  // reported by the parser
    const std::optional<HeldCoordinate> held = find_held_coordinate(context_, key);
    if (!held) return;
    LockedCoordinate lock{*held, {}};
    lock.has_reaction = is_flag_set(key.value.find("reaction"));
    lock.values =
        lock.is_rotation
            ? read_unit_quaternion(value->value)
            : std::vector{read_time_function(value->value, model_.coordinates[lock.coordinate])};
    model_.reduction.locks.push_back(std::move(lock));
  }

  ExpressionId read_time_function(const ValueSyntax& value, const Coordinate& coordinate) {
    if (value.kind == ValueKind::list) {
      context_.report.add({Code::E615, value.span, "a list, but the coordinate is one number", "",
                           coordinate.span, quote_text(coordinate.name) + " is declared here"});
      return no_expression;
    }
    const ExpressionRole place{"the value of a lock", place::time_terms};
    const ExpressionId id = values_.read_scene_value(value, {place, coordinate.unit});
    note_degrees(context_.report, value.span, coordinate, context_.constants[id]);
    return id;
  }

  /// The quaternion scaled to length 1; every later stage relies on this length.
  std::vector<ExpressionId> read_unit_quaternion(const ValueSyntax& value) {
    std::vector<ExpressionId> components(quaternion_size, no_expression);
    if (value.kind != ValueKind::list || value.items.size() != quaternion_size) {
      report_lock_error(value.span, in_backticks(value.span) + " is not a quaternion [w, x, y, z]");
      return components;
    }
    bool is_zero = true;
    for (std::size_t i = 0; i < quaternion_size; ++i) {
      const auto number = values_.read_constant(value.items[i]);
      if (!number) return components;
      is_zero = is_zero && cln::zerop(*number);
      components[i] = values_.root(value.items[i], {{"a quaternion", place::constants_only}});
    }
    if (is_zero) {
      report_lock_error(value.span, "a quaternion of length 0 has no direction");
      return components;
    }
    NodeBuilder nodes(context_, value.span);
    std::vector<ExpressionId> squares;
    for (const ExpressionId component : components) squares.push_back(nodes.power(component, 2));
    const ExpressionId length = nodes.power(nodes.add(squares), cln::cl_RA(1) / 2);
    for (ExpressionId& component : components) component = nodes.divide(component, length);
    return components;
  }

  void read_cyclic(const KeySyntax& key) {
    const std::optional<HeldCoordinate> held = find_held_coordinate(context_, key);
    const bool is_given = key.value.kind != ValueKind::boolean;
    if (!held || !check_can_be_cyclic(*held, key) || !(is_given || key.value.boolean)) return;
    CyclicCoordinate cyclic{*held, 0, {}};
    if (is_given) {
      const ExpressionRole place{"a momentum", place::parameters_only};
      cyclic.exact_expression = values_.read_scene_value(key.value, {place, momentum_unit(cyclic)});
    }
    model_.reduction.cyclic.push_back(cyclic);
  }

  /// True if the variable can be cyclic; false after E635 if it is a rotation or locked.
  bool check_can_be_cyclic(const HeldCoordinate& held, const KeySyntax& key) {
    const std::string name = quote_text(key.key);
    if (held.is_rotation) {
      context_.report.add(Reason::cyclic_is_rotation, held.span,
                          name + " is a rotation, which has no single momentum");
      return false;
    }
    const std::vector<LockedCoordinate>& locks = model_.reduction.locks;
    const auto lock = std::ranges::find(locks, held.coordinate, &LockedCoordinate::coordinate);
    if (lock == locks.end()) return true;
    context_.report.add(
        {Reason::cyclic_is_locked, held.span, name + " is locked", "", lock->span, "here"});
    return false;
  }

  [[nodiscard]] bool is_immobile() const {
    std::size_t count = model_.reduction.cyclic.size();
    for (const LockedCoordinate& lock : model_.reduction.locks) count += lock.velocity_count();
    return count == model_.velocities.size();
  }

  /// The unit J/[v] of the momentum; none if the velocity has no unit: then no unit is checked.
  [[nodiscard]] std::optional<Unit> momentum_unit(const CyclicCoordinate& cyclic) const {
    const std::optional<Unit>& rate = model_.velocities[cyclic.velocity].unit;
    return rate ? std::optional(*find_unit("J") / *rate) : std::nullopt;
  }

  void declare_momentum(CyclicCoordinate& cyclic) {
    const Coordinate& coordinate = model_.coordinates[cyclic.coordinate];
    const std::string name = "p_" + coordinate.identifier;
    cyclic.parameter = static_cast<std::uint32_t>(model_.parameters.size());
    if (const DeclaredName* const item = context_.symbols.find(name)) {
      context_.report.add({Reason::momentum_name, cyclic.span,
                           quote_text(name) + ", the name of the momentum of " +
                               quote_text(coordinate.name) + ", is already declared",
                           "", item->span, "declared here"});
      return;
    }
    if (!append_parameter_array(context_, {name, {}, cyclic.span}, 1, false)) return;
    Parameter& momentum = model_.parameters.back();
    momentum.unit = momentum_unit(cyclic);
    ParameterArray& array = model_.parameter_arrays.back();
    if (momentum.unit) array.unit_text = to_string(*momentum.unit);
    if (!coordinate.latex.empty()) array.latex = "p_{" + coordinate.latex + "}";
    array.doc = "constant momentum of " + coordinate.name;
  }

  void report_lock_error(const Span& span, const std::string& message) {
    context_.report.add(Code::E615, span, message);
  }

  Context& context_;
  Model& model_;
  ValueReader values_;
};

}  // namespace

void set_cyclic_momentum(Model& model, std::uint32_t parameter, const cln::cl_R& value) {
  for (CyclicCoordinate& cyclic : model.reduction.cyclic) {
    if (cyclic.parameter == parameter) cyclic.momentum = value;
  }
}

void read_held_coordinates(Context& context, const FileSyntax* scene) {
  HeldCoordinateReader reader(context);
  if (const EntrySyntax* locks = find_entry(scene, "lock")) reader.read_locks(*locks);
  if (const EntrySyntax* cyclic = find_entry(scene, "routh")) reader.read_cyclic(*cyclic);
}

}  // namespace elgen
