// constraints: both sides of an equation stand as the expressions of the model, names as names.
#include "render/constraints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "model/formula.hpp"
#include "model/output_units.hpp"
#include "render/drawing.hpp"
#include "render/headings.hpp"
#include "render/symbols.hpp"

namespace elgen {
namespace {

/// Expressions in LaTeX, where what has a name stands by it.
class NamedFormulas {
 public:
  explicit NamedFormulas(const Model& model)
      : model_(model), symbols_(ModelSymbols(model).leaves()) {}

  [[nodiscard]] const LeafValues<std::string>& symbols() const { return symbols_; }

  [[nodiscard]] std::string operator()(ExpressionId id) const {
    const auto named = [this](ExpressionId inner) { return Formula{name(inner)}; };
    return formula_of(model_, id, latex_spelling, named).text();
  }

 private:
  [[nodiscard]] std::string name(ExpressionId id) const {
    const Expression& e = model_.expressions[id];
    switch (e.kind) {
      case ExpressionKind::pi:
        return "\\pi";
      case ExpressionKind::leaf:
        return leaf_of(symbols_, e.leaf, e.index);
      case ExpressionKind::prescribed:
        return symbol_of_name(model_.prescribed[e.index]);
      case ExpressionKind::definition:
        return symbol_of_name(model_.definitions[e.index]);
      case ExpressionKind::point_component:
        return component(model_.points[e.index / 3].name, e.index % 3);
      case ExpressionKind::time_derivative:
        return fmt::format("\\frac{{d}}{{dt}} \\left( {} \\right)", (*this)(e.operands[0]));
      default:  // a model writes the origin of a frame only
        return component(model_.frames[e.index / components_per_frame].name, e.index % 3);
    }
  }

  [[nodiscard]] static std::string symbol_of_name(const NamedExpression& expression) {
    return latex_symbol(expression.name, expression.latex).text();
  }

  [[nodiscard]] static std::string component(const std::string& point, std::size_t axis) {
    return fmt::format("{}_{{{}}}", "xyz"[axis], latex_symbol(point).text());
  }

  const Model& model_;
  const LeafValues<std::string> symbols_;
};

/// "left = right" of left - right, "value = 0" of others.
template <class Print>
std::string typed_equation(const Model& model, ExpressionId value, const Print& print) {
  const Expression& e = model.expressions[value];
  const bool is_pair = e.kind == ExpressionKind::add && e.operands.size() == 2;
  const Expression& last = model.expressions[is_pair ? e.operands[1] : value];
  if (!is_pair || last.kind != ExpressionKind::negate) return print(value) + " = 0";
  return fmt::format("{} = {}", print(e.operands[0]), print(last.operands[0]));
}

const char* kind_of(const Constraint& constraint) {
  return constraint.is_position ? "position" : "velocity";
}

bool has_gains(const Constraint& constraint) { return constraint.omega && constraint.zeta; }

}  // namespace

EquationOfMotion constraint_equation(const Model& model) {
  std::string text = "A a = -gamma";
  std::string latex = "A <a> = -<gamma>";
  if (std::ranges::any_of(model.constraints, has_gains)) {
    text += " - 2 zeta omega r";
    latex += R"( - 2 \zeta \omega <r>)";
  }
  const auto is_spring = [](const Constraint& c) { return c.is_position && has_gains(c); };
  if (std::ranges::any_of(model.constraints, is_spring)) {
    text += " - omega^2 f";
    latex += R"( - \omega^{2} <f>)";
  }
  return {text, latex_of(model, latex)};
}

std::string multiplier_unit(const Model& model, std::size_t i) {
  return unit_text_of_entry(model, {OutputKind::forward_dynamics, "multipliers", i, 0});
}

std::vector<std::string> constraint_lines(const Model& model) {
  std::vector<std::string> lines;
  const auto print = [&model](ExpressionId id) { return to_string(model, id); };
  for (const Constraint& constraint : model.constraints) {
    std::string& line =
        lines.emplace_back(fmt::format("{} ({}): {}", constraint.name, kind_of(constraint),
                                       typed_equation(model, constraint.value, print)));
    if (!has_gains(constraint)) continue;
    line +=
        fmt::format(", omega = {}, zeta = {}", print(*constraint.omega), print(*constraint.zeta));
  }
  return lines;
}

SheetOutput constraint_section(const Model& model) {
  SheetOutput section{.title = "Constraints"};
  section.doc = "Equations that the motion obeys; their multipliers act as A^T lambda.";
  section.definition = constraint_equation(model).latex;
  const bool are_stabilised = std::ranges::any_of(model.constraints, has_gains);
  std::vector<std::string>& heads = section.table.heads;
  heads = {"\\text{multiplier}", "\\text{unit}", "\\text{kind}", "\\text{equation}"};
  if (are_stabilised) {
    heads.emplace_back("\\omega");
    heads.emplace_back("\\zeta");
  }
  std::vector<std::string>& cells = section.table.cells;
  const NamedFormulas print(model);
  for (std::size_t i = 0; i < model.constraints.size(); ++i) {
    const Constraint& constraint = model.constraints[i];
    const std::string unit = unit_text(multiplier_unit(model, i), " ", small_exponent);
    cells.insert(cells.end(), {print.symbols().multipliers[i], fmt::format("\\text{{{}}}", unit),
                               fmt::format("\\text{{{}}}", kind_of(constraint)),
                               typed_equation(model, constraint.value, print)});
    for (const std::optional<ExpressionId>& gain : {constraint.omega, constraint.zeta}) {
      if (are_stabilised) cells.push_back(gain ? print(*gain) : "0");
    }
    const bool is_told = section.doc.find(constraint.doc) != std::string::npos;
    if (!is_told) section.doc += fmt::format(" {}: {}.", constraint.name, constraint.doc);
  }
  return section;
}

}  // namespace elgen
