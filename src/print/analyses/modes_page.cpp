// modes_page: small motions about a point: M and K, in closed form if possible; w^2 as a formula
// for blocks of one or two coordinates; then numbers.
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analyse/formulas.hpp"
#include "analyse/frequencies.hpp"
#include "elgen/analysis_pages.hpp"
#include "elgen/leaf_names.hpp"
#include "model/output_units.hpp"
#include "model/symbols.hpp"
#include "print/analyses/page_parts.hpp"

namespace elgen {
namespace {

const char* stability_text(Stability kind) {
  if (is_stable(kind)) return "(stable)";
  return kind == Stability::unstable ? "(unstable)" : "(not decided by the linearisation)";
}

/// "pi", "l + m*g/k = 0.7", "+-0.697569"
Formula coordinate_formula(const PageForms& known, const RestCoordinate& at, bool is_pair) {
  if (at.inverse_argument && is_pair) return plus_minus(six_digit_formula(cln::abs(at.value)));
  std::optional<Formula> form =
      at.inverse_argument ? std::nullopt : known.to_formula(at.closed_form);
  if (!form) return six_digit_formula(at.value);
  if (cln::zerop(at.value) || !contains_leaves(known.forms.algebra, *at.closed_form)) return *form;
  return relation(std::move(*form), six_digit_formula(at.value));
}

/// "theta1 = 0, theta2 = 0 (stable)"
Formula point_title(const PageForms& known, const std::vector<cln::cl_R>& inputs,
                    const RestPoint& point, bool is_pair) {
  Formulas values;
  for (std::size_t i = 0; i < point.coordinates.size(); ++i) {
    values.push_back(
        relation(known.symbols.q[i], coordinate_formula(known, point.coordinates[i], is_pair)));
  }
  for (std::size_t i = 0; i < known.symbols.u.size(); ++i) {
    values.push_back(relation(known.symbols.u[i], six_digit_formula(inputs[i])));
  }
  return row_of({list_of(std::move(values)), prose(stability_text(point.stability.kind))});
}

/// Puts a sum into brackets.
Formula bracket_sum(Formula x) {
  return x.kind == FormulaKind::sum ? group(std::move(x)) : std::move(x);
}

/// An equation for a row-major matrix with `columns` columns.
template <class Number>
PageEquation matrix_equation(std::string_view left, const std::vector<Number>& numbers,
                             std::size_t columns) {
  PageEquation equation{latex_formula(left), static_cast<std::uint32_t>(numbers.size() / columns),
                        static_cast<std::uint32_t>(columns)};
  for (const Number& number : numbers) equation.entries.push_back(six_digit_formula(number));
  return equation;
}

/// A matrix whose entries are forms if they are readable, else numbers.
PageEquation closed_matrix(const PageForms& known, std::string_view left,
                           const std::vector<Fraction>& forms,
                           const std::vector<cln::cl_R>& numbers) {
  PageEquation matrix = matrix_equation(left, numbers, known.model.velocities.size());
  for (std::size_t i = 0; i < forms.size(); ++i) {
    // A matrix of a long chain is mostly 0, and reading a form takes time, so zeros are skipped.
    if (forms[i].numerator.empty()) continue;
    if (auto form = known.to_formula(forms[i])) matrix.entries[i] = std::move(*form);
  }
  return matrix;
}

/// "M eta'' + D eta' + K eta = B du"
Formula linear_equation(Formula mass, bool is_damped, bool has_inputs) {
  return relation(row_of({bracket_sum(std::move(mass)),
                          is_damped ? latex_symbol("eta'' + D eta' + K eta",
                                                   "\\ddot{\\eta} + D \\dot{\\eta} + K \\eta")
                                    : latex_symbol("eta'' + K eta", "\\ddot{\\eta} + K \\eta")}),
                  has_inputs ? latex_symbol("B du", "B {\\delta} u") : number_formula(0));
}

PageSection equations_section(const PageForms& known, const RestMatrices& forms,
                              const RestPoint& point) {
  const std::size_t inputs = known.model.inputs.size();
  const bool is_damped =
      std::ranges::any_of(point.damping, [](const cln::cl_R& entry) { return !cln::zerop(entry); });
  PageEquation mass = closed_matrix(known, "M", forms.mass, point.mass);
  PageEquation stiffness = closed_matrix(known, "K", forms.stiffness, point.stiffness);
  PageSection section{.is_side_by_side = true};
  if (mass.entries.size() == 1 && !is_damped && inputs == 0) {
    section.lines = {row_of({linear_equation(mass.entries[0], false, false), prose(","),
                             wide_blank(), relation(stiffness.left, stiffness.entries[0])})};
    return section;
  }
  section.lines = {linear_equation(mass.left, is_damped, inputs > 0)};
  section.equations.push_back(std::move(mass));
  if (is_damped) section.equations.push_back(closed_matrix(known, "D", {}, point.damping));
  section.equations.push_back(std::move(stiffness));
  if (inputs > 0) section.equations.push_back(matrix_equation("B", point.input_matrix, inputs));
  return section;
}

/// "-0.5 +- 2 i": a pole and its conjugate; "-0.5" if `imaginary` is 0.
Formula complex_number(double real, double imaginary) {
  if (imaginary == 0) return six_digit_formula(real);
  const Formula size = six_digit_formula(imaginary);
  const Formula unit = latex_formula("i");
  if (real == 0) return row_of({plus_minus(size), unit});
  return row_of({six_digit_formula(real), latex_symbol("+-", "\\pm"), size, unit});
}

/// Adds the poles: on one line if the point has normal modes, otherwise in a table with damping
/// ratios and time constants. Adds the rank of controllability if the model has inputs.
void add_poles(Page& page, const PageForms& known, const LinearMotions& motions) {
  double largest = 0;
  for (const auto& pole : motions.poles) largest = std::max(largest, std::abs(pole));
  PageTable table{{prose("pole [1/s]"), prose("damping ratio"), prose("time constant [s]")}};
  PageTable lines{Formulas(2)};
  Formulas list;
  for (const std::complex<double>& pole : motions.poles) {
    // Poles are computed in doubles: a real or imaginary part below 1e-9 of the largest pole is
    // rounding error.
    const auto shown = [&](double x) { return std::abs(x) < 1e-9 * largest ? 0.0 : x; };
    const double real = shown(pole.real());
    const double imaginary = shown(pole.imag());
    if (imaginary < 0) continue;
    list.push_back(complex_number(real, imaginary));
    table.cells.push_back(list.back());
    table.cells.push_back(imaginary > 0 ? six_digit_formula(-real / std::hypot(real, imaginary))
                                        : Formula{});
    table.cells.push_back(real != 0 ? six_digit_formula(1 / std::abs(real)) : Formula{});
  }
  if (!motions.modes.empty()) {
    lines.cells = {prose("poles [1/s]"), list_of(std::move(list))};
  } else {
    page.sections.push_back({.table = std::move(table)});
  }
  if (!known.symbols.u.empty()) {
    const std::size_t states = 2 * known.symbols.v.size();
    lines.cells.push_back(prose("inputs"));
    lines.cells.push_back(
        row_of({enumeration(known.symbols.u),
                prose(fmt::format(": {}controllable (rank {} of {})",
                                  motions.controllable_rank == states ? "" : "not ",
                                  motions.controllable_rank, states))}));
  }
  if (!lines.cells.empty()) page.sections.push_back({.table = std::move(lines)});
}

/// The matrices of d(dx)/dt = A dx + B du, x = (q, v), as numbers.
PageSection state_matrix_section(const Model& model, const LinearMotions& motions) {
  PageSection section{.is_side_by_side = true};
  section.equations.push_back(matrix_equation("A", motions.a, 2 * model.velocities.size()));
  if (model.inputs.empty()) {
    section.lines = {
        latex_symbol("dx/dt = A x, x = (q, v)", "\\dot{x} = A x \\text{, } x = (q, v)")};
    return section;
  }
  section.lines = {latex_symbol("dx/dt = A x + B du, x = (q, v)",
                                "\\dot{x} = A x + B {\\delta} u \\text{, } x = (q, v)")};
  section.equations.push_back(matrix_equation("B", motions.b, model.inputs.size()));
  return section;
}

/// factor (middle -+ root)/divisor: both w^2 of a block; `middle` if `square` has no root.
std::optional<Formula> frequency_formula(const PageForms& known, const SquaredFrequency& square) {
  std::optional<Formula> middle = known.to_formula(square.middle);
  if (!square.root) return middle;
  std::optional<Formula> root = known.to_formula(square.root);
  std::optional<Formula> factor = known.to_formula(square.factor);
  std::optional<Formula> divisor = known.to_formula(square.divisor);
  if (!middle || !root || !factor || !divisor) return std::nullopt;
  const auto is_one = [](const Formula& x) { return text_of(x) == "1"; };
  Formula pair = row_of({square.middle.numerator.empty() ? Formula{} : std::move(*middle),
                         latex_symbol("-+", "\\mp"), bracket_sum(std::move(*root))});
  if (!is_one(*factor)) pair = product_of({std::move(*factor), std::move(pair)});
  return is_one(*divisor) ? pair : quotient_of(std::move(pair), std::move(*divisor));
}

void add_frequencies(Page& page, PageForms& known, const RestMatrices& forms) {
  PageSection section;
  for (const SquaredFrequency& square :
       squared_frequencies(known.forms, forms, known.model.velocities.size())) {
    std::optional<Formula> formula = frequency_formula(known, square);
    if (!formula) continue;
    section.equations.push_back({latex_symbol("w^2", "\\omega^2"), 1, 1, {std::move(*formula)}});
  }
  if (!section.equations.empty()) page.sections.push_back(std::move(section));
}

void add_modes(Page& page, const PageForms& known, const std::vector<NormalMode>& modes) {
  PageTable table{
      {prose("mode"), latex_symbol("w^2 [1/s^2]", "\\omega^2 \\text{ [1/s²]}"), prose("f [Hz]")}};
  for (const Velocity& velocity : known.model.velocities) {
    const bool turns = velocity.rotation.has_value();
    table.heads.push_back(turns ? prose(velocity.name) : known.symbols.q[velocity.coordinate]);
  }
  std::vector<std::size_t> equal;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const double square = to_double(modes[i].omega_squared);
    const double rate = std::sqrt(std::abs(square));
    table.cells.push_back(six_digit_formula(static_cast<double>(i + 1)));
    table.cells.push_back(six_digit_formula(square));
    table.cells.push_back(square < 0 ? prose(fmt::format("grows at {:.6g} 1/s", rate))
                                     : six_digit_formula(rate / (2 * std::numbers::pi)));
    for (const double component : modes[i].shape)
      table.cells.push_back(six_digit_formula(component));
    if (modes[i].multiplicity > 1) equal.push_back(i + 1);
  }
  page.sections.push_back({.table = std::move(table)});
  if (equal.empty()) return;
  page.sections.push_back(
      {.lines = {prose(fmt::format("modes {} have equal frequencies: any linear combination of "
                                   "their shapes is a mode shape",
                                   fmt::join(equal, ", ")))}});
}

/// True for one mode and one cyclic rate if w^2 of the mode equals the rate squared to 40 digits.
bool have_equal_periods(const std::vector<NormalMode>& modes, const std::vector<cln::cl_R>& rates) {
  if (modes.size() != 1 || rates.size() != 1) return false;
  const cln::cl_R& square = modes[0].omega_squared;
  return square > 0 && is_near(Real(rates[0] * rates[0] / square), Real(1));
}

/// "steady motion: dot(phi) = 0.578704 rad/s": the rates of the cyclic coordinates that the scene
/// removed.
void add_steady_motion(Page& page, const Model& model, const LinearMotions& motions) {
  const Model& whole = unreduced_model(model);
  const OracleValues rates =
      oracle_values(model, {.kind = OutputKind::cyclic_rates}, motions.point.state);
  if (!rates) return;
  const LeafValues<Formula> symbols = ModelSymbols(whole).leaf_symbols();
  Formulas values;
  for (std::size_t i = 0; i < rates->size(); ++i) {
    const std::uint32_t velocity = model.reduction.cyclic[i].velocity;
    Formula unit = prose(velocity_unit_text(whole, whole.velocities[velocity]));
    values.push_back(
        relation(symbols.v[velocity], row_of({six_digit_formula((*rates)[i]), std::move(unit)})));
  }
  const bool turns = is_angle(whole.coordinates[model.reduction.cyclic[0].coordinate]);
  const bool has_closed_orbits = turns && have_equal_periods(motions.modes, *rates);
  page.sections.push_back(
      {.lines = {row_of(
           {prose("steady motion:"), list_of(std::move(values)),
            prose(has_closed_orbits ? ", with the period of the mode: the orbits close" : "")})}});
}

bool is_free(const Model& model, const LinearMotions& motions) {
  return !motions.modes.empty() && model.inputs.empty();
}

void add_motions(Page& page, const Model& model, PageForms& known, const LinearMotions& motions) {
  const RestMatrices forms = rest_matrices(model, known.forms, motions.point);
  if (!is_free(model, motions)) add_poles(page, known, motions);
  page.sections.push_back(equations_section(known, forms, motions.point));
  if (!motions.modes.empty()) {
    add_frequencies(page, known, forms);
    add_modes(page, known, motions.modes);
  }
  if (!is_free(model, motions)) page.sections.push_back(state_matrix_section(model, motions));
  if (has_routhian(model)) add_steady_motion(page, model, motions);
}

}  // namespace

Page modes_page(const CheckedModel& checked, const Modes& modes) {
  PageForms known(checked.model, modes.forms);
  const std::vector<LinearMotions>& all = modes.motions;
  Page page;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_pair =
        i + 1 < all.size() && is_mirrored(known.forms, all[i].point, all[i + 1].point);
    const char* const subject =
        is_free(checked.model, all[i]) ? "normal modes at" : "linearised equations at";
    Formula title = row_of({analysis_title(checked, subject),
                            point_title(known, modes.inputs, all[i].point, is_pair)});
    if (page.sections.empty()) {
      page.title = std::move(title);
    } else {
      page.sections.push_back({.lines = {std::move(title)}});
    }
    add_motions(page, checked.model, known, all[i]);
    if (is_pair) ++i;
  }
  return page;
}

}  // namespace elgen
