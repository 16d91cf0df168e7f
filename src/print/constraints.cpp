// constraints: both sides of an equation stand as the expressions of the model, names as names.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "formula/drawing.hpp"
#include "model/output_units.hpp"
#include "model/symbols.hpp"
#include "print/sections.hpp"

namespace elgen {
namespace {

/// Expressions where names stand as they are, in the symbols of the model.
class NamedFormulas {
 public:
  explicit NamedFormulas(const Model& model) : model_(model), symbols_(model) {}

  [[nodiscard]] const LeafValues<Formula>& symbols() const { return symbols_.leaves(); }

  [[nodiscard]] Formula operator()(ExpressionId id) const {
    return formula_of(model_, id, [this](ExpressionId named) { return name(named); });
  }

  /// "left = right" of left - right, "value = 0" of others.
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
  [[nodiscard]] Formula name(ExpressionId id) const {
    const Expression& e = model_.expressions[id];
    switch (e.kind) {
      case ExpressionKind::pi:
        return pi_formula();
      case ExpressionKind::leaf:
        return leaf_of(symbols(), e.leaf, e.index);
      case ExpressionKind::prescribed:
        return symbol(id, symbol_of(model_.prescribed[e.index]));
      case ExpressionKind::definition:
        return symbol(id, symbol_of(model_.definitions[e.index]));
      case ExpressionKind::point_component:
        return symbol(id, component(model_.points[e.index / 3].name, e.index % 3));
      case ExpressionKind::time_derivative: {
        Glyphs rate = read_latex("\\frac{d}{dt} \\left( <y> \\right)");
        return symbol(id, replaced(std::move(rate), "y", glyphs_of((*this)(e.operands[0]))));
      }
      default:  // a model writes the origin of a frame only
        return symbol(id,
                      component(model_.frames[e.index / components_per_frame].name, e.index % 3));
    }
  }

  [[nodiscard]] Formula symbol(ExpressionId id, Glyphs glyphs) const {
    return symbol_formula(to_string(model_, id), std::move(glyphs));
  }

  [[nodiscard]] static Glyphs symbol_of(const NamedExpression& expression) {
    return symbol_of_name(expression.name, expression.latex);
  }

  [[nodiscard]] static Glyphs component(const std::string& point, std::size_t axis) {
    Glyphs symbol = read_latex(std::string(1, "xyz"[axis]));
    add_script(symbol, 1, symbol_of_name(point));
    return symbol;
  }

  const Model& model_;
  const ModelSymbols symbols_;
};

const char* kind_of(const Constraint& constraint) {
  return constraint.is_position ? "position" : "velocity";
}

bool has_gains(const Constraint& constraint) { return constraint.omega && constraint.zeta; }

}  // namespace

Formula constraint_equation(const Model& model) {
  std::string latex = "A <a> = -<gamma>";
  if (std::ranges::any_of(model.constraints, has_gains)) latex += R"( - 2 \zeta \omega <r>)";
  const auto is_spring = [](const Constraint& c) { return c.is_position && has_gains(c); };
  if (std::ranges::any_of(model.constraints, is_spring)) latex += R"( - \omega^{2} <f>)";
  return typed_formula(model, latex);
}

std::string multiplier_unit(const Model& model, std::size_t i) {
  return unit_text_of_entry(model, {OutputKind::forward_dynamics, "multipliers", i, 0});
}

std::vector<std::string> constraint_lines(const Model& model) {
  std::vector<std::string> lines;
  const NamedFormulas formulas(model);
  for (const Constraint& constraint : model.constraints) {
    std::string& line =
        lines.emplace_back(fmt::format("{} ({}): {}", constraint.name, kind_of(constraint),
                                       text_of(formulas.equation(constraint.value))));
    if (!has_gains(constraint)) continue;
    line += fmt::format(", omega = {}, zeta = {}", to_string(model, *constraint.omega),
                        to_string(model, *constraint.zeta));
  }
  return lines;
}

PageSection constraint_section(const Model& model) {
  PageSection section{.title = prose("Constraints")};
  section.doc = "Equations that the motion obeys; their multipliers act as A^T lambda.";
  section.definition = constraint_equation(model);
  const bool are_stabilised = std::ranges::any_of(model.constraints, has_gains);
  Formulas& heads = section.table.heads;
  heads = {prose("multiplier"), prose("unit"), prose("kind"), prose("equation")};
  if (are_stabilised) {
    heads.push_back(typed_formula("\\omega"));
    heads.push_back(typed_formula("\\zeta"));
  }
  Formulas& cells = section.table.cells;
  const NamedFormulas formulas(model);
  for (std::size_t i = 0; i < model.constraints.size(); ++i) {
    const Constraint& constraint = model.constraints[i];
    const std::string unit = unit_text(multiplier_unit(model, i), " ", small_exponent);
    cells.insert(cells.end(), {formulas.symbols().multipliers[i], prose(unit),
                               prose(kind_of(constraint)), formulas.equation(constraint.value)});
    for (const std::optional<ExpressionId>& gain : {constraint.omega, constraint.zeta}) {
      if (are_stabilised) cells.push_back(gain ? formulas(*gain) : number_formula(0));
    }
    const bool is_told = section.doc.find(constraint.doc) != std::string::npos;
    if (!is_told) section.doc += fmt::format(" {}: {}.", constraint.name, constraint.doc);
  }
  return section;
}

}  // namespace elgen
