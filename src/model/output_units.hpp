// Units of the entries of outputs, from the units of velocities, coordinates and inputs.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "elgen/model.hpp"
#include "elgen/outputs.hpp"

namespace elgen {

/// An entry of a field of an output; row and column are counted from 0.
struct EntryPlace {
  OutputKind kind = {};
  std::string_view field = {};  ///< "relative_pivots"; "" for outputs of one field
  std::size_t row = 0;
  std::size_t column = 0;
};

/// With u_i = unit of velocity i times s: M_ij in J s^2/(u_i u_j), C_ij in J s/(u_i u_j), forces in
/// J/u_i, momenta in J s/u_i, B_ij in J/u_i per unit of input j, accelerations in u_i/s^2. None if
/// a unit is undeclared or unknown, and for user outputs.
[[nodiscard]] std::optional<Unit> unit_of_entry(const Model& model, const EntryPlace& place);

/// The unit as text, with N*m for torques; "" if it is none.
[[nodiscard]] std::string unit_text_of_entry(const Model& model, const EntryPlace& place);

/// The unit of a velocity as text, "rad/s" for an angle; "" if it is none.
[[nodiscard]] std::string velocity_unit(const Model& model, const Velocity& velocity);

/// True if some velocity has a unit. Energies are then in J and lengths in m.
[[nodiscard]] bool has_units(const Model& model);

}  // namespace elgen
