// Units of the entries of outputs, from the units of velocities, coordinates and inputs.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "elgen/model.hpp"
#include "elgen/outputs.hpp"

namespace elgen {

/// An entry of a field of an output; row and column are counted from 0.
struct FieldEntry {
  OutputKind kind = {};
  std::string_view field = {};  ///< "relative_pivots"; "" for outputs of one field
  std::size_t row = 0;
  std::size_t column = 0;
};

/// The unit of an entry of an output. With u_i = unit of velocity i times s:
///
///     M_ij   J s^2/(u_i u_j)     forces   J/u_i       B_ij            J/u_i per unit of input j
///     C_ij   J s/(u_i u_j)       momenta  J s/u_i     accelerations   u_i/s^2
///
/// None for user outputs, and if a unit is undeclared or unknown.
[[nodiscard]] std::optional<Unit> unit_of_entry(const Model& model, const FieldEntry& place);

/// unit_of_entry() as text, with N*m for torques; "" if the unit is unknown.
[[nodiscard]] std::string unit_text_of_entry(const Model& model, const FieldEntry& place);

/// The unit of a velocity as text, "rad/s" for an angle; "" if the unit is unknown.
[[nodiscard]] std::string velocity_unit_text(const Model& model, const Velocity& velocity);

/// True if a velocity has a unit. Energies are then shown in J and lengths in m.
[[nodiscard]] bool has_units(const Model& model);

}  // namespace elgen
