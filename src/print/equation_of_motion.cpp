// equation_of_motion: the terms of the whole model, even if a scene requests only some of them. If
// no requested function depends on motion, rates and accelerations are 0. Rates are named only if a
// function depends on them. Conserved quantities follow from entries that are 0. Constraints add
// multipliers; both sides of a constraint are printed as expressions of the model, with names
// unexpanded.
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "elgen/page.hpp"
#include "elgen/references.hpp"
#include "formula/drawing.hpp"
#include "model/output_units.hpp"
#include "model/requests.hpp"
#include "model/symbols.hpp"
#include "print/sections.hpp"
#include "program/evaluate/conservation.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

/// A term; `{}` is replaced by ",t" in models with explicit time.
using TermTemplate = std::string_view;

constexpr TermTemplate mass = "M(<q>{}) <a>";
constexpr TermTemplate mass_of_rates = "M(<q>,<v>{}) <a>";
constexpr TermTemplate bias_term = "<bias>(<q>,<v>{})";
constexpr TermTemplate coriolis = "C(<q>,<v>{}) <v>";
constexpr TermTemplate drift = "<drift>(<q>,<v>{})";
constexpr TermTemplate gravity = "<g>(<q>{})";
constexpr TermTemplate dissipation = "\\frac{{\\partial D}}{{\\partial <v>}}";
constexpr TermTemplate input = "B(<q>{}) <u>";
constexpr TermTemplate force = "<Q>(<q>,<v>{})";
constexpr TermTemplate multipliers = "A(<q>{})^{{\\top}} <lambda>";
constexpr TermTemplate zero_vector = "<0>";

constexpr TermTemplate drift_at_rest = "<drift>(<q>,<0>{})";
constexpr TermTemplate dissipation_at_rest = "\\frac{{\\partial D}}{{\\partial <v>}}(<q>,<0>{})";
constexpr TermTemplate force_at_rest = "<Q>(<q>,<0>{})";

/// False if `program` has the output `kind` and all entries of this output are 0; otherwise true.
bool may_be_nonzero(const Program& program, OutputKind kind) {
  for (const Function& function : program.functions) {
    if (function.kind == kind) return !is_zero(program, function);
  }
  return true;
}

std::vector<TermTemplate> left_side(const Model& model, const Program& program, bool is_at_rest) {
  if (!model.is_quadratic) return {mass_of_rates, bias_term};
  std::vector<TermTemplate> terms;
  const auto add = [&](bool may_exist, OutputKind kind, const TermTemplate& term) {
    if (may_exist && may_be_nonzero(program, kind)) terms.push_back(term);
  };
  if (!is_at_rest) terms.push_back(mass);
  add(!is_at_rest, OutputKind::velocity_force, coriolis);
  add(model.may_drift, OutputKind::drift, is_at_rest ? drift_at_rest : drift);
  add(true, OutputKind::gravity, gravity);
  add(!dissipation_roots(model).empty(), OutputKind::dissipation,
      is_at_rest ? dissipation_at_rest : dissipation);
  return terms;
}

std::vector<TermTemplate> right_side(const Model& model, const Program& program, bool is_at_rest) {
  std::vector<TermTemplate> terms;
  if (!model.inputs.empty()) terms.push_back(input);
  const bool has_force = !model.forces.empty() && model.is_quadratic;
  if (has_force && may_be_nonzero(program, OutputKind::applied_force)) {
    terms.push_back(is_at_rest ? force_at_rest : force);
  }
  if (!model.constraints.empty()) terms.push_back(multipliers);
  if (terms.empty()) terms.push_back(zero_vector);
  return terms;
}

std::string join_terms(const std::vector<TermTemplate>& terms, std::string_view time) {
  std::string text;
  for (const TermTemplate term : terms) {
    text += (text.empty() ? "" : " + ") + fmt::format(fmt::runtime(term), time);
  }
  return text;
}

/// True if L is not quadratic in the rates, or if a function is M or depends on rates, momenta or
/// accelerations.
bool depends_on_motion(const Model& model, const Program& program) {
  const auto knows = [&model](const Function& function) {
    const LeafSet takes = make_request(model, function.kind, function.user).argument_kinds;
    return takes.has_any(Opcode::velocity | Opcode::momentum | Opcode::acceleration);
  };
  const bool has_mass = find_function(program, OutputKind::mass_matrix) != nullptr;
  return !model.is_quadratic || has_mass ||
         std::any_of(program.functions.begin(), program.functions.end(), knows);
}

using Lines = std::vector<std::string>;

std::string append_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

template <class List>
Lines names_with_units(const List& list) {
  Lines names;
  for (const auto& entry : list) names.push_back(append_unit(entry.name, entry.unit_text));
  return names;
}

/// "(x [m], theta [rad])". If the list is longer than a line, only the first two names and the
/// last.
std::string tuple_text(const Lines& names) {
  // A line of 100 columns, minus the columns of "v = ", ", a = dv/dt" and the indentation.
  constexpr std::size_t longest = 80;
  const std::string all = fmt::format("({})", fmt::join(names, ", "));
  if (names.size() <= 3 || all.size() <= longest) return all;
  return fmt::format("({}, {}, ..., {})", names[0], names[1], names.back());
}

/// "dot(x) [m/s]", "attitude[1] [rad/s]"
Lines velocity_names(const Model& model) {
  Lines names;
  for (const Velocity& velocity : model.velocities) {
    const std::string name = velocity.rotation ? velocity.name : "dot(" + velocity.name + ")";
    names.push_back(append_unit(name, velocity_unit_text(model, velocity)));
  }
  return names;
}

/// The unit of the i-th multiplier: "N"; "" if the unit is unknown.
std::string multiplier_unit(const Model& model, std::size_t i) {
  return unit_text_of_entry(model, {OutputKind::forward_dynamics, "multipliers", i, 0});
}

/// "lambda_rod [N]"
Lines multiplier_names(const Model& model) {
  Lines names;
  for (std::uint32_t i = 0; i < model.constraints.size(); ++i) {
    names.push_back(
        append_unit(leaf_text(model, Opcode::multiplier, i), multiplier_unit(model, i)));
  }
  return names;
}

/// True if multipliers do no work: every constraint is on positions and independent of t.
bool are_constraints_workless(const Model& model, const Program& program) {
  if (model.constraints.empty()) return true;
  const Function* const function = find_function(program, OutputKind::constraint_residual);
  return function != nullptr && !contains_time(model, *function) &&
         std::ranges::all_of(model.constraints, &Constraint::is_position);
}

/// Prints expressions in the symbols of the model, with their names unexpanded.
class ExpressionPrinter {
 public:
  explicit ExpressionPrinter(const Model& model) : model_(model), symbols_(model) {}

  [[nodiscard]] const LeafValues<Formula>& symbols() const { return symbols_.leaf_symbols(); }

  [[nodiscard]] Formula operator()(ExpressionId id) const {
    return formula_of(model_, id, [this](ExpressionId named) { return named_formula(named); });
  }

  /// "left = right" for the expression left - right; "value = 0" for other expressions.
  [[nodiscard]] Formula equation(ExpressionId value) const {
    const Expression& e = model_.expressions[value];
    const bool is_pair = e.kind == ExpressionKind::add && e.operands.size() == 2;
    const Expression& last = model_.expressions[is_pair ? e.operands[1] : value];
    if (!is_pair || last.kind != ExpressionKind::negate) {
      return relation((*this)(value), number_formula(0));
    }
    return relation((*this)(e.operands[0]), (*this)(last.operands[0]));
  }

 private:
  [[nodiscard]] Formula named_formula(ExpressionId id) const {
    const Expression& e = model_.expressions[id];
    switch (e.kind) {
      case ExpressionKind::pi:
        return pi_formula();
      case ExpressionKind::leaf:
        return leaf_of(symbols(), e.leaf, e.index);
      case ExpressionKind::named:
        return make_symbol(id, named_symbol(e));
      default: {  // a time derivative; formula_of() prints operations
        Glyphs rate = read_latex("\\frac{d}{dt} \\left( <y> \\right)");
        constexpr bool is_long = true;
        return symbol_formula(
            to_string(model_, id),
            replace_vector(std::move(rate), "y", glyphs_of((*this)(e.operands[0]))), is_long);
      }
    }
  }

  [[nodiscard]] Glyphs named_symbol(const Expression& e) const {
    switch (e.named) {
      case NamedKind::prescribed:
        return symbol_of(model_.prescribed[e.index]);
      case NamedKind::definition:
        return symbol_of(model_.definitions[e.index]);
      case NamedKind::point:
        return component_symbol(model_.points[e.index].name, e.component);
      case NamedKind::body:
        return component_symbol(model_.bodies[e.index].name, e.component);
      case NamedKind::frame:
        break;
    }
    return frame_component_symbol(model_.frames[e.index].name, e.component);
  }

  [[nodiscard]] Formula make_symbol(ExpressionId id, Glyphs glyphs) const {
    return symbol_formula(to_string(model_, id), std::move(glyphs));
  }

  [[nodiscard]] Glyphs symbol_of(const NamedExpression& expression) const {
    return symbol_in_model(model_, expression.name, expression.latex);
  }

  [[nodiscard]] static Glyphs component_symbol(const std::string& point, std::size_t axis) {
    Glyphs symbol = read_latex(std::string(1, "xyz"[axis]));
    add_script(symbol, 1, symbol_of_name(point));
    return symbol;
  }

  /// The symbol of component k of the frame F: x_F for the origin, R_{12}^F, omega_x^F in the axes
  /// of the world, or Omega_x^F in the axes of the frame.
  [[nodiscard]] static Glyphs frame_component_symbol(const std::string& frame, std::uint32_t k) {
    if (k >= frame_origin && k < frame_angular_velocity) return component_symbol(frame, k % 3);
    const std::string_view letter = k < frame_origin           ? "R"
                                    : k < frame_recursive_spin ? "\\omega"
                                                               : "\\Omega";
    Glyphs symbol = read_latex(letter);
    add_script(symbol, 1,
               read_latex(k < frame_origin ? fmt::format("{}{}", k / 3 + 1, k % 3 + 1)
                                           : std::string(1, "xyz"[k % 3])));
    add_script(symbol, 2, symbol_of_name(frame));
    return symbol;
  }

  const Model& model_;
  const ModelSymbols symbols_;
};

const char* kind_text(const Constraint& constraint) {
  return constraint.is_position ? "position" : "velocity";
}

bool has_gains(const Constraint& constraint) { return constraint.omega && constraint.zeta; }

}  // namespace

Formula expression_formula(const Model& model, ExpressionId expression) {
  return ExpressionPrinter(model)(expression);
}

std::vector<ConservedQuantity> conserved_quantities(const Model& model, const Program& program) {
  const Function* const energy = find_function(program, OutputKind::energy_function);
  const bool has_momentum = find_function(program, OutputKind::momentum) != nullptr;
  if (energy == nullptr || !has_momentum || model.approximation) return {};
  const Conservation found = find_conservation(model, program, !model.inputs.empty(), true);
  const LeafValues<Formula> symbols = ModelSymbols(model).leaf_symbols();
  std::vector<ConservedQuantity> result;
  if (!found.is_forced && !found.has_time && are_constraints_workless(model, program)) {
    result.push_back({"E", heading(model, *energy).definition});
  }
  for (const std::uint32_t i : found.momenta) {
    result.push_back({leaf_text(model, Opcode::momentum, i),
                      relation(symbols.momenta[i], partial_derivative("L", symbols.v[i]))});
  }
  return result;
}

Formula equation_of_motion(const Model& model, const Program& program) {
  const bool is_at_rest = !depends_on_motion(model, program);
  const char* const time = model.uses_time ? ",t" : "";
  return latex_formula(
      model, fmt::format("{} = {}", join_terms(left_side(model, program, is_at_rest), time),
                         join_terms(right_side(model, program, is_at_rest), time)));
}

Lines variable_lines(const Model& model, const Program& program) {
  Lines lines = {"q = " + tuple_text(names_with_units(model.coordinates))};
  if (!depends_on_motion(model, program)) {
    lines.emplace_back("at rest");
  } else if (model.rotations.empty()) {
    lines.push_back("v = dq/dt, a = dv/dt");
  } else {
    lines.push_back("v = " + tuple_text(velocity_names(model)) + ", a = dv/dt");
    lines.push_back("dq/dt = N(q) v: coordinate_rates");
  }
  if (may_be_argument(program.leaves, Opcode::momentum)) lines.emplace_back("p = dL/dv: momenta");
  if (!model.inputs.empty()) lines.push_back("u = " + tuple_text(names_with_units(model.inputs)));
  if (!model.constraints.empty())
    lines.push_back("lambda = " + tuple_text(multiplier_names(model)));
  if (!model.constraints.empty() && depends_on_motion(model, program)) {
    lines.push_back(text_of(constraint_equation(model)) + ", (f, r) = constraint_residual");
  }
  if (!model.open_values.empty())
    lines.push_back("f = " + tuple_text(names_with_units(model.open_values)));
  return lines;
}

Formula constraint_equation(const Model& model) {
  std::string latex = "A <a> = -<gamma>";
  if (std::ranges::any_of(model.constraints, has_gains)) latex += R"( - 2 \zeta \omega <r>)";
  const auto is_spring = [](const Constraint& c) { return c.is_position && has_gains(c); };
  if (std::ranges::any_of(model.constraints, is_spring)) latex += R"( - \omega^{2} <f>)";
  return latex_formula(model, latex);
}

std::vector<std::string> constraint_lines(const Model& model) {
  std::vector<std::string> lines;
  const ExpressionPrinter formulas(model);
  for (const Constraint& constraint : model.constraints) {
    std::string& line =
        lines.emplace_back(fmt::format("{} ({}): {}", constraint.name, kind_text(constraint),
                                       text_of(formulas.equation(constraint.value))));
    if (!has_gains(constraint)) continue;
    line += fmt::format(", omega = {}, zeta = {}", to_string(model, *constraint.omega),
                        to_string(model, *constraint.zeta));
  }
  return lines;
}

PageSection constraint_section(const Model& model) {
  PageSection section{.title = prose("Constraints")};
  section.doc =
      "Equations that hold along the motion; the multipliers act as the force A^T lambda.";
  section.definition = constraint_equation(model);
  const bool are_stabilised = std::ranges::any_of(model.constraints, has_gains);
  Formulas& heads = section.table.heads;
  heads = {prose("multiplier"), prose("unit"), prose("kind"), prose("equation")};
  if (are_stabilised) {
    heads.push_back(latex_formula("\\omega"));
    heads.push_back(latex_formula("\\zeta"));
  }
  Formulas& cells = section.table.cells;
  const ExpressionPrinter formulas(model);
  for (std::size_t i = 0; i < model.constraints.size(); ++i) {
    const Constraint& constraint = model.constraints[i];
    const std::string unit = format_unit(multiplier_unit(model, i), " ", small_exponent);
    cells.insert(cells.end(), {formulas.symbols().multipliers[i], prose(unit),
                               prose(kind_text(constraint)), formulas.equation(constraint.value)});
    for (const std::optional<ExpressionId>& gain : {constraint.omega, constraint.zeta}) {
      if (are_stabilised) cells.push_back(gain ? formulas(*gain) : number_formula(0));
    }
    const bool is_printed = section.doc.find(constraint.doc) != std::string::npos;
    if (!is_printed) section.doc += fmt::format(" {}: {}.", constraint.name, constraint.doc);
  }
  return section;
}

}  // namespace elgen
