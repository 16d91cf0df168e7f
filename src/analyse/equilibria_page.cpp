// The page of equilibria: formulas, a table of points, the conditions, the claim.
#include <fmt/format.h>

#include <algorithm>

#include "analyse/claims.hpp"
#include "analyse/exact_roots.hpp"
#include "analyse/page.hpp"
#include "analyse/searched_range.hpp"
#include "elgen/inspect.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

class EquilibriaPage {
 public:
  EquilibriaPage(const CheckedModel& checked, const Equilibria& equilibria)
      : checked_(checked),
        model_(checked.model),
        equilibria_(equilibria),
        forms_(equilibria.forms),
        symbols_(symbols_of(checked.model)) {}

  AnalysisPage operator()() {
    page_.title = titled(checked_, fmt::format("equilibria (v = 0{})", given_inputs()));
    if (equilibria_.points.empty()) {
      add_none();
    } else {
      add_points();
    }
    return std::move(page_);
  }

 private:
  [[nodiscard]] std::string given_inputs() const {
    std::string text;
    for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
      if (cln::zerop(equilibria_.inputs[i])) continue;
      text += fmt::format(", {} = {}", model_.inputs[i].name, short_text(equilibria_.inputs[i]));
    }
    return text;
  }

  [[nodiscard]] const std::vector<std::optional<Fraction>>& rows() const {
    return forms_.functions[0].fields[0].entries;
  }

  [[nodiscard]] std::optional<Printed> read(const std::optional<Fraction>& form) const {
    return printed(model_, forms_.algebra, form);
  }

  [[nodiscard]] Printed rest_energy() const {
    if (equilibria_.has_rest_kinetic_energy) return {"V0 - T0", "V_0 - T_0"};
    return {"V0", "V_0"};
  }

  // The page without points.

  void add_none() {
    PagePart& part = page_.parts.emplace_back();
    const bool is_proved = equilibria_.completeness == Completeness::proved;
    if (!is_proved || !equilibria_.breaks.empty()) {
      const Printed proved = prose("none where M is regular") + searched_domain() +
                             prose("at the parameters' values (proved)");
      const bool is_left = !is_proved && !equilibria_.undecided.empty();
      if (!is_left) part.lines.push_back(is_proved ? proved : prose("none was found"));
      add_breaks(part);
      if (!is_proved) part.lines.push_back(claim_of(model_, equilibria_));
      if (is_proved) add_cyclic(part);
      return;
    }
    std::vector<Printed> entries;
    for (const auto& row : rows()) {
      if (const std::optional<Printed> entry = read(row)) entries.push_back(*entry);
    }
    Printed residual = residual_name();
    if (entries.size() == rows().size()) residual = equated(residual, entries);
    part.lines.push_back(prose("none:") + residual + prose("is not 0") + searched_domain() +
                         prose("at the parameters' values (proved)"));
    add_cyclic(part);
  }

  /// "g = (0, m g l sin(theta))"
  static Printed equated(const Printed& name, const std::vector<Printed>& entries) {
    const Printed list = with_commas(entries);
    if (entries.size() == 1) return equation(name, list);
    return equation(name, {"(" + list.text + ")", "(" + list.latex + ")"});
  }

  [[nodiscard]] Printed residual_name() const {
    if (!model_.inputs.empty()) return {"bias - B u", "\\mathrm{bias} - B u"};
    if (model_.may_drift || !model_.forces.empty()) return prose("bias");
    return {"g", "g"};
  }

  /// "for r in [0.3, 3]"
  [[nodiscard]] Printed searched_domain() const {
    Printed result;
    for (std::size_t i = 0; i < model_.coordinates.size(); ++i) {
      const Interval* const range = searched_range(model_.coordinates[i], equilibria_.kinds[i]);
      if (range == nullptr) continue;
      const std::string interval =
          fmt::format("in [{}, {}]", short_text(range->low), short_text(range->high));
      result =
          result + prose(result.text.empty() ? "for" : "and") + symbols_.q[i] + prose(interval);
    }
    return result;
  }

  void add_cyclic(PagePart& part) const {
    std::vector<Printed> symbols;
    std::string name;
    for (std::uint32_t i = 0; i < model_.coordinates.size(); ++i) {
      if (!is_cyclic(checked_, i)) continue;
      symbols.push_back(symbols_.q[i]);
      name = model_.coordinates[i].name;
    }
    if (symbols.empty()) return;
    const std::string one = fmt::format(
        "is cyclic: with its momentum held (scene: [routh] {} = true) there may be steady motions",
        name);
    const char* const many =
        "are cyclic: with their momenta held (scene: [routh]) there may be steady motions";
    part.lines.push_back(listed(symbols) + prose(symbols.size() == 1 ? one : many));
  }

  // The page of points.

  void add_points() {
    find_stiffness();
    if (stiffness_) {
      if (const auto formula = read(stiffness_)) {
        page_.parts.emplace_back().matrices.push_back({{"K", "K"}, 1, 1, {*formula}});
      }
    }
    PagePart& part = page_.parts.emplace_back();
    PageTable& table = part.table;
    for (const Printed& symbol : symbols_.q) table.heads.push_back(symbol);
    if (stiffness_) table.heads.push_back({"K", "K"});
    table.heads.emplace_back();
    for (std::size_t i = 0; i < equilibria_.points.size(); ++i) {
      const std::vector<RestPoint>& points = equilibria_.points;
      const bool is_pair = i + 1 < points.size() && is_mirrored(forms_, points[i], points[i + 1]);
      add_row(table, points[i], is_pair);
      if (is_pair) ++i;
    }
    PagePart& claims = page_.parts.emplace_back();
    claims.lines.push_back(scope_of(model_, equilibria_));
    add_breaks(claims);
    claims.lines.push_back(claim_of(model_, equilibria_));
  }

  /// "the chart breaks at beta = +-pi/2"
  void add_breaks(PagePart& part) {
    std::vector<Printed> places;
    for (const ChartBreak& here : equilibria_.breaks) {
      const bool is_pair =
          here.at.form && std::ranges::any_of(equilibria_.breaks, [&here](const ChartBreak& other) {
            return other.coordinate == here.coordinate && !cln::zerop(here.at.value) &&
                   is_near(Real(other.at.value), -Real(here.at.value));
          });
      if (is_pair && cln::minusp(here.at.value)) continue;
      places.push_back(symbols_.q[here.coordinate] + Printed{"=", "="} + cell_of(here.at, is_pair));
    }
    if (!places.empty()) part.lines.push_back(prose("the chart breaks at") + listed(places));
  }

  /// K of a system with one coordinate.
  void find_stiffness() {
    if (model_.velocities.size() != 1 || model_.coordinates.size() != 1 || !rows()[0]) return;
    const Fraction row = *rows()[0];
    stiffness_ = partial_derivative(forms_, row, 0, 1);
  }

  void add_row(PageTable& table, const RestPoint& point, bool is_pair) {
    for (const CoordinateAtRest& coordinate : point.coordinates) {
      table.cells.push_back(cell_of(coordinate, is_pair && coordinate.sinusoid));
    }
    if (stiffness_) table.cells.push_back(stiffness_at(point));
    table.cells.push_back(verdict_of(point));
  }

  Printed cell_of(const CoordinateAtRest& coordinate, bool is_pair) {
    if (coordinate.is_any) return prose("any");
    if (!coordinate.form) return number(coordinate.value);
    Value form = coordinate.form;
    if (is_pair && cln::minusp(coordinate.value)) form = Arithmetic(forms_.algebra).negate(form);
    std::optional<Printed> formula = read(form);
    if (!formula) return number(coordinate.value);
    if (is_pair) formula = at_least(*formula, Binding::product);
    const cln::cl_R size = is_pair ? cln::abs(coordinate.value) : coordinate.value;
    const Printed sign = is_pair ? Printed{"+-", "\\pm "} : Printed{};
    const Printed signed_form{sign.text + formula->text, sign.latex + formula->latex};
    const Printed value = number(size);
    const bool is_plain = !coordinate.sinusoid && !holds_leaves(forms_.algebra, *coordinate.form);
    if (is_plain) return signed_form;
    return equation(signed_form, {sign.text + value.text, sign.latex + value.latex});
  }

  Printed stiffness_at(const RestPoint& point) {
    const CoordinateAtRest& coordinate = point.coordinates[0];
    if (coordinate.form) {
      const Value value =
          substituted(forms_.algebra, stiffness_, replacements_of({0}, {coordinate}));
      if (const auto formula = read(value)) return *formula;
    }
    return number(point.stiffness[0]);
  }

  Printed verdict_of(const RestPoint& point) {
    const StabilityVerdict& verdict = point.stability;
    const Printed degenerate = verdict.is_degenerate ? prose("degenerate: K = 0;") : Printed{};
    switch (verdict.kind) {
      case Stability::minimum:
        return prose("stable:") + rest_energy() + prose("has a strict minimum");
      case Stability::degenerate_minimum:
        return degenerate + prose("stable:") + leading_term(*verdict.leading, point);
      case Stability::decaying:
        return degenerate + prose("stable: all poles have negative real parts");
      case Stability::unstable: {
        std::string rates;
        for (const double rate : verdict.growth_rates) {
          rates += fmt::format("{}{:.6g} 1/s", rates.empty() ? "" : ", ", rate);
        }
        return prose("unstable: " + rates);
      }
      case Stability::open:
        return degenerate + prose("not decided by the linear part");
    }
    return {};
  }

  /// "q - q0", "q + 0.3"
  Printed deviation(const CoordinateAtRest& at, const Printed& symbol) {
    if (cln::zerop(at.value)) return symbol;
    const bool is_negative = cln::minusp(at.value);
    const Value form = is_negative ? Arithmetic(forms_.algebra).negate(at.form) : at.form;
    return sum(symbol, read(form).value_or(number(cln::abs(at.value))), !is_negative);
  }

  /// "V0 - T0 = 9/8 m R theta^4 + … has a strict minimum, of order 4"
  Printed leading_term(const LeadingTerm& term, const RestPoint& point) {
    const Printed shift =
        deviation(point.coordinates[term.coordinate], symbols_.q[term.coordinate]);
    const Printed coefficient = read(term.coefficient).value_or(Printed{"c", "c"});
    const Printed first = product_with_power(coefficient, shift, term.order);
    const Printed expanded =
        equation(rest_energy(), {first.text + " + ...", first.latex + " + \\text{…}"});
    return expanded + prose(fmt::format("has a strict minimum, of order {}", term.order));
  }

  const CheckedModel& checked_;
  const Model& model_;
  const Equilibria& equilibria_;
  ClosedForms forms_;  ///< a copy: reading forms adds to their algebra
  LeafValues<Printed> symbols_;
  std::optional<Fraction> stiffness_ = {};
  AnalysisPage page_ = {};
};

}  // namespace

Sheet equilibria_sheet(const CheckedModel& checked, const Equilibria& equilibria) {
  return sheet_of(EquilibriaPage(checked, equilibria)());
}

std::string equilibria_text(const CheckedModel& checked, const Equilibria& equilibria) {
  return text_of(EquilibriaPage(checked, equilibria)());
}

}  // namespace elgen
