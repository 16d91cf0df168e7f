// Units of the entries of outputs, by the rules of the output table.
#include "check/judge/output_units.hpp"

namespace elgen {
namespace {

using MaybeUnit = std::optional<Unit>;

MaybeUnit over(const MaybeUnit& a, const MaybeUnit& b) {
  return a && b ? MaybeUnit(*a / *b) : std::nullopt;
}

/// Of what the i-th row or column stands for.
MaybeUnit unit_along(const Model& model, Extent extent, std::size_t i) {
  switch (extent) {
    case Extent::one:
      return Unit{};
    case Extent::coordinates:
      return model.coordinates[i].unit;
    case Extent::velocities:
      return model.velocities[i].unit;
    case Extent::inputs:
      return model.inputs[i].unit;
    case Extent::held:
      return model.unlocked->velocities[held_velocities(model)[i]].unit;
    case Extent::states:
    case Extent::user:
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
    case UnitRule::energy:
      return over(over(find_unit("J"), row), column);
    case UnitRule::power:
      return over(over(find_unit("W"), row), column);
  }
  return std::nullopt;
}

std::string velocity_unit(const Model& model, const Velocity& velocity) {
  if (!velocity.unit) return "";
  const bool is_angle =
      velocity.rotation || model.coordinates[velocity.coordinate].unit_text == "rad";
  return is_angle ? "rad/s" : to_string(*velocity.unit);
}

}  // namespace elgen
