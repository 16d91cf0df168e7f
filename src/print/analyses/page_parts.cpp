// page_parts: closed forms, numbers and titles. The title of a scene with [routh] states the
// momenta that the scene holds.
#include "print/analyses/page_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analyse/searched_range.hpp"
#include "elgen/typeset.hpp"
#include "model/symbols.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

/// "N m s", "N s": the unit of a momentum, as the unit of a force times s if possible.
std::string unit_of_momentum(const Parameter& momentum) {
  if (!momentum.unit) return {};
  std::string text = force_unit_text(*momentum.unit / *find_unit("s")) + " s";
  if (text.find('/') != std::string::npos) text = to_string(*momentum.unit);
  std::ranges::replace(text, '*', ' ');
  return text;
}

Formula held_momenta(const CheckedModel& checked) {
  const LeafValues<Formula> symbols = ModelSymbols(checked.model).leaf_symbols();
  const State nominal = nominal_state(checked.model, checked.scene);
  Formulas momenta;
  for (const CyclicCoordinate& cyclic : checked.model.reduction.cyclic) {
    Formula unit = prose(unit_of_momentum(checked.model.parameters[cyclic.parameter]));
    momenta.push_back(relation(
        symbols.parameters[cyclic.parameter],
        row_of({six_digit_formula(nominal.parameters[cyclic.parameter]), std::move(unit)})));
  }
  return list_of(std::move(momenta));
}

}  // namespace

/// Prints a form as a function of one entry, so that the formula looks like an entry of an output.
std::optional<Formula> readable_formula(const Model& model, const Algebra& algebra,
                                        const std::optional<Fraction>& form) {
  if (!form) return std::nullopt;
  LeafNames leaves = leaf_names(model);
  name_optional_leaves(Opcode::momentum, leaves);
  leaves.E = energy_name(model);
  Program program{leaves};
  Function function = typeset_value(model, algebra, *form, program);
  if (function.fields.empty()) return std::nullopt;
  program.functions = {function};
  program.readable = {std::move(function)};
  return first_entry_formula(model, program);
}

PageForms::PageForms(const Model& page_model, const ClosedForms& found)
    : model(page_model), forms(found), symbols(ModelSymbols(page_model).leaf_symbols()) {}

Formula latex_symbol(std::string text, std::string_view latex) {
  return symbol_formula(std::move(text), read_latex(latex));
}

Formula wide_blank() { return latex_symbol(" ", "\\quad"); }

Formula six_digit_formula(const cln::cl_R& value) {
  // Newton's method ends with a relative step of 1e-58, so numbers below 1e-40 are noise.
  static const cln::cl_R noise = power_of_ten(-40);
  return digits_formula(cln::abs(value) < noise ? "0" : short_number_text(value));
}

Formula six_digit_formula(double value) {
  return digits_formula(value == 0 ? "0" : fmt::format("{:.6g}", value));
}

Formula analysis_title(const CheckedModel& checked, const std::string& subject) {
  const std::string title = page_title(checked.model);
  if (!has_routhian(checked.model)) return prose(fmt::format("{}: {}", title, subject));
  return row_of({prose(title + ","), held_momenta(checked), prose(": " + subject)});
}

Formulas searched_ranges(const PageForms& known, const Equilibria& equilibria) {
  Formulas ranges;
  for (std::size_t i = 0; i < known.model.coordinates.size(); ++i) {
    const Interval* const range = searched_range(known.model.coordinates[i], equilibria.kinds[i]);
    if (range == nullptr) continue;
    ranges.push_back(
        row_of({known.symbols.q[i], prose(fmt::format("in [{}, {}]", short_number_text(range->low),
                                                      short_number_text(range->high)))}));
  }
  return ranges;
}

bool is_mirrored(ClosedForms& forms, const RestPoint& here, const RestPoint& next) {
  if (here.stability.kind != next.stability.kind) return false;
  bool differs = false;
  Arithmetic arithmetic(forms.algebra);
  for (std::size_t k = 0; k < here.coordinates.size(); ++k) {
    const RestCoordinate& x = here.coordinates[k];
    const RestCoordinate& y = next.coordinates[k];
    if (x.is_arbitrary && y.is_arbitrary) continue;
    if (!x.closed_form || !y.closed_form) return false;
    if (is_proved_equal(forms, *x.closed_form, *y.closed_form)) continue;
    const OptionalFraction turned = arithmetic.negate(*y.closed_form);
    if (!x.inverse_argument || !is_proved_equal(forms, *x.closed_form, *turned)) return false;
    differs = true;
  }
  return differs;
}

}  // namespace elgen
