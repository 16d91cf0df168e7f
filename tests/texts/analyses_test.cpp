// The formulas of equilibria and modes in the output of `--as text`: the parser of models reads
// each formula. The formula must have the value that the analysis found. Inputs are all
// committed models and 200 random models. Six printed digits suffice to notice a missing bracket.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <utility>

#include "analyse/formulas.hpp"
#include "elgen/analysis_pages.hpp"
#include "elgen/pipeline.hpp"
#include "numbers/random.hpp"
#include "program/evaluate/subject.hpp"
#include "support/inputs.hpp"
#include "texts/real_rules.hpp"
#include "texts/written_equations.hpp"

namespace elgen::test {
namespace {

using NamedNumbers = std::map<std::string, Real>;

/// Rules of fold_expression that replace each name by its number in `names`.
struct NumberRules : RealRules {
  const NamedNumbers& names;

  Real named(const std::string& name) const {
    const auto found = names.find(name);
    return found == names.end() ? fail(name) : found->second;
  }
  static Real fail(const std::string&) { return Real::undefined(); }
};

NamedNumbers names_at(const Model& model, const State& state) {
  NamedNumbers names{{"pi", Real(cln::pi(Real::format()))}};
  for_each_leaf(
      [&](Opcode kind, std::uint32_t number, const cln::cl_R& value) {
        if (kind != Opcode::parameter && kind != Opcode::coordinate) return;
        names[leaf_text(model, kind, number)] = Real(value);
      },
      state);
  return names;
}

/// Compares printed formulas with their numbers, and counts the comparisons.
class FormulaReader {
 public:
  explicit FormulaReader(const Model& model) : model_(model) {}

  [[nodiscard]] std::size_t count() const { return count_; }

  void expect(const std::string& text, const NamedNumbers& names, const cln::cl_R& value) {
    ++count_;
    const Real found = number_of(text, names);
    INFO(text);
    REQUIRE(found.is_defined());
    // Numbers are printed with six digits.
    const cln::cl_R tolerance = (cln::abs(value) + 1) / 100'000;
    CHECK(cln::abs(found.value() - value) <= tolerance);
  }

  void read_modes(const std::string& page, const std::vector<LinearMotions>& all) {
    std::size_t next = 0;
    const LinearMotions* motions = nullptr;
    for (const std::string& line : split_lines(page)) {
      const bool is_title =
          mentions(line, "normal modes at ") || mentions(line, "linearised equations at ");
      if (!is_title && motions != nullptr) read_motion_line(line, *motions);
      if (!is_title) continue;
      motions = &all.at(next);
      next += mentions(line, "+-") ? 2 : 1;  // one point of a mirrored pair is printed
    }
  }

  void read_equilibria(const std::string& page, const std::vector<RestPoint>& points) {
    std::size_t at = 0;
    for (const std::string& line : split_lines(page)) {
      const bool is_formula = line.starts_with("  K = ");
      for (std::size_t i = 0; is_formula && i < points.size(); ++i) {
        expect(line.substr(6), names_at(model_, points[i].state), points[i].stiffness[0]);
      }
      if (is_formula || at >= points.size()) continue;
      for (const std::string& cell : cells_of(line)) read_cell(cell, points[at]);
      const bool is_row = mentions(line, "stable:") || mentions(line, "not decided by");
      if (is_row) at += mentions(line, "+-") ? 2 : 1;
    }
  }

  void read_leading_term(const std::string& cell, const RestPoint& point, const Equilibria& found) {
    const std::size_t end = cell.find(" + ... has");
    if (end == std::string::npos) return;
    const LeadingTerm& term = *point.stability.leading;
    const std::size_t start = cell.rfind(" = ", end) + 3;
    const Real coefficient =
        evaluate_form(found.forms.algebra, term.coefficient, arguments_at<Real>(point.state));
    REQUIRE(coefficient.is_defined());
    NamedNumbers names = names_at(model_, point.state);
    const std::string q = leaf_text(model_, Opcode::coordinate, term.coordinate);
    for (const int shift : {1, 2}) {
      names[q] = Real(point.state.q[term.coordinate] + shift);
      expect(cell.substr(start, end - start), names,
             coefficient.value() * cln::expt(cln::cl_R(shift), static_cast<int>(term.order)));
    }
  }

 private:
  [[nodiscard]] static Real number_of(const std::string& text, const NamedNumbers& names) {
    const auto syntax = parse_expression(make_source("", text), written_limits());
    return syntax ? fold_expression(*syntax, NumberRules{{}, names}) : Real::undefined();
  }

  /// The cells of a line, separated by at least three blanks.
  static std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::size_t start = line.find_first_not_of(' ');
    while (start != std::string::npos) {
      const std::size_t end = std::min(line.find("   ", start), line.size());
      cells.push_back(line.substr(start, end - start));
      start = line.find_first_not_of(' ', end);
    }
    return cells;
  }

  /// Compares both sides of "+-acos(g/(R*Omega^2)) = +-0.697569" or of "l + m*g/k = 0.7".
  void read_cell(const std::string& cell, const RestPoint& point) {
    const std::size_t sign = cell.find(" = ");
    if (sign == std::string::npos) return;
    const auto side = [](std::string text) { return replaced_all(std::move(text), "+-", ""); };
    const NamedNumbers names = names_at(model_, point.state);
    const Real right = number_of(side(cell.substr(sign + 3)), names);
    if (right.is_defined()) expect(side(cell.substr(0, sign)), names, right.value());
  }

  void read_motion_line(const std::string& line, const LinearMotions& motions) {
    const NamedNumbers names = names_at(model_, motions.point.state);
    const std::size_t n = model_.velocities.size();
    if (mentions(line, " eta''")) read_equation(line, motions.point);
    if (line.starts_with("  w^2 = ")) read_frequency(line.substr(8), names, motions);
    for (const auto& [letter, matrix] :
         {std::pair{'M', &motions.point.mass}, std::pair{'K', &motions.point.stiffness}}) {
      for (std::size_t i = 0; i < n * n; ++i) {
        const std::string left = n == 1
                                     ? fmt::format("  {} = ", letter)
                                     : fmt::format("  {}[{}][{}] = ", letter, i / n + 1, i % n + 1);
        if (line.starts_with(left)) expect(line.substr(left.size()), names, (*matrix)[i]);
      }
    }
  }

  /// Compares "(m1 + m2) eta'' + K eta = 0,   K = k + c" with the mass and stiffness of `point`.
  void read_equation(const std::string& line, const RestPoint& point) {
    const std::size_t comma = line.find(",   K = ");
    if (comma == std::string::npos) return;
    NamedNumbers names = names_at(model_, point.state);
    expect(line.substr(comma + 8), names, point.stiffness[0]);
    const std::string left = line.substr(0, line.find(" = 0,"));
    const cln::cl_R acceleration = 7;
    const cln::cl_R deviation = 5;
    names["K"] = Real(point.stiffness[0]);
    names["eta_2"] = Real(acceleration);
    names["eta"] = Real(deviation);
    expect(replaced_all(replaced_all(left, " eta''", "*eta_2"), " eta", "*eta"), names,
           point.mass[0] * acceleration + point.stiffness[0] * deviation);
  }

  /// Checks that each of the two values of `text`, "(a -+ b)/c", is the w^2 of a mode.
  void read_frequency(const std::string& text, const NamedNumbers& names,
                      const LinearMotions& motions) {
    for (const char* const sign : {"-", "+"}) {
      std::string formula = replaced_all(text, "(-+", "(0 -+");
      if (formula.starts_with("-+")) formula = "0 " + formula;
      const Real square = number_of(replaced_all(formula, "-+", sign), names);
      INFO(text);
      REQUIRE(square.is_defined());
      cln::cl_R nearest = motions.modes.front().omega_squared;
      for (const NormalMode& mode : motions.modes) {
        const cln::cl_R distance = cln::abs(mode.omega_squared - square.value());
        if (distance < cln::abs(nearest - square.value())) nearest = mode.omega_squared;
      }
      expect(replaced_all(formula, "-+", sign), names, nearest);
    }
  }

  const Model& model_;
  std::size_t count_ = 0;
};

/// The number of formulas of the model that were compared.
std::size_t expect_formulas(const SourcePointer& source) {
  PipelineOptions options;
  options.goals = {Goal::equilibria, Goal::modes};
  options.scene.purpose = purpose::rest;
  options.limits.boxes = 500;  // a few points suffice
  const Products products = run_pipeline({source, nullptr}, options);
  INFO(source->path << "\n" << source->text << "\n" << format(products.diagnostics));
  if (!products.equilibria) return 0;
  const Equilibria& found = *products.equilibria;
  FormulaReader reader(products.checked->model);
  const std::string page = text_of(equilibria_page(*products.checked, found));
  INFO(page);
  reader.read_equilibria(page, found.points);
  for (const RestPoint& point : found.points) {
    if (point.stability.leading) {
      Equilibria alone = found;
      alone.points = {point};
      reader.read_leading_term(text_of(equilibria_page(*products.checked, alone)), point, found);
    }
  }
  if (!products.modes) return reader.count();
  const std::string modes = text_of(modes_page(*products.checked, *products.modes));
  INFO(modes);
  reader.read_modes(modes, products.modes->motions);
  return reader.count();
}

/// A random positive formula in a, b, c and d.
std::string drawn_formula(Random& random) {
  static const std::vector<std::string> formulas{
      "a",           "a + b",   "a*b",       "a*b/(a + b)",     "(a + b)*c", "a*(b + c)^2",
      "a + b/c",     "2*a",     "a + b/2",   "(a + b)/(c + d)", "a^2 + b",   "a/(b + c)",
      "(a + b)^2/c", "a/(b*c)", "a*b + c*d", "sqrt(a^2 + b^2)"};
  return "(" + formulas[random.next() % formulas.size()] + ")";
}

/// One or two coordinates on springs, or one coordinate that rotates in a quartic potential.
std::string drawn_model(std::uint64_t seed) {
  Random random(seed);
  std::string coordinates = "[[coordinate]]\nname = \"x\"\n";
  const std::string kinetic = "1/2*" + drawn_formula(random) + "*dot(x)^2";
  std::string energies =
      fmt::format("T = \"{}\"\nV = \"1/2*{}*x^2\"\n", kinetic, drawn_formula(random));
  if (seed % 3 == 1) {
    coordinates += "[[coordinate]]\nname = \"y\"\n";
    energies = fmt::format(
        "T = \"{} + 1/2*{}*dot(y)^2\"\nV = \"1/2*{}*x^2 + 1/2*{}*y^2 + 1/2*{}*(x - y)^2\"\n",
        kinetic, drawn_formula(random), drawn_formula(random), drawn_formula(random),
        drawn_formula(random));
  }
  if (seed % 3 == 2) {
    static const std::vector<std::string> wells{"1 - cos(x)", "1 + cos(x)", "1 - sin(x)",
                                                "1 + sin(x)"};
    coordinates = "[[coordinate]]\nname = \"x\"\nunit = \"rad\"\n";
    energies = fmt::format("T = \"{}\"\nV = \"{}*({})^2\"\n", kinetic, drawn_formula(random),
                           wells[random.next() % wells.size()]);
  }
  std::string parameters;
  for (const char name : {'a', 'b', 'c', 'd'}) {
    parameters += fmt::format("{} = {:.3f}\n", name, random.uniform(0.5, 3));
  }
  return "format = 1\n[model]\nname = \"drawn\"\n" + coordinates + "[parameters]\n" + parameters +
         "[energy]\n" + energies;
}

}  // namespace

TEST_CASE("formulas of equilibria and modes of all committed models have the printed values") {
  std::size_t compared = 0;
  const std::filesystem::path models = std::filesystem::path(ELGEN_SOURCE_DIR) / "models";
  for (const std::filesystem::path& path : files_in(models, ".toml")) {
    compared += expect_formulas(test::source_of(path));
  }
  CHECK(compared > 100);
}

TEST_CASE("formulas of equilibria and modes of random models have the printed values") {
  constexpr std::uint64_t seeds = 200;
  std::uint64_t silent = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    if (expect_formulas(make_source("model.toml", drawn_model(seed))) == 0) ++silent;
  }
  CHECK(silent == 0);
}

}  // namespace elgen::test
