// The page of small motions: M and K in closed form where the point has one, w^2 by formulas for
// blocks of one or two coordinates, then numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analyse/exact_roots.hpp"
#include "analyse/frequencies.hpp"
#include "analyse/page.hpp"
#include "elgen/leaf_names.hpp"
#include "model/output_units.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

class ModesPage {
 public:
  ModesPage(const CheckedModel& checked, const Equilibria& equilibria)
      : checked_(checked),
        model_(checked.model),
        equilibria_(equilibria),
        forms_(equilibria.forms),
        symbols_(symbols_of(checked.model)) {}

  AnalysisPage operator()(const std::vector<LinearMotions>& all) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool is_pair =
          i + 1 < all.size() && is_mirrored(forms_, all[i].point, all[i + 1].point);
      add(all[i], is_pair);
      if (is_pair) ++i;
    }
    return std::move(page_);
  }

 private:
  [[nodiscard]] std::size_t size() const { return model_.velocities.size(); }
  [[nodiscard]] bool has_inputs() const { return !model_.inputs.empty(); }

  [[nodiscard]] std::optional<Printed> read(const std::optional<Fraction>& form) const {
    return printed(model_, forms_.algebra, form);
  }

  void add(const LinearMotions& motions, bool is_pair) {
    const bool is_free = !motions.modes.empty() && !has_inputs();
    const std::string subject = is_free ? "normal modes at" : "linear equations at";
    const Printed title = titled(checked_, subject) + place(motions.point, is_pair);
    if (page_.parts.empty()) {
      page_.title = title;
    } else {
      page_.parts.push_back({{title}});
    }
    find_forms(motions.point);
    if (!is_free) add_poles(motions);
    add_equations(motions);
    if (!motions.modes.empty()) {
      if (!mass_.empty() && !stiffness_.empty()) add_frequencies();
      add_modes(motions);
    }
    if (!is_free) add_state_matrices(motions);
    if (has_routhian(model_)) add_steady_motion(motions);
  }

  /// "θ₁ = 0, θ₂ = 0 (stable)"
  Printed place(const RestPoint& point, bool is_pair) {
    std::vector<Printed> values;
    for (std::size_t i = 0; i < point.coordinates.size(); ++i) {
      const CoordinateAtRest& coordinate = point.coordinates[i];
      values.push_back(equation(symbols_.q[i], value_of_coordinate(coordinate, is_pair)));
    }
    for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
      values.push_back(equation(symbols_.u[i], number(equilibria_.inputs[i])));
    }
    return with_commas(values) + prose(verdict(point.stability.kind));
  }

  /// "π", "l + m g/k = 0.7", "±0.697569"
  Printed value_of_coordinate(const CoordinateAtRest& at, bool is_pair) {
    if (at.sinusoid && is_pair) {
      const Printed size = number(cln::abs(at.value));
      return {"+-" + size.text, "\\pm " + size.latex};
    }
    const std::optional<Printed> form = at.sinusoid ? std::nullopt : read(at.form);
    if (!form) return number(at.value);
    if (cln::zerop(at.value) || !holds_leaves(forms_.algebra, *at.form)) return *form;
    return equation(*form, number(at.value));
  }

  static const char* verdict(Stability kind) {
    if (is_stable(kind)) return "(stable)";
    return kind == Stability::unstable ? "(unstable)" : "(not decided by the linear part)";
  }

  /// M and K at the point in closed form, where all of them are known.
  void find_forms(const RestPoint& point) {
    mass_.clear();
    stiffness_.clear();
    std::vector<std::uint32_t> coordinates;
    std::vector<CoordinateAtRest> values;
    for (std::uint32_t i = 0; i < point.coordinates.size(); ++i) {
      if (!point.coordinates[i].form) continue;
      coordinates.push_back(i);
      values.push_back(point.coordinates[i]);
    }
    const Replacements place = replacements_of(coordinates, values);
    const std::size_t n = size();
    const ClosedField rows = forms_.functions[0].fields[0];
    const ClosedField masses = forms_.functions[1].fields[0];
    for (std::size_t i = 0; i < n * n; ++i) {
      const auto& row = rows.entries[i / n];
      const std::uint32_t coordinate = model_.velocities[i % n].coordinate;
      const auto slope =
          row && model_.rotations.empty()
              ? partial_derivative(forms_, *row, coordinate, point.coordinates.size())
              : std::nullopt;
      const Value k = substituted(forms_.algebra, slope, place);
      const Value m = substituted(forms_.algebra, masses.entries[i], place);
      if (is_form_at_place(m)) mass_.push_back(*m);
      if (is_form_at_place(k)) stiffness_.push_back(*k);
    }
    if (mass_.size() < n * n) mass_.clear();
    if (stiffness_.size() < n * n) stiffness_.clear();
  }

  [[nodiscard]] bool is_form_at_place(const Value& form) const {
    return form && !holds_coordinate(forms_.algebra, *form);
  }

  PageMatrix matrix(const Printed& left, const std::vector<Fraction>& forms,
                    const std::vector<cln::cl_R>& numbers, std::size_t columns) {
    PageMatrix result{left,
                      static_cast<std::uint32_t>(numbers.size() / columns),
                      static_cast<std::uint32_t>(columns),
                      {}};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      // Most entries of a long chain are 0, and a form takes the longer to read the more there are.
      const bool is_number = forms.empty() || forms[i].numerator.empty();
      const std::optional<Printed> form = is_number ? std::nullopt : read(forms[i]);
      result.entries.push_back(form ? *form : number(numbers[i]));
    }
    return result;
  }

  void add_equations(const LinearMotions& motions) {
    const RestPoint& point = motions.point;
    const bool is_damped = std::ranges::any_of(
        point.damping, [](const cln::cl_R& entry) { return !cln::zerop(entry); });
    PagePart& part = page_.parts.emplace_back();
    part.is_row = true;
    const PageMatrix mass = matrix({"M", "M"}, mass_, point.mass, size());
    const PageMatrix stiffness = matrix({"K", "K"}, stiffness_, point.stiffness, size());
    const bool is_one_line = size() == 1 && !is_damped && !has_inputs();
    const Printed factor = is_one_line ? at_least(mass.entries[0], Binding::negation) : mass.left;
    part.lines.push_back(
        {fmt::format("{} eta''{} + K eta = {}", factor.text, is_damped ? " + D eta'" : "",
                     has_inputs() ? "B du" : "0"),
         fmt::format("{} \\ddot{{\\eta}}{} + K \\eta = {}", factor.latex,
                     is_damped ? " + D \\dot{\\eta}" : "", has_inputs() ? "B \\delta u" : "0")});
    if (is_one_line) {
      part.lines[0].text += fmt::format(",   K = {}", stiffness.entries[0].text);
      part.lines[0].latex += fmt::format(",\\quad K = {}", stiffness.entries[0].latex);
      return;
    }
    part.matrices.push_back(mass);
    if (is_damped) part.matrices.push_back(matrix({"D", "D"}, {}, point.damping, size()));
    part.matrices.push_back(stiffness);
    if (has_inputs()) {
      part.matrices.push_back(matrix({"B", "B"}, {}, point.input_matrix, model_.inputs.size()));
    }
  }

  /// In one line where nothing is damped, else each with its damping ratio and time constant.
  void add_poles(const LinearMotions& motions) {
    double largest = 0;
    for (const auto& pole : motions.poles) largest = std::max(largest, std::abs(pole));
    PageTable table;
    std::vector<Printed> list;
    for (const std::complex<double>& pole : motions.poles) {
      // Poles come from doubles: real and imaginary parts below 1e-9 of the largest are rounding.
      const auto shown = [&](double x) { return std::abs(x) < 1e-9 * largest ? 0.0 : x; };
      const double real = shown(pole.real());
      const double imaginary = shown(pole.imag());
      if (imaginary < 0) continue;
      const Printed text = complex_number(real, imaginary);
      list.push_back(text);
      table.cells.push_back(text);
      table.cells.push_back(imaginary > 0 ? number(-real / std::hypot(real, imaginary))
                                          : Printed{});
      table.cells.push_back(real != 0 ? number(1 / std::abs(real)) : Printed{});
    }
    PageTable lines{{Printed{}, Printed{}}, {}};
    if (!motions.modes.empty()) {
      lines.cells = {prose("poles [1/s]"), with_commas(list)};
    } else {
      table.heads = {prose("pole [1/s]"), prose("damping ratio"), prose("time constant [s]")};
      page_.parts.push_back({{}, {}, std::move(table)});
    }
    if (has_inputs()) {
      const std::size_t states = 2 * size();
      const char* const reach = motions.controllable == states ? "" : "not ";
      lines.cells.push_back(prose("inputs"));
      lines.cells.push_back(listed({symbols_.u.begin(), symbols_.u.end()}) +
                            prose(fmt::format(": {}controllable (rank {} of {})", reach,
                                              motions.controllable, states)));
    }
    if (!lines.cells.empty()) page_.parts.push_back({{}, {}, std::move(lines)});
  }

  static Printed complex_number(double real, double imaginary) {
    if (imaginary == 0) return number(real);
    const Printed size = number(imaginary);
    if (real == 0) return {"+-" + size.text + " i", "\\pm " + size.latex + " i"};
    const Printed part = number(real);
    return {fmt::format("{} +- {} i", part.text, size.text),
            fmt::format("{} \\pm {} i", part.latex, size.latex)};
  }

  /// Numbers of d(dx)/dt = A dx + B du, x = (q, v).
  void add_state_matrices(const LinearMotions& motions) {
    PagePart& part = page_.parts.emplace_back();
    part.is_row = true;
    const auto rows = [](const std::vector<double>& values, const char* left, std::size_t columns) {
      PageMatrix result{{left, left},
                        static_cast<std::uint32_t>(values.size() / columns),
                        static_cast<std::uint32_t>(columns),
                        {}};
      for (const double value : values) result.entries.push_back(number(value));
      return result;
    };
    part.lines.push_back(
        {"dx/dt = A x + B du, x = (q, v)", "\\dot{x} = A x + B \\delta u \\text{, } x = (q, v)"});
    if (!has_inputs())
      part.lines = {{"dx/dt = A x, x = (q, v)", "\\dot{x} = A x \\text{, } x = (q, v)"}};
    part.matrices.push_back(rows(motions.a, "A", 2 * size()));
    if (has_inputs()) part.matrices.push_back(rows(motions.b, "B", model_.inputs.size()));
  }

  void add_frequencies() {
    PagePart part = frequency_formulas(model_, forms_, mass_, stiffness_);
    if (!part.matrices.empty()) page_.parts.push_back(std::move(part));
  }

  void add_modes(const LinearMotions& motions) {
    PagePart& part = page_.parts.emplace_back();
    PageTable& table = part.table;
    table.heads = {prose("mode"), {"w^2 [1/s^2]", "\\omega^{2} \\text{ [1/s²]}"}, prose("f [Hz]")};
    for (const Velocity& velocity : model_.velocities) {
      const bool turns = velocity.rotation.has_value();
      table.heads.push_back(turns ? prose(velocity.name) : symbols_.q[velocity.coordinate]);
    }
    std::vector<std::string> equal;
    for (std::size_t i = 0; i < motions.modes.size(); ++i) {
      const NormalMode& mode = motions.modes[i];
      const double square = ScalarTraits<double>::from_real(mode.omega_squared);
      const double rate = std::sqrt(std::abs(square));
      table.cells.push_back(number(static_cast<double>(i + 1)));
      table.cells.push_back(number(square));
      table.cells.push_back(square < 0 ? prose(fmt::format("grows at {:.6g} 1/s", rate))
                                       : number(rate / (2 * std::numbers::pi)));
      for (const double component : mode.shape) table.cells.push_back(number(component));
      if (mode.multiplicity > 1) equal.push_back(std::to_string(i + 1));
    }
    if (!equal.empty()) {
      page_.parts.push_back({{prose(
          fmt::format("the shapes of modes {} of one frequency span a space: any of their sums "
                      "is one",
                      fmt::join(equal, ", ")))}});
    }
  }

  /// "steady motion: dot(phi) = 0.578704 rad/s": the rates of what the scene took out.
  void add_steady_motion(const LinearMotions& motions) {
    const Model& whole = whole_of(model_);
    const OracleValues rates =
        oracle_values(model_, {.kind = OutputKind::cyclic_rates}, motions.point.state);
    if (!rates) return;
    const LeafValues<Printed> symbols = symbols_of(whole);
    Printed line = prose("steady motion:");
    for (std::size_t i = 0; i < rates->size(); ++i) {
      const std::uint32_t velocity = model_.variant.cyclic[i].velocity;
      const Printed value = number((*rates)[i]);
      const std::string name = velocity_unit(whole, whole.velocities[velocity]);
      const std::string unit = name.empty() ? "" : " " + name;
      const char* const comma = i == 0 ? " " : ", ";
      line.text += fmt::format("{}{} = {}{}", comma, leaf_text(whole, Opcode::velocity, velocity),
                               value.text, unit);
      line.latex += fmt::format("{}{} = {} \\text{{{}}}", comma, symbols.v[velocity].latex,
                                value.latex, unit);
    }
    const bool turns = is_angle(whole.coordinates[model_.variant.cyclic[0].coordinate]);
    if (turns && have_one_period(motions.modes, *rates)) {
      const char* const closed = ", of the same period: orbits close";
      line = {line.text + closed, line.latex + prose(closed).latex};
    }
    page_.parts.push_back({{line}});
  }

  /// In 64 digits.
  static bool have_one_period(const std::vector<NormalMode>& modes,
                              const std::vector<cln::cl_R>& rates) {
    if (modes.size() != 1 || rates.size() != 1) return false;
    const cln::cl_R& square = modes[0].omega_squared;
    return square > 0 && is_near(Real(rates[0] * rates[0] / square), Real(1));
  }

  const CheckedModel& checked_;
  const Model& model_;
  const Equilibria& equilibria_;
  ClosedForms forms_;  ///< a copy: reading forms adds to their algebra
  LeafValues<Printed> symbols_;
  std::vector<Fraction> mass_ = {};
  std::vector<Fraction> stiffness_ = {};
  AnalysisPage page_ = {};
};

}  // namespace

Sheet modes_sheet(const CheckedModel& checked, const Equilibria& equilibria,
                  const std::vector<LinearMotions>& all) {
  return sheet_of(ModesPage(checked, equilibria)(all));
}

std::string modes_text(const CheckedModel& checked, const Equilibria& equilibria,
                       const std::vector<LinearMotions>& all) {
  return text_of(ModesPage(checked, equilibria)(all));
}

}  // namespace elgen
