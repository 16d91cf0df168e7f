// equilibria_page: formulas, a table of points, conditions, and the claim of completeness.
#include <fmt/format.h>

#include <algorithm>

#include "analyse/formulas.hpp"
#include "analyse/frequencies.hpp"
#include "elgen/analysis_pages.hpp"
#include "elgen/inspect.hpp"
#include "print/analyses/page_parts.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

std::string input_values_text(const Model& model, const Equilibria& equilibria) {
  std::string text;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (cln::zerop(equilibria.inputs[i])) continue;
    text += fmt::format(", {} = {}", model.inputs[i].name, short_text(equilibria.inputs[i]));
  }
  return text;
}

/// The stiffness K of a model with one coordinate; none for other models.
Value stiffness_of(PageForms& known) {
  if (known.model.velocities.size() != 1 || known.model.coordinates.size() != 1) return {};
  const Value row = known.forms.functions[0].fields[0].entries[0];
  return row ? partial_derivative(known.forms, *row, 0, 1) : std::nullopt;
}

Formula cell_of(PageForms& known, const CoordinateAtRest& at, bool is_pair) {
  if (at.is_any) return prose("any");
  Value form = at.form;
  if (is_pair && cln::minusp(at.value)) form = Arithmetic(known.forms.algebra).negate(form);
  const std::optional<Formula> formula = known.read(form);
  if (!formula) return six_digits(at.value);
  const auto with_sign = [is_pair](Formula x) { return is_pair ? plus_minus(std::move(x)) : x; };
  const bool is_plain = !at.sinusoid && !holds_leaves(known.forms.algebra, *at.form);
  if (is_plain) return with_sign(*formula);
  return relation(with_sign(*formula),
                  with_sign(six_digits(is_pair ? cln::abs(at.value) : at.value)));
}

/// "the chart is singular at beta = +-pi/2"
void add_breaks(Formulas& lines, PageForms& known, const std::vector<ChartBreak>& breaks) {
  Formulas places;
  for (const ChartBreak& here : breaks) {
    const bool is_pair =
        here.at.form && std::ranges::any_of(breaks, [&here](const ChartBreak& other) {
          return other.coordinate == here.coordinate && !cln::zerop(here.at.value) &&
                 is_near(Real(other.at.value), -Real(here.at.value));
        });
    if (is_pair && cln::minusp(here.at.value)) continue;
    places.push_back(relation(known.symbols.q[here.coordinate], cell_of(known, here.at, is_pair)));
  }
  if (places.empty()) return;
  lines.push_back(row_of({prose("the chart is singular at"), enumeration(std::move(places))}));
}

// Functions for a page without points.

Formula residual_name(const Model& model) {
  if (!model.inputs.empty()) return symbol("bias - B u", "\\mathrm{bias} - B u");
  const bool has_bias = model.may_drift || !model.forces.empty();
  return has_bias ? symbol("bias", "\\mathrm{bias}") : latex_formula("g");
}

/// "g = (0, m*g*l*sin(theta))"
Formula residual(const PageForms& known) {
  Formulas entries;
  for (const Value& row : known.forms.functions[0].fields[0].entries) {
    std::optional<Formula> entry = known.read(row);
    if (!entry) return residual_name(known.model);
    entries.push_back(std::move(*entry));
  }
  return relation(residual_name(known.model),
                  entries.size() == 1 ? std::move(entries[0]) : tuple_of(std::move(entries)));
}

/// "for r in [0.3, 3] at the parameters' values (proved)"
Formula proved_domain(const PageForms& known, const Equilibria& equilibria) {
  Formulas parts;
  for (Formula& range : searched_ranges(known, equilibria)) {
    parts.push_back(prose(parts.empty() ? "for" : "and"));
    parts.push_back(std::move(range));
  }
  parts.push_back(prose("at the parameters' values (proved)"));
  return row_of(std::move(parts));
}

void add_cyclic(Formulas& lines, const CheckedModel& checked, const PageForms& known) {
  Formulas symbols;
  std::string name;
  for (std::uint32_t i = 0; i < known.symbols.q.size(); ++i) {
    if (!is_cyclic(checked, i)) continue;
    symbols.push_back(known.symbols.q[i]);
    name = checked.model.coordinates[i].name;
  }
  if (symbols.empty()) return;
  const std::string one = fmt::format(
      "is cyclic: a scene with [routh] {} = true holds its momentum and may have steady motions",
      name);
  const char* const many =
      "are cyclic: a scene with [routh] holds their momenta and may have steady motions";
  Formula claim = prose(symbols.size() == 1 ? one : many);
  lines.push_back(row_of({enumeration(std::move(symbols)), std::move(claim)}));
}

Formulas lines_without_points(const CheckedModel& checked, PageForms& known,
                              const Equilibria& equilibria) {
  Formulas lines;
  const Formula proved = proved_domain(known, equilibria);
  if (equilibria.completeness != Completeness::proved) {
    if (equilibria.undecided.empty()) lines.push_back(prose("no equilibrium was found"));
    add_breaks(lines, known, equilibria.breaks);
    lines.push_back(claim_of(known.model, equilibria));
    return lines;
  }
  if (equilibria.breaks.empty()) {
    lines.push_back(row_of({prose("no equilibrium:"), residual(known), prose("is not 0"), proved}));
  } else {
    lines.push_back(row_of({prose("no equilibrium with a regular M"), proved}));
    add_breaks(lines, known, equilibria.breaks);
  }
  add_cyclic(lines, checked, known);
  return lines;
}

// Functions for a page with points.

Formula rest_energy(const Equilibria& equilibria) {
  Formula potential = symbol("V0", "V_0");
  if (!equilibria.has_rest_kinetic_energy) return potential;
  return sum_of({std::move(potential), negative(symbol("T0", "T_0"))});
}

/// "q - q0", "q + 0.3"
Formula deviation(PageForms& known, const CoordinateAtRest& at, const Formula& symbol) {
  if (cln::zerop(at.value)) return symbol;
  const bool is_negative = cln::minusp(at.value);
  const Value form = is_negative ? Arithmetic(known.forms.algebra).negate(at.form) : at.form;
  Formula size = known.read(form).value_or(six_digits(cln::abs(at.value)));
  return sum_of({symbol, is_negative ? std::move(size) : negative(std::move(size))});
}

/// "V0 - T0 = 9/8*m*R*theta^4 + …"
Formula leading_term(PageForms& known, const Equilibria& equilibria, const RestPoint& point) {
  const LeadingTerm& term = *point.stability.leading;
  Formula shift =
      deviation(known, point.coordinates[term.coordinate], known.symbols.q[term.coordinate]);
  Formula first = product_of({known.read(term.coefficient).value_or(latex_formula("c")),
                              power_of(std::move(shift), number_formula(term.order))});
  return relation(rest_energy(equilibria), sum_of({std::move(first), symbol("...", "\\text{…}")}));
}

Formula verdict_of(PageForms& known, const Equilibria& equilibria, const RestPoint& point) {
  const StabilityVerdict& verdict = point.stability;
  const std::string degenerate = verdict.is_degenerate ? "degenerate: K = 0; " : "";
  switch (verdict.kind) {
    case Stability::minimum:
      return row_of({prose("stable:"), rest_energy(equilibria), prose("has a strict minimum")});
    case Stability::degenerate_minimum:
      return row_of(
          {prose(degenerate + "stable:"), leading_term(known, equilibria, point),
           prose(fmt::format("has a strict minimum of order {}", verdict.leading->order))});
    case Stability::decaying:
      return prose(degenerate + "stable: all poles have negative real parts");
    case Stability::unstable: {
      std::string rates;
      for (const double rate : verdict.growth_rates) {
        rates += fmt::format("{}{:.6g} 1/s", rates.empty() ? "" : ", ", rate);
      }
      return prose("unstable: " + rates);
    }
    case Stability::open:
      return prose(degenerate + "not decided by the linearisation");
  }
  return {};
}

Formula stiffness_at(PageForms& known, const RestPoint& point) {
  const std::vector<Fraction> forms = forms_at_rest(known.model, known.forms, point).stiffness;
  const std::optional<Formula> formula = forms.empty() ? std::nullopt : known.read(forms.front());
  return formula ? *formula : six_digits(point.stiffness[0]);
}

PageTable table_of_points(PageForms& known, const Equilibria& equilibria, bool has_stiffness) {
  PageTable table{known.symbols.q};
  if (has_stiffness) table.heads.push_back(latex_formula("K"));
  table.heads.emplace_back();
  const std::vector<RestPoint>& points = equilibria.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_pair =
        i + 1 < points.size() && is_mirrored(known.forms, points[i], points[i + 1]);
    for (const CoordinateAtRest& coordinate : points[i].coordinates) {
      table.cells.push_back(cell_of(known, coordinate, is_pair && coordinate.sinusoid));
    }
    if (has_stiffness) table.cells.push_back(stiffness_at(known, points[i]));
    table.cells.push_back(verdict_of(known, equilibria, points[i]));
    if (is_pair) ++i;
  }
  return table;
}

}  // namespace

Page equilibria_page(const CheckedModel& checked, const Equilibria& equilibria) {
  const Model& model = checked.model;
  PageForms known(model, equilibria.forms);
  Page page{.title = analysis_title(checked, fmt::format("equilibria (v = 0{})",
                                                         input_values_text(model, equilibria)))};
  if (equilibria.points.empty()) {
    page.sections.push_back({.lines = lines_without_points(checked, known, equilibria)});
    return page;
  }
  const Value stiffness = stiffness_of(known);
  if (std::optional<Formula> formula = known.read(stiffness)) {
    page.sections.push_back({.equations = {{latex_formula("K"), 1, 1, {std::move(*formula)}}}});
  }
  page.sections.push_back({.table = table_of_points(known, equilibria, stiffness.has_value())});
  Formulas claims{scope_of(known, equilibria)};
  add_breaks(claims, known, equilibria.breaks);
  claims.push_back(claim_of(model, equilibria));
  page.sections.push_back({.lines = std::move(claims)});
  return page;
}

}  // namespace elgen
