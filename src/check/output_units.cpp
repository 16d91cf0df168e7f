// Units of the entries of outputs, from the units of velocities and inputs.
#include "output_units.hpp"

#include <array>

namespace elgen::checking {
namespace {

/// What a rule of the output table divides J s^seconds by. (A generalized force is a power per
/// velocity, W = J s^-1.)
struct UnitRule {
  std::string_view name;
  int seconds;
  bool by_row_velocity;
  bool by_column_velocity;
  bool by_column_input;
};

constexpr std::array<UnitRule, 6> rules{{
    {"mass", 0, true, true, false},
    {"coriolis", -1, true, true, false},
    {"momentum", 0, true, false, false},
    {"force", -1, true, false, false},
    {"input", -1, true, false, true},
    {"energy", 0, false, false, false},
}};

/// Divides by a unit that may be missing.
void divide(std::optional<Unit>& unit, const std::optional<Unit>& divisor) {
  unit = unit && divisor ? std::optional(*unit / *divisor) : std::nullopt;
}

std::optional<Unit> apply(const UnitRule& rule, const Model& model, std::uint32_t row,
                          std::uint32_t column) {
  std::optional<Unit> unit = *find_unit("J") * power(*find_unit("s"), {rule.seconds, 1});
  if (rule.by_row_velocity) {
    divide(unit, model.velocities[row].unit);
  }
  if (rule.by_column_velocity) {
    divide(unit, model.velocities[column].unit);
  }
  if (rule.by_column_input) {
    divide(unit, model.inputs[column].unit);
  }
  return unit;
}

}  // namespace

std::optional<Unit> unit_of_entry(const Model& model, const OutputRequest& output,
                                  std::uint32_t row, std::uint32_t column) {
  const std::string_view name = output_row(output.kind).unit;
  if (name == "acceleration") {
    std::optional<Unit> unit = model.velocities[row].unit;
    divide(unit, find_unit("s"));
    return unit;
  }
  if (name == "coordinate") {
    return model.coordinates[row].unit;
  }
  if (name == "coordinate rate") {
    std::optional<Unit> unit = model.coordinates[row].unit;
    divide(unit, find_unit("s"));
    return unit;
  }
  for (const UnitRule& rule : rules) {
    if (rule.name == name) {
      return apply(rule, model, row, column);
    }
  }
  return std::nullopt;
}

}  // namespace elgen::checking
