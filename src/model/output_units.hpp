// Units of the entries of outputs, from the units of velocities, coordinates and inputs.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "elgen/model.hpp"
#include "elgen/outputs.hpp"

namespace elgen {

/// An entry of a field of an output, counted from 0.
struct EntryPlace {
  OutputKind kind = {};
  std::string_view field = {};  ///< "relative_pivots"; "" in plain outputs
  std::size_t row = 0;
  std::size_t column = 0;
};

/// With u_i the unit of velocity i times s: M_ij in J s^2/(u_i u_j), C_ij in J s/(u_i u_j), forces
/// in J/u_i, momenta in J s/u_i, B_ij in J/u_i per unit of input j, accelerations in u_i/s^2. None
/// where a unit is not declared or not known, and for outputs of the model's own.
[[nodiscard]] std::optional<Unit> unit_of_entry(const Model& model, const EntryPlace& place);

/// As text, N*m of torques. Empty where there is none.
[[nodiscard]] std::string unit_text_of_entry(const Model& model, const EntryPlace& place);

/// The unit of a velocity as text: angles per second stay "rad/s". Empty where it has none.
[[nodiscard]] std::string velocity_unit(const Model& model, const Velocity& velocity);

}  // namespace elgen
