// The table of outputs (outputs.def): arguments, shape, units, type, availability and equation.
//
// All differences between outputs are columns of this table, which every stage uses. Only the
// derivation of an output and its definition in the oracle are elsewhere, as functions that have
// its name.
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

/// The form of the equations in which a function is emitted.
enum class Form : std::uint8_t {
  recursive,  ///< expressions over the intermediate values of the derivation
  closed,     ///< one cancelled, collected expression per entry
};

[[nodiscard]] std::string_view name_of(Form form);

enum class Extent : std::uint8_t {
  one,
  coordinates,
  velocities,
  states,
  inputs,
  reaction,
  cyclic,        ///< coordinates that [routh] eliminates
  constraints,   ///< all constraints; a row has the unit of the rate r
  positions,     ///< the constraints on positions; a row has the unit of f
  inertial,      ///< entries of pi (inertial_parameters.hpp)
  pivots,        ///< one pivot per velocity, then one per constraint
  user,          ///< the rows of an [[output]]
  user_columns,  ///< the columns of an [[output]]: four for a pose, else one
  task,          ///< the rates of the values of an [[output]]; for a frame its twist
  accelerations  ///< one per velocity if an [[output]] contains accelerations, else none
};

/// The unit of an entry, from the units of its row and column, which are coordinates, velocities or
/// inputs. A force times a velocity is a power; a momentum times a velocity is an energy.
enum class UnitRule : std::uint8_t {
  none,
  number,
  row,
  row_per_second,
  ratio,   ///< row unit / column unit
  energy,  ///< J / (row unit * column unit)
  power,   ///< W / (row unit * column unit)
};

/// A property of the model, the scene or an [[output]] that some outputs require.
/// src/model/unmet_needs.cpp checks the needs in this order and reports the first that is not met.
enum class Need : std::uint8_t {
  quadratic,              ///< a Lagrangian that is at most quadratic in v
  energies,               ///< separate T and V
  rotations,              ///< a rotation
  reaction,               ///< a lock with `reaction = true`
  cyclic,                 ///< a coordinate in [routh]
  affine_forces,          ///< forces that are affine in the parameters of a regressor
  inertial,               ///< at least one inertial parameter for a regressor
  constraints,            ///< a constraint
  independent,            ///< as many independent velocities in the scene as degrees of freedom
  no_constraints,         ///< no constraint
  inputs,                 ///< an input
  motors,                 ///< only inputs that are motors
  few_inputs,             ///< at most as many inputs as degrees of freedom
  no_cyclic_coordinates,  ///< an [[output]] without coordinates that [routh] eliminates
  smooth_forces,          ///< forces without kinks
  few_velocities,         ///< few enough velocities for derivatives of a step
  closed_functions,       ///< no open function without an expression in the scene
  jacobian,               ///< `jacobian = true` of the [[output]]
  position_values,        ///< an [[output]] over positions only
  motion_values,          ///< an [[output]] with rates, accelerations or inputs
  smooth_values,          ///< an [[output]] without kinks
};

/// The fault to report if an output solves with a matrix other than M, and this matrix is singular
/// at every state. G and A_d: src/derive/outputs/outputs.hpp; messages:
/// src/inspect/singular_mass.hpp. Outputs that solve only with M ignore OutputRow::singular_fault.
enum class SingularFault : std::uint8_t {
  redundant_constraint,  ///< A M^-1 A^T: a constraint follows from the others
  redundant_inputs,      ///< B^T G B: the force of an input depends linearly on other inputs
  undetermined_rest,     ///< A_d: the independent velocities do not determine the other velocities
  dependent_task,        ///< J M^-1 J^T: a row of J follows from the others
};

/// A key of `NAME = { … }` in `[outputs]` that only some outputs accept. All outputs accept `form`
/// and `rename`.
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
  std::string_view pronoun;  ///< pronoun in an error message: "one" in "`step` has one"
};

inline constexpr std::array option_table{OptionRow{OutputOption::method, "method", "one"},
                                         OptionRow{OutputOption::order, "order", "one"},
                                         OptionRow{OutputOption::iterations, "iterations", "one"},
                                         OptionRow{OutputOption::projected, "projected", "one"},
                                         OptionRow{OutputOption::pivots, "pivots", "them"},
                                         OptionRow{OutputOption::independent, "independent", "it"}};

template <typename Enum>
class EnumSet {
 public:
  constexpr EnumSet() = default;
  constexpr EnumSet(std::initializer_list<Enum> members) {
    for (const Enum member : members) add(member);
  }

  constexpr void add(Enum member) { bits_ |= 1U << static_cast<unsigned>(member); }
  [[nodiscard]] constexpr bool has(Enum member) const {
    return (bits_ >> static_cast<unsigned>(member) & 1U) != 0;
  }
  /// The members in the order of the enumeration.
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

/// A symbol or equation as text and in LaTeX. In LaTeX, `<q>` is a vector. `<v>` and `<a>` are the
/// velocities and accelerations; models without rotations show them as dq/dt and d^2q/dt^2. `<N>`
/// is N of dq/dt = N v; it is omitted if N = 1.
struct Notation {
  std::string_view text = {};   ///< "M"; "g = dV0/dq"
  std::string_view latex = {};  ///< may be empty
};

/// One field of an output. If the output has only one field, the field has no name.
struct FieldRow {
  std::string_view name = {};
  Extent rows = Extent::one;
  Extent columns = Extent::one;
  UnitRule unit = UnitRule::none;
  /// The C++ type of the field: `{0}` is the number of rows, `{1}` the number of entries, `{2}` the
  /// number of pivots. The type of a single number is Scalar.
  std::string_view type = "Scalar";
  std::string_view latex = {};  ///< symbol of the field, if it has a name
  /// True for the residual of an iteration, whose terms cancel down to rounding error. Only
  /// implicit methods have this field.
  bool is_residual = false;
};

/// True if the field is a matrix even with one column, for example the mass matrix of one
/// coordinate. False for user_columns: an [[output]] with one column is a list.
[[nodiscard]] constexpr bool is_matrix_field(const FieldRow& field) {
  return field.columns != Extent::one && field.columns != Extent::user_columns;
}

/// True if a single entry of the field is a plain number. False if a single entry is a list of
/// length 1, because its row belongs to a coordinate, an input or another named entry.
[[nodiscard]] constexpr bool may_be_scalar(const FieldRow& field) {
  const bool is_of_user = field.rows == Extent::user || field.rows == Extent::task;
  return (is_of_user || field.rows == Extent::one) && !is_matrix_field(field);
}

struct OutputRow {
  OutputKind kind = {};
  std::string_view name = {};  ///< in scenes, options and emitted code; "" for user outputs
  Notation symbol = {};
  LeafSet argument_kinds = {};  ///< arguments in addition to parameters, q and (if it occurs) t
  bool takes_parameters_alone = false;
  bool depends_like_mass = false;  ///< also takes v if M depends on v (L is not quadratic in v)
  bool takes_unprojected = false;  ///< may be called at states that violate the constraints
  std::span<const FieldRow> fields = {};
  Notation equation = {};
  Notation rotation_equation = {};     ///< for models with rotations; empty: `equation` holds
  Notation constrained_equation = {};  ///< for models with constraints; empty: `equation` holds
  std::string_view definition = {};    ///< the output as a formula of other outputs, in LaTeX
  std::string_view driftless_definition = {};  ///< `definition` for models with drift = 0
  std::string_view doc = {};              ///< what the function returns, for comments and pages
  std::string_view constrained_doc = {};  ///< for models with constraints; empty: `doc` holds
  std::string_view doc_without_pivots = {};
  std::string_view constrained_doc_without_pivots = {};
  EnumSet<Need> needs = {};
  EnumSet<OutputOption> options = {};  ///< options that the output accepts in `[outputs]`
  SingularFault singular_fault = SingularFault::redundant_constraint;
  bool is_energy = false;           ///< an energy of (q, v), in which V occurs without derivatives
  bool solves_mass_matrix = false;  ///< solves M x = b
  bool differentiates = false;      ///< contains derivatives of the equations of motion
  bool gives_pivots = false;        ///< also returns the relative pivots of M = L D L^T
  bool is_constrained = false;      ///< if the model has constraints, solves with A M^-1 A^T
  bool is_on_request = false;       ///< `full` omits the output; a scene must name the output
  bool is_user_output = false;      ///< every [[output]] of a model gets a function of this kind
  std::string_view suffix = {};     ///< appended to the name of the [[output]]
  bool is_summary = false;  ///< a struct of the requested outputs that is_in_dynamics() accepts
  bool is_step = false;     ///< composed by the integration method of the scene, not derived
};

/// True if the output has equations of its own, that is, it is not composed from other outputs.
[[nodiscard]] constexpr bool has_equations(const OutputRow& output) {
  return !output.is_summary && !output.is_step;
}

/// True for the value of an [[output]], false for its Jacobian, bias or derivatives.
[[nodiscard]] constexpr bool is_user_value(const OutputRow& output) {
  return output.is_user_output && output.suffix.empty();
}

/// True if `full` omits the output and a scene must name it: a step needs a method, and functions
/// of momenta are an alternative to functions of velocities.
[[nodiscard]] constexpr bool is_omitted_by_full(const OutputRow& output) {
  return output.is_step || output.is_on_request || output.argument_kinds.has_any(Opcode::momentum);
}

/// True if the output divides by the pivots of M = L D L^T.
[[nodiscard]] constexpr bool divides_by_mass(const OutputRow& output) {
  return output.solves_mass_matrix || output.is_step ||
         output.argument_kinds.has_any(Opcode::momentum);
}

/// The properties of a model that select one of the equations of an output.
struct EquationSetting {
  bool has_rotations = false;
  bool has_constraints = false;
};
[[nodiscard]] const Notation& equation_of(const OutputRow& output, const EquationSetting& setting);

[[nodiscard]] std::span<const OutputRow> output_table();
[[nodiscard]] const OutputRow& output_row(OutputKind kind);

/// True if `dynamics` contains the output `kind`, that is, the output has one field and its
/// arguments are q and perhaps parameters, v and t. `takes`: OutputRequest::argument_kinds.
[[nodiscard]] bool is_in_dynamics(OutputKind kind, LeafSet takes);

/// The field of this name; if there is none, the first field; for an output without fields, the row
/// of a single number.
[[nodiscard]] const FieldRow& field_row(OutputKind kind, std::string_view name);

/// The row of the built-in output with this name; null if no built-in output has the name.
[[nodiscard]] const OutputRow* find_output(std::string_view name);

}  // namespace elgen
