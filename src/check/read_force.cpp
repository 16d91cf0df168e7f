// Forces on velocities and at points, and the outputs a model declares.
#include "entries.hpp"
#include "places.hpp"
#include "values.hpp"

namespace elgen::checking {
namespace {

constexpr Place force_place{"a force", place::of_force};

void read_generalized_force(ValueReader& values, const KeySyntax& on, const KeySyntax& value,
                            Force& force) {
  force.on = values.velocity(on.value);
  std::optional<Unit> unit;
  if (force.on) {
    unit = force_unit(values.context().model.velocities[*force.on]);
  }
  force.value = values.roots(value.value, {force_place, unit});
  if (value.value.kind == ValueKind::list) {
    values.context().report.add(Code::E104, value.value.span,
                                "a list, but a generalized force is one number");
  }
}

void read_point_force(ValueReader& values, const KeySyntax& at, const KeySyntax& value,
                      Force& force) {
  Context& context = values.context();
  force.at = values.reference(at.value, SymbolKind::point);
  force.value = values.roots(value.value, {force_place, find_unit("N")});
  const std::size_t count = force.value.size();
  if (force.at && count != context.model.points[*force.at].dimension) {
    context.report.add(Code::E516, value.value.span,
                       counted(count, "component") + ", but the point has " +
                           std::to_string(context.model.points[*force.at].dimension));
  }
  force.value.resize(3, no_expression);
}

bool has_one_place(const KeySyntax* on, const KeySyntax* at, const Span& header, Report& report) {
  if (on == nullptr && at == nullptr) {
    report.add(Code::E112, header, "neither `on` nor `at` says where the force acts");
    return false;
  }
  if (on != nullptr && at != nullptr) {
    const KeySyntax& second = on->key_span.begin < at->key_span.begin ? *at : *on;
    report.add(Code::E112, second.key_span, "a force has `on` or `at`, not both");
    return false;
  }
  return true;
}

void read_force(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  Context& context = values.context();
  Force force = context.model.forces[target];
  const KeySyntax* on = entry.find("on");
  const KeySyntax* at = entry.find("at");
  const KeySyntax* value = entry.find("value");
  if (value == nullptr) {
    return;
  }
  if (!has_one_place(on, at, entry.span, context.report)) {
    return;
  }
  if (on != nullptr) {
    read_generalized_force(values, *on, *value, force);
  } else {
    read_point_force(values, *at, *value, force);
  }
  if (const KeySyntax* from = entry.find("from")) {
    force.from = values.reference(from->value, SymbolKind::point);
  }
  context.model.forces[target] = std::move(force);
}

void read_output(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  UserOutput output = values.context().model.outputs[target];
  const Place place{"an output", place::of_configuration};
  if (const KeySyntax* value = entry.find("value")) {
    output.values = values.roots(value->value, {place});
  }
  if (const KeySyntax* jacobian = entry.find("jacobian")) {
    output.jacobian = jacobian->value.boolean;
  }
  output.doc = text_of(entry, "doc");
  values.context().model.outputs[target] = std::move(output);
}

}  // namespace

void read_force_or_output(Context& context, const Instance& instance) {
  ValueReader values(context, instance.scope);
  if (instance.entry->name == "force") {
    read_force(values, *instance.entry, instance.target);
  } else if (instance.entry->name == "output") {
    read_output(values, *instance.entry, instance.target);
  }
}

}  // namespace elgen::checking
