// Units of the entries of outputs by the rules of the output table.
#include "model/output_units.hpp"

#include <algorithm>

#include "elgen/inertial_parameters.hpp"

namespace elgen {
namespace {

using MaybeUnit = std::optional<Unit>;

MaybeUnit over(const MaybeUnit& a, const MaybeUnit& b) {
  return a && b ? MaybeUnit(*a / *b) : std::nullopt;
}

template <class List>
MaybeUnit unit_in(const List& list, std::size_t i) {
  return i < list.size() ? list[i].unit : std::nullopt;
}

/// The unit of the i-th constraint on positions.
MaybeUnit unit_of_position(const Model& model, std::size_t i) {
  for (const Constraint& constraint : model.constraints) {
    if (constraint.is_position && i-- == 0) return constraint.unit;
  }
  return std::nullopt;
}

/// The unit of the i-th row or column; none if the model declares none.
MaybeUnit unit_along(const Model& model, Extent extent, std::size_t i) {
  switch (extent) {
    case Extent::one:
      return Unit{};
    case Extent::coordinates:
      return unit_in(model.coordinates, i);
    case Extent::velocities:
      return unit_in(model.velocities, i);
    case Extent::inputs:
      return unit_in(model.inputs, i);
    case Extent::held: {
      const std::vector<std::uint32_t> held = held_velocities(model);
      return i < held.size() ? unit_in(whole_of(model).velocities, held[i]) : std::nullopt;
    }
    case Extent::cyclic:
      return has_routhian(model)
                 ? unit_in(whole_of(model).velocities, model.variant.cyclic[i].velocity)
                 : std::nullopt;
    case Extent::constraints:
      return model.constraints[i].is_position ? over(unit_in(model.constraints, i), find_unit("s"))
                                              : unit_in(model.constraints, i);
    case Extent::positions:
      return unit_of_position(model, i);
    case Extent::inertial:
      return unit_in(inertial_parameters(model), i);
    case Extent::pivots:
    case Extent::states:
    case Extent::user:
    case Extent::user_columns:
    case Extent::task:
    case Extent::accelerations:
      break;
  }
  return std::nullopt;
}

}  // namespace

MaybeUnit unit_of_entry(const Model& model, const EntryPlace& place) {
  const FieldRow& field = field_row(place.kind, place.field);
  const MaybeUnit row = unit_along(model, field.rows, place.row);
  const MaybeUnit column = unit_along(model, field.columns, place.column);
  switch (field.unit) {
    case UnitRule::none:
      break;
    case UnitRule::number:
      return Unit{};
    case UnitRule::row:
      return row;
    case UnitRule::row_per_second:
      return over(row, find_unit("s"));
    case UnitRule::ratio:
      return over(row, column);
    case UnitRule::energy:
      return over(over(find_unit("J"), row), column);
    case UnitRule::power:
      return over(over(find_unit("W"), row), column);
  }
  return std::nullopt;
}

std::string unit_text_of_entry(const Model& model, const EntryPlace& place) {
  const MaybeUnit unit = unit_of_entry(model, place);
  if (!unit) return "";
  const FieldRow& field = field_row(place.kind, place.field);
  if (field.rows == Extent::inputs) return model.inputs[place.row].unit_text;
  const bool is_force = field.unit == UnitRule::power;
  return is_force ? force_unit_text(*unit) : to_string(*unit);
}

std::string velocity_unit(const Model& model, const Velocity& velocity) {
  if (velocity.rotation || is_angle(model.coordinates[velocity.coordinate])) return "rad/s";
  return velocity.unit ? to_string(*velocity.unit) : "";
}

bool has_units(const Model& model) {
  return std::ranges::any_of(model.velocities,
                             [](const Velocity& velocity) { return velocity.unit.has_value(); });
}

}  // namespace elgen
