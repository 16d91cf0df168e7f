// Units of the entries of outputs: one switch over the rules of the output table.
#include "output_units.hpp"

namespace elgen::checking {
namespace {

using MaybeUnit = std::optional<Unit>;

MaybeUnit over(const MaybeUnit& a, const MaybeUnit& b) {
  return a && b ? MaybeUnit(*a / *b) : std::nullopt;
}

/// p_i v_i is an energy.
MaybeUnit momentum_unit(const MaybeUnit& velocity) { return over(find_unit("J"), velocity); }

MaybeUnit force_unit(const MaybeUnit& velocity) {
  return over(momentum_unit(velocity), find_unit("s"));
}

}  // namespace

MaybeUnit unit_of_entry(const Model& model, const EntryPlace& place) {
  if (place.field == "relative_pivots") return Unit{};
  const MaybeUnit second = find_unit("s");
  const auto velocity = [&model](std::size_t i) { return model.velocities[i].unit; };
  const auto mass = [&] {
    return over(momentum_unit(velocity(place.row)), velocity(place.column));
  };
  switch (output_row(place.kind).unit) {
    case UnitRule::none:
    case UnitRule::user:
      return std::nullopt;
    case UnitRule::energy:
      return find_unit("J");
    case UnitRule::coordinate:
      return model.coordinates[place.row].unit;
    case UnitRule::coordinate_rate:
      return over(model.coordinates[place.row].unit, second);
    case UnitRule::acceleration:
      return over(velocity(place.row), second);
    case UnitRule::momentum:
      return momentum_unit(velocity(place.row));
    case UnitRule::force:
      return force_unit(velocity(place.row));
    case UnitRule::held_force:
      return force_unit(model.unlocked->velocities[held_velocities(model)[place.row]].unit);
    case UnitRule::input:
      return over(force_unit(velocity(place.row)), model.inputs[place.column].unit);
    case UnitRule::mass:
      return mass();
    case UnitRule::coriolis:
      return over(mass(), second);
  }
  return std::nullopt;
}

std::string velocity_unit(const Model& model, const Velocity& velocity) {
  if (!velocity.unit) return "";
  const bool is_angle =
      velocity.rotation || model.coordinates[velocity.coordinate].unit_text == "rad";
  return is_angle ? "rad/s" : to_string(*velocity.unit);
}

}  // namespace elgen::checking
