// Forces on velocities, at points and on frames; outputs that a model declares.
#include <array>

#include "base/reason.hpp"
#include "check/entries/entries.hpp"
#include "check/entries/in_frame.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"
#include "check/expressions/wrench_input.hpp"

namespace elgen {
namespace {

constexpr ExpressionRole force_place{"a force", place::force_terms, Code::E319, true};
constexpr ExpressionRole torque_place{"a torque", place::force_terms, Code::E319, true};

void read_generalized_force(ValueReader& values, const KeySyntax& on, const KeySyntax& value,
                            Force& force) {
  Context& context = values.context();
  force.velocity = values.resolve_velocity_name(on.value);
  const auto unit =
      force.velocity ? force_unit(context.model.velocities[*force.velocity]) : std::nullopt;
  force.value = values.read_roots(value.value, {force_place, unit});
  if (value.value.kind == ValueKind::list) {
    context.report.add(Reason::list_for_number, value.value.span,
                       "a list, but a generalised force is one number");
  }
}

/// The frame that the key `name` gives; none: the world. `usual` if the entry lacks the key.
std::optional<std::uint32_t> read_axes(ValueReader& values, const EntrySyntax& entry,
                                       std::string_view name, std::optional<std::uint32_t> usual) {
  const KeySyntax* key = entry.find(name);
  return key == nullptr ? usual : values.resolve_frame_or_world(key->value);
}

/// The declared components of `force`, converted from its axes to the axes of the frame `axes`
/// (none: world axes).
std::vector<ExpressionId> components_in_axes(std::optional<std::uint32_t> axes, const Force& force,
                                             Context& context) {
  NodeBuilder nodes(context, force.span);
  const Vector3 components =
      change_axes(nodes, pad_to_three(force.declared_value), force.declared_axes, axes);
  return {components.begin(), components.end()};
}

void read_point_force(ValueReader& values, const EntrySyntax& entry, Force& force) {
  Context& context = values.context();
  const KeySyntax& value = *entry.find("value");
  force.point = values.resolve_reference(entry.find("at")->value, SymbolKind::point);
  force.declared_axes = read_axes(values, entry, "in", std::nullopt);
  force.value = values.read_roots(value.value, {force_place, find_unit("N")});
  const std::size_t count = force.value.size();
  if (force.point && count != context.model.points[*force.point].dimension) {
    context.report.add(Code::E516, value.value.span,
                       count_text(count, "component") + ", but the point has " +
                           std::to_string(context.model.points[*force.point].dimension));
  }
  force.value.resize(3, no_expression);
  if (const KeySyntax* from = entry.find("from")) {
    force.reaction_point = values.resolve_reference(from->value, SymbolKind::point);
  }
  force.declared_value = force.value;
  force.value = components_in_axes(std::nullopt, force, context);
}

void read_torque(ValueReader& values, const EntrySyntax& entry, Force& force) {
  Context& context = values.context();
  const KeySyntax& value = *entry.find("value");
  force.frame = values.resolve_reference(entry.find("frame")->value, SymbolKind::frame);
  force.declared_axes = read_axes(values, entry, "in", force.frame);
  force.value = values.read_roots(value.value, {torque_place, *find_unit("N") * *find_unit("m")});
  const std::size_t expected = context.dimension == 2 ? 1 : 3;
  if (force.value.size() != expected) {
    context.report.add(Code::E516, value.value.span,
                       count_text(force.value.size(), "component") + ", but a torque has " +
                           std::to_string(expected));
    force.value.resize(expected, no_expression);
  }
  if (expected == 1) force.value = {no_expression, no_expression, force.value.front()};
  force.reaction_frame = read_axes(values, entry, "from", std::nullopt);
  force.declared_value = force.value;
  force.value = components_in_axes(force.frame, force, context);
  if (force.reaction_frame)
    force.reaction = components_in_axes(force.reaction_frame, force, context);
}

/// Leaves of `count` consecutive inputs.
std::vector<ExpressionId> input_leaves(Context& context, std::uint32_t first, std::uint32_t count,
                                       const Span& span) {
  NodeBuilder nodes(context, span);
  std::vector<ExpressionId> all;
  for (std::uint32_t i = 0; i < count; ++i) all.push_back(nodes.leaf(Opcode::input, first + i));
  return all;
}

/// Adds a point at the origin of a frame. Expressions cannot name this point (`is_named` is false).
std::uint32_t add_origin_point(Context& context, std::uint32_t frame, const Span& span) {
  Point point;
  point.name = context.model.frames[frame].name;
  point.identifier = context.model.frames[frame].identifier + "_origin";
  point.dimension = context.is_planar ? 2 : 3;
  point.local = PointInFrame{frame, {no_expression, no_expression, no_expression}};
  NodeBuilder nodes(context, span);
  point.position = frame_vector(nodes, frame, frame_origin);
  point.is_named = false;
  point.span = span;
  context.model.points.push_back(std::move(point));
  return static_cast<std::uint32_t>(context.model.points.size() - 1);
}

constexpr std::array<std::string_view, 3> force_keys{"on", "at", "frame"};
constexpr std::array<std::string_view, 3> output_keys{"value", "point", "frame"};

/// The only key among `on`, `at` and `frame`; null after an error.
const KeySyntax* find_force_key(const EntrySyntax& entry, Report& report) {
  const auto [first, second] = first_two_keys(entry, force_keys);
  if (first == nullptr) {
    report.add(Reason::not_one_alternative, entry.span,
               "the force has none of `on`, `at` and `frame`");
  }
  if (second == nullptr) return first;
  report.add(Reason::not_one_alternative, second->key_span,
             "a force has exactly one of `on`, `at` and `frame`");
  return nullptr;
}

/// The components x(P), y(P), z(P) of the point that `name` gives; empty after an error.
std::vector<ExpressionId> read_position(ValueReader& values, const ValueSyntax& name,
                                        const RootRequest& request) {
  const auto point = values.resolve_reference(name, SymbolKind::point);
  if (!point) return {};
  std::vector<ExpressionId> position;
  for (std::uint32_t i = 0; i < values.context().model.points[*point].dimension; ++i) {
    const ExpressionSyntax component{.kind = SyntaxKind::call,
                                     .text = std::string(1, "xyz"[i]),
                                     .operands = {name.expression},
                                     .span = name.span,
                                     .token = name.span};
    position.push_back(values.read_root(component, request));
  }
  return position;
}

/// Reads the output of a frame: the pose [R p], and the twist. The key `axes` names the axes of the
/// twist: `world` (the default) or the frame itself.
void read_frame_output(ValueReader& values, const EntrySyntax& entry, UserOutput& output) {
  Context& context = values.context();
  output.frame = values.resolve_reference(entry.find("frame")->value, SymbolKind::frame);
  if (!output.frame) return;
  const std::optional<std::uint32_t> axes = read_axes(values, entry, "axes", std::nullopt);
  if (axes && axes != output.frame) {
    context.report.add(Reason::foreign_axes, entry.find("axes")->value.span,
                       "`axes` is `world` or the frame itself");
    return;
  }
  output.is_in_world = !axes;
  set_frame_output(context, output);
}

}  // namespace

void read_force(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  Context& context = values.context();
  Force& force = context.model.forces[target];
  const KeySyntax* value = entry.find("value");
  if (value == nullptr) return;
  const KeySyntax* place = find_force_key(entry, context.report);
  if (place == nullptr) return;
  if (place->key == "on") {
    read_generalized_force(values, *place, *value, force);
  } else if (place->key == "at") {
    read_point_force(values, entry, force);
  } else {
    read_torque(values, entry, force);
  }
}

void read_wrench_input(ValueReader& values, const EntrySyntax& entry, std::uint32_t first) {
  if (!is_wrench_input(entry)) return;
  Context& context = values.context();
  const WrenchComponentCounts count = count_wrench_components(context, entry);
  Force force;
  force.name = entry.find("name")->value.expression.text;
  force.span = entry.span;
  force.declared_axes = read_axes(values, entry, "in", std::nullopt);
  if (const KeySyntax* at = entry.find("at")) {
    force.point = values.resolve_reference(at->value, SymbolKind::point);
    if (!force.point) return;
  } else {
    const auto frame = values.resolve_reference(entry.find("wrench")->value, SymbolKind::frame);
    if (!frame) return;
    force.point = add_origin_point(context, *frame, entry.span);
    Force torque = force;
    torque.point.reset();
    torque.frame = frame;
    torque.declared_value = input_leaves(context, first, count.torque, entry.span);
    if (count.torque == 1)
      torque.declared_value = {no_expression, no_expression, torque.declared_value.front()};
    torque.value = components_in_axes(frame, torque, context);
    context.model.forces.push_back(std::move(torque));
  }
  force.declared_value = input_leaves(context, first + count.torque, count.force, entry.span);
  force.declared_value.resize(3, no_expression);
  force.value = components_in_axes(std::nullopt, force, context);
  context.model.forces.push_back(std::move(force));
}

void read_output(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  UserOutput& output = values.context().model.outputs[target];
  output.solves_motion = is_flag_set(entry.find("motion"));
  constexpr Ingredients usual = place::state_terms | uses_acceleration | uses_input | uses_kink;
  const Ingredients allowed = output.solves_motion ? usual | uses_multiplier : usual;
  const ExpressionRole place{"an output", allowed};
  const auto [given, second] = first_two_keys(entry, output_keys);
  if (given == nullptr || second != nullptr) {
    values.context().report.add(Reason::not_one_alternative, entry.span,
                                "an output has exactly one of `value`, `point` and `frame`");
  } else if (given->key == "value") {
    output.values = values.read_roots(given->value, {place});
  } else if (given->key == "point") {
    output.values = read_position(values, given->value, {place});
  } else {
    read_frame_output(values, entry, output);
    if (const KeySyntax* const motion = entry.find("motion"); output.solves_motion) {
      values.context().report.add(
          Reason::pose_without_motion, motion->key_span,
          "`motion` needs a `value`: the pose of a frame has no accelerations");
    }
  }
  output.has_jacobian = is_flag_set(entry.find("jacobian"));
}

}  // namespace elgen
