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
    text += fmt::format(", {} = {}", model.inputs[i].name, short_number_text(equilibria.inputs[i]));
  }
  return text;
}

/// The stiffness K = dr/dq of a model with one coordinate and the residual r; otherwise none.
OptionalFraction stiffness_of(PageForms& known) {
  if (known.model.velocities.size() != 1 || known.model.coordinates.size() != 1) return {};
  const OptionalFraction row = known.forms.functions[0].fields[0].entries[0];
  return row ? partial_derivative(known.forms, *row, 0, 1) : std::nullopt;
}

Formula coordinate_cell(PageForms& known, const RestCoordinate& at, bool is_pair) {
  if (at.is_arbitrary) return prose("any");
  OptionalFraction form = at.closed_form;
  if (is_pair && cln::minusp(at.value)) form = Arithmetic(known.forms.algebra).negate(form);
  const std::optional<Formula> formula = known.to_formula(form);
  if (!formula) return six_digit_formula(at.value);
  const auto with_sign = [is_pair](Formula x) { return is_pair ? plus_minus(std::move(x)) : x; };
  const bool is_plain =
      !at.inverse_argument && !contains_leaves(known.forms.algebra, *at.closed_form);
  if (is_plain) return with_sign(*formula);
  return relation(with_sign(*formula),
                  with_sign(six_digit_formula(is_pair ? cln::abs(at.value) : at.value)));
}

/// Appends "the chart is singular at beta = +-pi/2" to `lines`, unless `breaks` is empty.
void add_chart_breaks(Formulas& lines, PageForms& known,
                      const std::vector<ChartSingularity>& breaks) {
  Formulas places;
  for (const ChartSingularity& here : breaks) {
    const bool is_pair = here.value.closed_form &&
                         std::ranges::any_of(breaks, [&here](const ChartSingularity& other) {
                           return other.coordinate == here.coordinate &&
                                  !cln::zerop(here.value.value) &&
                                  is_near(Real(other.value.value), -Real(here.value.value));
                         });
    if (is_pair && cln::minusp(here.value.value)) continue;
    places.push_back(
        relation(known.symbols.q[here.coordinate], coordinate_cell(known, here.value, is_pair)));
  }
  if (places.empty()) return;
  lines.push_back(row_of({prose("the chart is singular at"), enumeration(std::move(places))}));
}

Formula residual_name(const Model& model) {
  if (!model.inputs.empty()) return latex_symbol("bias - B u", "\\mathrm{bias} - B u");
  const bool has_bias = model.may_drift || !model.forces.empty();
  return has_bias ? latex_symbol("bias", "\\mathrm{bias}") : latex_formula("g");
}

/// "g = (0, m*g*l*sin(theta))"
Formula residual_formula(const PageForms& known) {
  Formulas entries;
  for (const OptionalFraction& row : known.forms.functions[0].fields[0].entries) {
    std::optional<Formula> entry = known.to_formula(row);
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

void add_cyclic_note(Formulas& lines, const CheckedModel& checked, const PageForms& known) {
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

void add_input_note(Formulas& lines, const PageForms& known) {
  if (known.symbols.u.empty()) return;
  lines.push_back(row_of(
      {prose("an input is 0 unless --input NAME=VALUE sets it:"), enumeration(known.symbols.u)}));
}

Formulas no_equilibrium_lines(const CheckedModel& checked, PageForms& known,
                              const Equilibria& equilibria) {
  Formulas lines;
  const Formula proved = proved_domain(known, equilibria);
  if (equilibria.completeness != Completeness::proved) {
    if (equilibria.undecided_boxes.empty()) lines.push_back(prose("no equilibrium was found"));
    add_chart_breaks(lines, known, equilibria.chart_singularities);
    lines.push_back(completeness_claim(known.model, equilibria));
    return lines;
  }
  if (equilibria.chart_singularities.empty()) {
    lines.push_back(
        row_of({prose("no equilibrium:"), residual_formula(known), prose("is not 0"), proved}));
    add_input_note(lines, known);
  } else {
    lines.push_back(row_of({prose("no equilibrium with a regular M"), proved}));
    add_chart_breaks(lines, known, equilibria.chart_singularities);
  }
  add_cyclic_note(lines, checked, known);
  return lines;
}

Formula rest_energy(const Equilibria& equilibria) {
  Formula potential = latex_symbol("V0", "V_0");
  if (!equilibria.has_rest_kinetic_energy) return potential;
  return sum_of({std::move(potential), negative_of(latex_symbol("T0", "T_0"))});
}

/// "q - q0", "q + 0.3"
Formula deviation(PageForms& known, const RestCoordinate& at, const Formula& symbol) {
  if (cln::zerop(at.value)) return symbol;
  const bool is_negative = cln::minusp(at.value);
  const OptionalFraction form =
      is_negative ? Arithmetic(known.forms.algebra).negate(at.closed_form) : at.closed_form;
  Formula size = known.to_formula(form).value_or(six_digit_formula(cln::abs(at.value)));
  return sum_of({symbol, is_negative ? std::move(size) : negative_of(std::move(size))});
}

/// "V0 - T0 = 9/8*m*R*theta^4 + …"
Formula leading_term_formula(PageForms& known, const Equilibria& equilibria,
                             const RestPoint& point) {
  const LeadingTerm& term = *point.stability.leading;
  Formula shift =
      deviation(known, point.coordinates[term.coordinate], known.symbols.q[term.coordinate]);
  Formula first = product_of({known.to_formula(term.coefficient).value_or(latex_formula("c")),
                              power_of(std::move(shift), number_formula(term.order))});
  return relation(rest_energy(equilibria),
                  sum_of({std::move(first), latex_symbol("...", "\\text{…}")}));
}

Formula stability_formula(PageForms& known, const Equilibria& equilibria, const RestPoint& point) {
  const StabilityVerdict& verdict = point.stability;
  const std::string degenerate = verdict.is_degenerate ? "degenerate: K = 0; " : "";
  switch (verdict.kind) {
    case Stability::minimum:
      return row_of({prose("stable:"), rest_energy(equilibria), prose("has a strict minimum")});
    case Stability::degenerate_minimum:
      return row_of(
          {prose(degenerate + "stable:"), leading_term_formula(known, equilibria, point),
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
    case Stability::undecided:
      return prose(degenerate + "not decided by the linearisation");
  }
  return {};
}

Formula stiffness_at(PageForms& known, const RestPoint& point) {
  const std::vector<Fraction> forms = rest_matrices(known.model, known.forms, point).stiffness;
  const std::optional<Formula> formula =
      forms.empty() ? std::nullopt : known.to_formula(forms.front());
  return formula ? *formula : six_digit_formula(point.stiffness[0]);
}

PageTable points_table(PageForms& known, const Equilibria& equilibria, bool has_stiffness) {
  PageTable table{known.symbols.q};
  if (has_stiffness) table.heads.push_back(latex_formula("K"));
  table.heads.emplace_back();
  const std::vector<RestPoint>& points = equilibria.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_pair =
        i + 1 < points.size() && is_mirrored(known.forms, points[i], points[i + 1]);
    for (const RestCoordinate& coordinate : points[i].coordinates) {
      table.cells.push_back(
          coordinate_cell(known, coordinate, is_pair && coordinate.inverse_argument));
    }
    if (has_stiffness) table.cells.push_back(stiffness_at(known, points[i]));
    table.cells.push_back(stability_formula(known, equilibria, points[i]));
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
    page.sections.push_back({.lines = no_equilibrium_lines(checked, known, equilibria)});
    return page;
  }
  const OptionalFraction stiffness = stiffness_of(known);
  if (std::optional<Formula> formula = known.to_formula(stiffness)) {
    page.sections.push_back({.equations = {{latex_formula("K"), 1, 1, {std::move(*formula)}}}});
  }
  page.sections.push_back({.table = points_table(known, equilibria, stiffness.has_value())});
  Formulas claims{scope_claim(known, equilibria)};
  add_chart_breaks(claims, known, equilibria.chart_singularities);
  claims.push_back(completeness_claim(model, equilibria));
  page.sections.push_back({.lines = std::move(claims)});
  return page;
}

}  // namespace elgen
