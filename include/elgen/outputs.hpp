// The table of outputs (outputs.def): arguments, shape, units, type, availability and equation.
//
// The columns hold all differences between outputs, and every stage reads them. Only the derivation
// and the oracle's definition of an output stand elsewhere, under its name.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "elgen/opcodes.hpp"

namespace elgen {

enum class OutputKind : std::uint8_t {
#define ELGEN_OUTPUT(name) name,
#include "elgen/outputs.def"
};

/// Which form of the equations a function is emitted in.
enum class Form : std::uint8_t {
  recursive,  ///< over the definitions of the derivation
  closed,     ///< the cancelled, collected equation
};

[[nodiscard]] std::string_view name_of(Form form);

enum class Extent : std::uint8_t {
  one,
  coordinates,
  velocities,
  states,
  inputs,
  held,
  cyclic,        ///< the coordinates that [routh] takes out
  constraints,   ///< a row stands for the rate of its equation
  positions,     ///< the constraints on positions; a row stands for its equation
  inertial,      ///< the parameters of the regressor (inertial_parameters.hpp)
  pivots,        ///< of the velocities, then of the constraints
  user,          ///< the rows of an [[output]]
  user_columns,  ///< those of a pose are four, else there is one
  task,          ///< the rates of an [[output]]: of a frame those of its twist
  accelerations  ///< velocities, where an [[output]] takes their rates; else none
};

/// The unit of an entry from those of its row and column, which stand for coordinates, velocities
/// or inputs: forces times velocities are a power, momenta times velocities an energy.
enum class UnitRule : std::uint8_t {
  none,
  number,
  row,
  row_per_second,
  ratio,   ///< that of the row over that of the column
  energy,  ///< J over the units of row and column
  power,   ///< W over them
};

/// A property of the model, of the scene or of an [[output]] that some outputs need. The order is
/// that in which src/model/lacks.cpp looks for a need that is not met.
enum class Need : std::uint8_t {
  quadratic,         ///< a Lagrangian that is at most quadratic in v
  energies,          ///< T and V, each by itself
  rotations,         ///< a rotation
  held,              ///< a lock with a reaction
  cyclic,            ///< a coordinate in [routh]
  affine_forces,     ///< forces that are affine in the parameters of a regressor
  inertial,          ///< parameters of a regressor
  constraints,       ///< a constraint
  independent,       ///< independent velocities that the scene names
  no_constraints,    ///< no constraint
  inputs,            ///< an input
  motors,            ///< inputs that are motors, all of them
  few_inputs,        ///< at most as many inputs as freedoms
  kept_coordinates,  ///< an [[output]] of coordinates that [routh] leaves
  smooth_forces,     ///< forces without kinks
  few_velocities,    ///< few enough for straight-line derivatives of a step
  closed_functions,  ///< an expression of each open function
  jacobian,          ///< `jacobian = true` of the [[output]]
  of_positions,      ///< an [[output]] of positions alone
  of_motion,         ///< an [[output]] of rates, accelerations or inputs
  smooth_values,     ///< an [[output]] without kinks
};

/// The fault if the matrix besides M by which an output is solved is singular in every state. Rows
/// that are solved by M alone keep the default, which nobody asks for. Sentences:
/// src/inspect/singular_mass.hpp.
enum class WhenSingular : std::uint8_t {
  redundant_constraint,  ///< A M^-1 A^T: a constraint follows from others
  redundant_inputs,      ///< B^T G B: an input moves only what others move
  undetermined_rest,     ///< A_d: the independent velocities do not determine the others
  dependent_task,        ///< J M^-1 J^T: a row of J follows from others
};

/// A key of `NAME = { … }` in `[outputs]` that some outputs take; all take `form` and `rename`.
enum class OutputOption : std::uint8_t {
  method,
  order,
  iterations,
  projected,
  pivots,
  independent
};

struct OptionRow {
  OutputOption id;
  std::string_view key;
  std::string_view pronoun;  ///< "`step` has one", in the message to outputs that do not take it
};

inline constexpr std::array option_table{OptionRow{OutputOption::method, "method", "one"},
                                         OptionRow{OutputOption::order, "order", "one"},
                                         OptionRow{OutputOption::iterations, "iterations", "one"},
                                         OptionRow{OutputOption::projected, "projected", "one"},
                                         OptionRow{OutputOption::pivots, "pivots", "them"},
                                         OptionRow{OutputOption::independent, "independent", "it"}};

/// A set of enumerators.
template <typename Enum>
class SetOf {
 public:
  constexpr SetOf() = default;
  constexpr SetOf(std::initializer_list<Enum> members) {
    for (const Enum member : members) add(member);
  }

  constexpr void add(Enum member) { bits_ |= 1U << static_cast<unsigned>(member); }
  [[nodiscard]] constexpr bool has(Enum member) const {
    return (bits_ >> static_cast<unsigned>(member) & 1U) != 0;
  }
  /// In the order of the enumeration.
  [[nodiscard]] std::vector<Enum> members() const {
    std::vector<Enum> all;
    for (unsigned bit = 0; bits_ >> bit != 0; ++bit) {
      if (has(static_cast<Enum>(bit))) all.push_back(static_cast<Enum>(bit));
    }
    return all;
  }

 private:
  std::uint32_t bits_ = 0;
};

/// A symbol or an equation as text and in LaTeX, where `<q>` is a vector. `<v>` and `<a>` stand for
/// the velocities and accelerations (dq/dt and d^2q/dt^2 except where rotations turn) and `<N>` for
/// the factor N of dq/dt = N v, if it is not 1.
struct Notation {
  std::string_view text = {};   ///< "M"; "g = dV0/dq"
  std::string_view latex = {};  ///< may be empty
};

/// One field of an output; plain outputs have one field without a name.
struct FieldRow {
  std::string_view name = {};
  Extent rows = Extent::one;
  Extent columns = Extent::one;
  UnitRule unit = UnitRule::none;
  /// The type that holds it in C++: `{0}` are its rows, `{1}` its entries. A number is a Scalar.
  std::string_view type = "Scalar";
  std::string_view latex = {};  ///< its symbol, where it has a name
  /// The residual of an iteration: its terms cancel, and it is known to their rounding. Of methods
  /// that iterate alone.
  bool is_remainder = false;
};

/// Whether the field has columns whatever their number: the mass matrix of one coordinate is a
/// matrix. A pose has columns as well, but its extent is that of all values.
[[nodiscard]] constexpr bool has_columns(const FieldRow& field) {
  return field.columns != Extent::one && field.columns != Extent::user_columns;
}

/// Whether an entry that is alone is a number, not a list: its row has no name.
[[nodiscard]] constexpr bool may_be_number(const FieldRow& field) {
  const bool is_of_user = field.rows == Extent::user || field.rows == Extent::task;
  return (is_of_user || field.rows == Extent::one) && !has_columns(field);
}

struct OutputRow {
  OutputKind kind = {};
  std::string_view name = {};  ///< as in scenes, options and emitted code, where it is built in
  Notation symbol = {};
  LeafSet takes = {};  ///< arguments beside parameters and q (and t where t occurs)
  bool takes_parameters_alone = false;
  bool is_of_mass = false;     ///< takes v as well, if L is not quadratic in v
  bool takes_drifted = false;  ///< states that do not meet the constraints
  std::span<const FieldRow> fields = {};
  Notation equation = {};
  Notation turning_equation = {};               ///< with rotations, where it is another
  Notation constrained_equation = {};           ///< with constraints, where it is another
  std::string_view definition = {};             ///< by other outputs, in LaTeX: on pages
  std::string_view undrifting_definition = {};  ///< the same, if `drift` is 0
  std::string_view doc = {};                    ///< one sentence
  std::string_view constrained_doc = {};        ///< with constraints, where it is another
  std::string_view doc_without_pivots = {};
  std::string_view constrained_doc_without_pivots = {};
  SetOf<Need> needs = {};
  SetOf<OutputOption> options = {};  ///< that its entry in `[outputs]` may have
  WhenSingular when_singular = WhenSingular::redundant_constraint;
  bool is_energy = false;        ///< of (q, v), so that V enters it without derivatives
  bool solves = false;           ///< M x = b
  bool differentiates = false;   ///< the equations of motion
  bool gives_pivots = false;     ///< of M = L D L^T, beside what it solves for
  bool is_constrained = false;   ///< solves with S = A M^-1 A^T where the model has constraints
  bool by_name = false;          ///< given only where it is named
  bool of_user = false;          ///< one for every [[output]] of a model
  std::string_view suffix = {};  ///< its name is that of the [[output]] and this
  bool repeats = false;          ///< every chosen output that takes neither a nor u
  bool steps = false;            ///< by a method that the scene names, not derived
};

/// Whether it has readable equations, and is not made of other outputs.
[[nodiscard]] constexpr bool has_equations(const OutputRow& output) {
  return !output.repeats && !output.steps;
}

/// Whether it is the value of an [[output]] itself, not its Jacobian, bias or derivatives.
[[nodiscard]] constexpr bool is_value_of_user(const OutputRow& output) {
  return output.of_user && output.suffix.empty();
}

/// Whether it is given only where it is named: a scene says how to step, and functions of momenta
/// stand in the place of those of velocities.
[[nodiscard]] constexpr bool is_named_only(const OutputRow& output) {
  return output.steps || output.by_name || output.takes.has_any(Opcode::momentum);
}

/// Whether it divides by the pivots of M = L D L^T.
[[nodiscard]] constexpr bool divides_by_mass(const OutputRow& output) {
  return output.solves || output.steps || output.takes.has_any(Opcode::momentum);
}

/// The equation that holds in a model with or without rotations or constraints.
struct EquationSetting {
  bool has_rotations = false;
  bool has_constraints = false;
};
[[nodiscard]] const Notation& equation_of(const OutputRow& output, const EquationSetting& setting);

[[nodiscard]] std::span<const OutputRow> output_table();
[[nodiscard]] const OutputRow& output_row(OutputKind kind);

/// Whether an output that repeats others holds one that takes these: nothing beside p, q, v and t,
/// and has one field.
[[nodiscard]] bool is_repeated(OutputKind kind, LeafSet takes);

/// The field of this name, or the first; a single number where the output has no fields.
[[nodiscard]] const FieldRow& field_row(OutputKind kind, std::string_view name);

/// Null where the name is no built-in output.
[[nodiscard]] const OutputRow* find_output(std::string_view name);

}  // namespace elgen
