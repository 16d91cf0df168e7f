// entry_units: one switch over the rules of the output table.
#include "entry_units.hpp"

#include <set>

namespace elgen {
namespace {

constexpr std::size_t longest_list = 60;

std::optional<Unit> over(const std::optional<Unit>& a, const std::optional<Unit>& b) {
  if (!a || !b) return std::nullopt;
  return *a / *b;
}

}  // namespace

std::optional<Unit> unit_of_entry(const Model& model, const EntryPlace& place) {
  const std::optional<Unit> joule = find_unit("J");
  const std::optional<Unit> second = find_unit("s");
  const auto velocity = [&model](std::size_t i) { return model.velocities[i].unit; };
  const std::string_view rule = output_row(place.kind).unit;
  if (rule == "held force") {
    const std::uint32_t held = held_velocities(model)[place.row];
    return over(over(joule, model.unlocked->velocities[held].unit), second);
  }
  if (rule == "energy") return joule;
  if (rule == "user" || rule.empty()) return std::nullopt;
  if (place.field == "relative_pivots") return Unit{};
  if (rule == "coordinate") return model.coordinates[place.row].unit;
  if (rule == "coordinate rate") return over(model.coordinates[place.row].unit, second);
  if (rule == "acceleration") return over(velocity(place.row), second);
  const std::optional<Unit> momentum = over(joule, velocity(place.row));
  if (rule == "momentum") return momentum;
  const std::optional<Unit> force = over(momentum, second);
  if (rule == "input") return over(force, model.inputs[place.column].unit);
  if (rule == "force") return force;
  const std::optional<Unit> mass = over(momentum, velocity(place.column));
  return rule == "mass" ? mass : over(mass, second);
}

std::string units_text(const Model& model, OutputKind kind, const Field& field) {
  std::string list;
  std::set<std::string> different;
  for (std::size_t i = 0; i < field.rows; ++i) {
    for (std::size_t j = 0; j < field.columns; ++j) {
      const std::optional<Unit> unit = unit_of_entry(model, {kind, field.name, i, j});
      if (!unit) return "";
      const std::string text = to_string(*unit);
      different.insert(text);
      if (i + j > 0) list += j == 0 && field.columns > 1 ? "; " : ", ";
      list += text;
    }
  }
  if (different.size() == 1) return *different.begin();
  return list.size() <= longest_list ? list : "";
}

std::string velocity_unit(const Model& model, const Velocity& velocity) {
  if (!velocity.unit) return "";
  const bool is_angle =
      velocity.rotation || model.coordinates[velocity.coordinate].unit_text == "rad";
  return is_angle ? "rad/s" : to_string(*velocity.unit);
}

}  // namespace elgen
