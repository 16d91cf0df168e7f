// The table of outputs: what elgen can derive, with arguments, shape, availability and equation.
//
// Everything that needs a list of outputs (scene reader, derivation, oracle, emission,
// verification, documentation) reads this table; there is no second one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

enum class OutputKind : std::uint8_t {
  mass_matrix,
  coriolis_matrix,
  velocity_force,
  gravity,
  potential_energy,
  drift,
  dissipation,
  applied_force,
  bias,
  momentum,
  kinetic_energy,
  total_energy,
  energy_function,
  input_matrix,
  inverse_dynamics,
  reaction,
  forward_dynamics,
  linearization,
  inverse_dynamics_derivatives,
  forward_dynamics_derivatives,
  coordinate_rates,
  normalized,
  user_value,     ///< an [[output]] of the model
  user_jacobian,  ///< its Jacobian
  user_bias,      ///< its second rate without the terms in a
  dynamics,       ///< struct of every chosen output that takes neither a nor u
};

/// Which form of the equations a function is emitted in.
enum class Form : std::uint8_t {
  recursive,  ///< over the definitions of the derivation
  closed,     ///< the cancelled, collected equation
};

[[nodiscard]] std::string_view name_of(Form form);

enum class Extent : std::uint8_t { one, coordinates, velocities, states, inputs, held, user };

/// What the units of an output's entries follow from; see unit_of_entry().
enum class UnitRule : std::uint8_t {
  none,
  user,
  mass,
  coriolis,
  momentum,
  force,
  held_force,
  input,
  energy,
  acceleration,
  coordinate,
  coordinate_rate,
};

/// What a model must have for an output to exist.
enum class Requirement : std::uint8_t { nothing, quadratic, energies, inputs, rotations, held };

/// One field of an output; plain outputs have one field without a name.
struct FieldRow {
  std::string_view name;
  Extent rows;
  Extent columns;
};

/// A symbol or an equation as text and in LaTeX, where `<v>` and `<a>` stand for the velocities and
/// accelerations (dq/dt and d^2q/dt^2 except where rotations turn) and `<N>` for the factor N of
/// dq/dt = N v, if it is not 1.
struct Notation {
  std::string_view text = {};   ///< "M"; "g = dV0/dq"
  std::string_view latex = {};  ///< may be empty
};

struct OutputRow {
  OutputKind kind;
  std::string_view name;  ///< as in scenes, options and emitted code
  Notation symbol;
  bool takes_velocity;  ///< arguments beside parameters and q (and t where t occurs)
  bool takes_acceleration;
  bool takes_input;
  std::vector<FieldRow> fields;
  Notation equation;
  std::string_view doc;  ///< one sentence
  UnitRule unit;
  Notation turning_equation = {};  ///< with rotations, where it is another
  Requirement requirement = Requirement::nothing;
  bool solves = false;          ///< M x = b
  bool differentiates = false;  ///< the equations of motion
};

/// The equation that holds in a model with or without rotations.
[[nodiscard]] const Notation& equation_of(const OutputRow& output, bool has_rotations);

[[nodiscard]] const std::vector<OutputRow>& output_table();
[[nodiscard]] const OutputRow& output_row(OutputKind kind);

/// Null where the name is no built-in output.
[[nodiscard]] const OutputRow* find_output(std::string_view name);

}  // namespace elgen
