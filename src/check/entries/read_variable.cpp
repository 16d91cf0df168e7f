// Coordinates, inputs, open and prescribed functions.
#include <algorithm>
#include <utility>
#include <vector>

#include "base/reason.hpp"
#include "check/entries/entries.hpp"
#include "check/expressions/open_functions.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/rotations.hpp"
#include "check/expressions/units.hpp"
#include "check/expressions/values.hpp"
#include "check/expressions/wrench_input.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

/// The declared unit; none without a declaration, or if the model's units are all 1 and thus not
/// checked.
std::optional<Unit> read_declared_unit(const EntrySyntax& entry, Context& context) {
  const KeySyntax* key = entry.find("unit");
  if (key == nullptr) return std::nullopt;
  const std::optional<Unit> unit = read_unit(key->value, context.report);
  return context.has_units ? unit : std::nullopt;
}

/// The start of a plain coordinate. E104 for a list, which only a rotation may have.
cln::cl_R read_start_constant(ValueReader& values, const ValueSyntax& value) {
  if (value.kind == ValueKind::list) {
    values.context().report.add(Reason::list_for_number, value.span,
                                "a list, but the coordinate is one number",
                                "write `start = { value = 0.3, rate = 0.2 }`");
    return 0;
  }
  return values.read_constant(value).value_or(0);
}

void read_start(ValueReader& values, const ValueSyntax& table, Coordinate& coordinate) {
  if (const KeySyntax* value = table.find("value")) {
    coordinate.start_value = read_start_constant(values, value->value);
    note_degrees(values.context().report, value->value.span, coordinate, coordinate.start_value);
  }
  if (const KeySyntax* rate = table.find("rate")) {
    values.context().model.velocities[coordinate.velocity].start_rate =
        read_start_constant(values, rate->value);
  }
}

void check_wrap(Context& context, const EntrySyntax& entry, const Coordinate& coordinate) {
  // The unit rad equals 1. A coordinate of a model without units has no unit and may wrap.
  const bool is_angle = coordinate.unit.value_or(*find_unit("rad")) == *find_unit("rad");
  if (!coordinate.wraps || is_angle) return;
  context.report.add(
      Code::E528, entry.find("wrap")->key_span,
      quote_text(coordinate.name) + " is in " + coordinate.unit_text + ", but only angles wrap");
}

bool is_outside(const cln::cl_R& value, const std::optional<Interval>& range) {
  return range && (value < range->low || value > range->high);
}

void check_start(Context& context, const ValueSyntax& table, const Coordinate& coordinate) {
  const Velocity& velocity = context.model.velocities[coordinate.velocity];
  const auto warn = [&](std::string_view key, const cln::cl_R& value,
                        const std::optional<Interval>& range) {
    const KeySyntax* const given = table.find(key);
    if (given == nullptr || !is_outside(value, range)) return;
    context.report.add(Code::E529, given->value.span,
                       in_backticks(given->value.span) + " is outside [" + exact_text(range->low) +
                           ", " + exact_text(range->high) + "]");
  };
  warn("value", coordinate.start_value, coordinate.range);
  warn("rate", velocity.start_rate, velocity.rate_range);
}

void read_rate(ValueReader& values, const EntrySyntax& entry, const Coordinate& coordinate) {
  Velocity& velocity = values.context().model.velocities[coordinate.velocity];
  velocity.rate_range = values.read_interval(entry, "rate_range");
  if (coordinate.unit) velocity.unit = *coordinate.unit / *find_unit("s");
}

/// The unit of the armature J, from the energy 1/2 J v^2.
std::optional<Unit> armature_unit(const Coordinate& coordinate) {
  if (!coordinate.unit) return std::nullopt;
  const Unit rate = *coordinate.unit / *find_unit("s");
  return *find_unit("J") / power(rate, {2, 1});
}

void check_input_unit(Context& context, const Input& input, const ValueSyntax& unit) {
  const Velocity& velocity = context.model.velocities[*input.velocity];
  const std::optional<Unit> expected = force_unit(velocity);
  if (input.unit && expected && *input.unit != *expected) {
    context.report.add(Code::E403, unit.span,
                       quote_text(input.name) + " is in " + input.unit_text + ", but a force on " +
                           quote_text(velocity.name) + " is in " + force_unit_text(*expected));
  }
}

}  // namespace

std::optional<Unit> force_unit(const Velocity& velocity) {
  return velocity.unit ? std::optional(*find_unit("W") / *velocity.unit) : std::nullopt;
}

void read_coordinate(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  if (is_rotation(entry)) return read_rotation(values, entry, target);
  Context& context = values.context();
  Coordinate& coordinate = context.model.coordinates[target];
  coordinate.unit = read_declared_unit(entry, context);
  coordinate.range = values.read_interval(entry, "range");
  if (coordinate.range) {
    const std::vector<ValueSyntax>& ends = entry.find("range")->value.items;
    note_degrees(context.report, ends[0].span, coordinate, coordinate.range->low);
    note_degrees(context.report, ends[1].span, coordinate, coordinate.range->high);
  }
  coordinate.wraps = is_flag_set(entry.find("wrap"));
  check_wrap(context, entry, coordinate);
  read_rate(values, entry, coordinate);
  if (const KeySyntax* start = entry.find("start")) {
    read_start(values, start->value, coordinate);
    check_start(context, start->value, coordinate);
  }
  const ExpressionRole armature{"an armature", place::parameters_only, Code::E506};
  coordinate.armature = values.root(entry, "armature", {armature, armature_unit(coordinate)});
  const ExpressionRole singular{"a singular configuration", place::configuration_terms};
  coordinate.singular_condition = values.root(entry, "singular", {singular});
}

void read_input(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  Context& context = values.context();
  if (is_wrench_input(entry)) {
    const WrenchComponentCounts count = count_wrench_components(context, entry);
    const std::optional<Interval> limits = values.read_interval(entry, "limits");
    for (std::uint32_t i = 0; i < count.torque + count.force; ++i) {
      context.model.inputs[target + i].limits = limits;
    }
    return;
  }
  Input& input = context.model.inputs[target];
  input.unit = read_declared_unit(entry, context);
  input.limits = values.read_interval(entry, "limits");
  if (const KeySyntax* on = entry.find("on"))
    input.velocity = values.resolve_velocity_name(on->value);
  if (const KeySyntax* unit = entry.find("unit"); unit != nullptr && input.velocity) {
    check_input_unit(context, input, unit->value);
  }
}

void read_arguments(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  const KeySyntax* of = entry.find("of");
  if (of == nullptr) return;
  Context& context = values.context();
  const std::size_t count = of->value.items.size();
  if (count == 0 || count > max_open_arguments) {
    context.report.add(Reason::wrong_list_length, of->value.span,
                       count_text(count, "argument") + ", but a function has 1 to " +
                           std::to_string(max_open_arguments));
  }
  const ExpressionRole place{"an argument of a function", place::state_terms};
  std::vector<ExpressionId> arguments = values.read_roots(of->value, {place});
  if (std::ranges::count(arguments, no_expression) == 0) {
    context.function_expressions[function_name(entry)].arguments = arguments;
  }
  if (find_function_replacement(context, entry) != nullptr || arguments.empty()) return;
  context.model.functions[target].arguments = std::move(arguments);
}

void read_function(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  Context& context = values.context();
  const std::optional<Unit> unit = read_declared_unit(entry, context);
  const RootRequest request{{"the expression of a function", place::state_terms}, unit};
  ExpressionId& value = context.function_expressions[function_name(entry)].value;
  const FunctionReplacement* closure = find_function_replacement(context, entry);
  if (closure == nullptr) {
    OpenFunction& function = context.model.functions[target];
    function.unit = unit;
    value = values.root(entry, "sample", request).value_or(no_expression);
    return;
  }
  NamedExpression& definition = context.model.definitions[target];
  definition.value = closure->is_of_scene ? values.read_scene_value(*closure->value, request)
                                          : values.root(*closure->value, request);
  value = definition.value;
}

void read_prescribed(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  Context& context = values.context();
  const std::optional<Unit> unit = read_declared_unit(entry, context);
  context.prescribed_units.resize(context.model.prescribed.size());
  context.prescribed_units[target] = unit;
  NamedExpression& prescribed = context.model.prescribed[target];
  const ExpressionRole place{"a prescribed function", place::time_terms};
  prescribed.value = values.root(entry, "value", {place, unit}).value_or(no_expression);
}

}  // namespace elgen
