// entry_units: the rule of an output and the units of velocities -> the unit of each entry.
#pragma once

#include <optional>
#include <string>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/units.hpp"

namespace elgen {

/// An entry of a field, row-major.
struct EntryPlace {
  OutputKind kind = OutputKind::mass_matrix;
  std::string_view field = {};  ///< "relative_pivots"; "" in plain outputs
  std::size_t row = 0;
  std::size_t column = 0;
};

/// With u_i the unit of coordinate i: M_ij in J s^2/(u_i u_j), C_ij in J s/(u_i u_j), forces in
/// J/u_i, momenta in J s/u_i, B_ij in J/u_i per unit of input j, accelerations in u_i/s^2. None
/// where a unit is unknown, and for outputs of the model's own.
[[nodiscard]] std::optional<Unit> unit_of_entry(const Model& model, const EntryPlace& place);

/// "kg, kg*m; kg*m, kg*m^2", or one unit where all are equal; empty where one is unknown or the
/// list is too long to help.
[[nodiscard]] std::string units_text(const Model& model, OutputKind kind, const Field& field);

/// The unit of a velocity as text: angles per second stay "rad/s". Empty where it has none.
[[nodiscard]] std::string velocity_unit(const Model& model, const Velocity& velocity);

}  // namespace elgen
