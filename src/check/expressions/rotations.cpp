// Rotations: four names in q, three names in v, and the keys of a [[coordinate]] of this kind.
#include "check/expressions/rotations.hpp"

#include <algorithm>
#include <array>

#include "base/reason.hpp"
#include "check/expressions/units.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

constexpr std::array<std::string_view, 4> scalar_keys{"range", "wrap", "singular", "armature"};

/// The square root, exact if it is rational.
cln::cl_R square_root(const cln::cl_R& square) {
  cln::cl_RA root = 0;
  const bool is_exact = is_rational(square) && cln::sqrtp(cln::rational(square), &root);
  if (is_exact) return root;
  return cln::sqrt(cln::cl_float(square, cln::float_format(constant_digits)));
}

bool declare_velocities(Context& context, const NewName& name, std::uint32_t first) {
  for (std::uint32_t axis = 1; axis <= axis_count; ++axis) {
    const NewName velocity{name.base, axis, name.span};
    const std::uint32_t target = first + axis - 1;
    if (!context.symbols.declare(velocity, SymbolKind::rotation, target, context.report)) {
      return false;
    }
  }
  return true;
}

bool declare_components(Context& context, const Rotation& rotation) {
  for (std::uint32_t i = 0; i < quaternion_size; ++i) {
    const std::uint32_t target = rotation.first_coordinate + i;
    const NewName component{context.model.coordinates[target].name, {}, rotation.span};
    if (!context.symbols.declare(component, SymbolKind::quaternion_component, target,
                                 context.report)) {
      return false;
    }
  }
  return true;
}

/// The constants of a list with `count` items; none after E104.
std::optional<std::vector<cln::cl_R>> read_constants(ValueReader& values, const ValueSyntax& value,
                                                     std::size_t count) {
  if (value.kind != ValueKind::list || value.items.size() != count) {
    const std::string given =
        value.kind == ValueKind::list ? count_text(value.items.size(), "component") : "one number";
    values.context().report.add(Reason::wrong_component_count, value.span,
                                given + ", but a rotation has " + std::to_string(count) + " here");
    return std::nullopt;
  }
  std::vector<cln::cl_R> result;
  for (const ValueSyntax& item : value.items) {
    const std::optional<cln::cl_R> constant = values.read_constant(item);
    if (!constant) return std::nullopt;
    result.push_back(*constant);
  }
  return result;
}

/// Reads the start quaternion and scales the quaternion to length 1.
void read_start_value(ValueReader& values, const ValueSyntax& value, const Rotation& rotation) {
  const auto quaternion = read_constants(values, value, quaternion_size);
  if (!quaternion) return;
  cln::cl_R square = 0;
  for (const cln::cl_R& component : *quaternion) square = square + component * component;
  if (cln::zerop(square)) {
    values.context().report.add(Reason::zero_direction, value.span,
                                "a quaternion of length 0 has no direction");
    return;
  }
  const cln::cl_R length = square_root(square);
  for (std::uint32_t i = 0; i < quaternion_size; ++i) {
    Coordinate& q = values.context().model.coordinates[rotation.first_coordinate + i];
    q.start_value = (*quaternion)[i] / length;
  }
}

void read_start(ValueReader& values, const ValueSyntax& table, const Rotation& rotation) {
  if (const KeySyntax* value = table.find("value")) {
    read_start_value(values, value->value, rotation);
  }
  const KeySyntax* rate = table.find("rate");
  const auto rates =
      rate == nullptr ? std::nullopt : read_constants(values, rate->value, axis_count);
  for (std::uint32_t i = 0; rates && i < axis_count; ++i) {
    values.context().model.velocities[rotation.first_velocity + i].start_rate = (*rates)[i];
  }
}

/// Reports E403 if the entry has a unit other than 1: a quaternion is dimensionless.
void check_unit(Context& context, const EntrySyntax& entry) {
  const KeySyntax* key = entry.find("unit");
  const std::optional<Unit> unit =
      key == nullptr ? std::nullopt : read_unit(key->value, context.report);
  if (unit && *unit != Unit{}) {
    context.report.add(Code::E403, key->value.span,
                       "a rotation is a pure number; its angular velocity is in rad/s");
  }
}

}  // namespace

bool is_rotation(const EntrySyntax& entry) {
  return entry.name == "coordinate" && text_value(entry, "kind") == "rotation";
}

std::optional<std::uint32_t> declare_rotation(Context& context, const EntrySyntax& entry,
                                              const NewName& name) {
  if (const KeySyntax* repetition = entry.find("for"); repetition != nullptr || name.index) {
    context.report.add(Reason::repeated_name,
                       repetition == nullptr ? name.span : repetition->key_span,
                       "a rotation cannot be repeated: its index counts its angular velocities");
    context.symbols.mark_failed(name.base);
    return std::nullopt;
  }
  const std::uint32_t target = append_rotation(context.model, make_row<Rotation>(entry, name));
  const Rotation& added = context.model.rotations[target];
  const bool declared =
      declare_velocities(context, name, added.first_velocity) && declare_components(context, added);
  return declared ? std::optional(target) : std::nullopt;
}

void read_rotation(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  Context& context = values.context();
  const Rotation& rotation = context.model.rotations[target];
  check_unit(context, entry);
  for (const KeySyntax& key : entry.keys) {
    if (std::ranges::find(scalar_keys, key.key) != scalar_keys.end()) {
      context.report.add(Reason::key_of_numbers, key.key_span,
                         "a rotation has no " + quote_text(key.key));
    }
  }
  const std::optional<Interval> rates = values.read_interval(entry, "rate_range");
  for (std::uint32_t i = 0; i < axis_count; ++i) {
    context.model.velocities[rotation.first_velocity + i].rate_range = rates;
  }
  if (const KeySyntax* start = entry.find("start")) read_start(values, start->value, rotation);
}

void check_rotations(Context& context) {
  const Model& model = context.model;
  std::vector<const Frame*> turned(model.rotations.size(), nullptr);
  for (const Frame& frame : model.frames) {
    for (const ElementaryTransform& transform : frame.transforms) {
      if (!transform.rotation) continue;
      const Frame*& first = turned[*transform.rotation];
      if (first != nullptr) {
        context.report.add(Reason::rotation_of_two_frames, frame.span,
                           quote_text(model.rotations[*transform.rotation].name) +
                               " is already the rotation of the frame " + quote_text(first->name));
      }
      first = &frame;
    }
  }
  // No E513 after other errors: the frame that the rotation turns may have failed to be read.
  for (std::size_t i = 0; i < turned.size() && context.report.error_count() == 0; ++i) {
    if (turned[i] != nullptr) continue;
    const Rotation& rotation = model.rotations[i];
    context.report.add(Code::E513, rotation.span,
                       quote_text(rotation.name) + " is the `rotation` of no [[frame]]");
  }
}

}  // namespace elgen
