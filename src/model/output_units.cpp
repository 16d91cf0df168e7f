// Units of the entries of outputs, by the unit rules of the output table.
#include "model/output_units.hpp"

#include <algorithm>

#include "model/requests.hpp"

namespace elgen {
namespace {

using MaybeUnit = std::optional<Unit>;

MaybeUnit divide_units(const MaybeUnit& a, const MaybeUnit& b) {
  return a && b ? MaybeUnit(*a / *b) : std::nullopt;
}

MaybeUnit line_unit(const Model& model, Extent extent, std::size_t i) {
  const std::optional<FieldLine> line = line_at(model, extent, i);
  return line ? line->unit : std::nullopt;
}

}  // namespace

MaybeUnit unit_of_entry(const Model& model, const FieldEntry& place) {
  const FieldRow& field = field_row(place.kind, place.field);
  const auto row = [&] { return line_unit(model, field.rows, place.row); };
  const auto column = [&] { return line_unit(model, field.columns, place.column); };
  switch (field.unit) {
    case UnitRule::none:
      break;
    case UnitRule::number:
      return Unit{};
    case UnitRule::row:
      return row();
    case UnitRule::row_per_second:
      return divide_units(row(), find_unit("s"));
    case UnitRule::ratio:
      return divide_units(row(), column());
    case UnitRule::energy:
      return divide_units(divide_units(find_unit("J"), row()), column());
    case UnitRule::power:
      return divide_units(divide_units(find_unit("W"), row()), column());
  }
  return std::nullopt;
}

std::string unit_text_of_entry(const Model& model, const FieldEntry& place) {
  const MaybeUnit unit = unit_of_entry(model, place);
  if (!unit) return "";
  const FieldRow& field = field_row(place.kind, place.field);
  if (field.unit == UnitRule::row) {
    const std::optional<FieldLine> row = line_at(model, field.rows, place.row);
    if (row && row->leaf == Opcode::input) return model.inputs[row->number].unit_text;
  }
  const bool is_force = field.unit == UnitRule::power;
  return is_force ? force_unit_text(*unit) : to_string(*unit);
}

std::string velocity_unit_text(const Model& model, const Velocity& velocity) {
  if (velocity.rotation || is_angle(model.coordinates[velocity.coordinate])) return "rad/s";
  return velocity.unit ? to_string(*velocity.unit) : "";
}

bool has_units(const Model& model) {
  return std::ranges::any_of(model.velocities,
                             [](const Velocity& velocity) { return velocity.unit.has_value(); });
}

}  // namespace elgen
