// The parser of models reads each equation of motion that a derivation prints. The value must be
// the row M a + bias - B u - A^T lambda. Equations solved for the acceleration and equations of
// constraints are compared too.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <set>

#include "elgen/oracle.hpp"
#include "elgen/page.hpp"
#include "elgen/pipeline.hpp"
#include "model/requests.hpp"
#include "random/generator.hpp"
#include "support/inputs.hpp"
#include "texts/fold_expression.hpp"
#include "texts/written_equations.hpp"

namespace elgen::test {
namespace {

constexpr std::string_view motion_title = "Equations of motion";

/// A printed equation, or a definition printed below the equations.
struct PrintedEquation {
  std::string left;
  std::string right;
};

bool is_expression(const std::string& text) {
  return static_cast<bool>(parse_expression(make_source("", text), written_limits()));
}

/// The lines of the section "Equations of motion", without their margin.
std::vector<std::string> motion_lines(const std::string& text) {
  const std::string margin = "  ";
  std::vector<std::string> lines;
  bool is_inside = false;
  for (const std::string& line : split_lines(text)) {
    if (!line.starts_with(margin)) is_inside = line == motion_title;
    if (is_inside && line.starts_with(margin)) lines.push_back(line.substr(margin.size()));
  }
  return lines;
}

/// The equations with all definitions ("where b = m*l") substituted. The last definition is the
/// first to be substituted, because it may use earlier definitions.
std::vector<PrintedEquation> motion_equations(const std::string& text) {
  const std::string mark = "where ";
  std::vector<PrintedEquation> equations;
  std::vector<PrintedEquation> definitions;
  for (const std::string& line : motion_lines(text)) {
    const bool is_definition = line.starts_with(mark);
    const std::size_t start = is_definition ? mark.size() : 0;
    const std::size_t equal = line.find(" = ");
    if (equal == std::string::npos) continue;
    const PrintedEquation equation{line.substr(start, equal - start), line.substr(equal + 3)};
    if (!is_expression(equation.left) || !is_expression(equation.right)) continue;
    (is_definition ? definitions : equations).push_back(equation);
  }
  for (auto known = definitions.rbegin(); known != definitions.rend(); ++known) {
    const std::regex name("\\b" + known->left + "\\b");
    for (PrintedEquation& equation : equations) {
      equation.left = std::regex_replace(equation.left, name, "(" + known->right + ")");
      equation.right = std::regex_replace(equation.right, name, "(" + known->right + ")");
    }
  }
  return equations;
}

/// The expected value at each state, and the size of the largest term, at least 1. A value is
/// undefined if the model gives no value.
struct ReferenceRow {
  std::vector<Real> values = {};
  std::vector<Real> sizes = {};

  void add(const Real& value, const Real& size) {
    values.push_back(value);
    sizes.push_back(max(size, Real(cln::cl_R(1))));
  }
};

State exact_leaves(const Arguments<Real>& state) {
  return map_leaves([](const Real& value) -> cln::cl_R { return value.value(); }, state);
}

/// The values of an output at a state, row by row. If `count` is 0, there are none.
OracleValues matrix_at(const Model& model, OutputKind kind, std::size_t count, const State& state) {
  if (count == 0) return std::vector<cln::cl_R>{};
  return oracle_values(model, make_request(model, kind, 0), state);
}

/// M a + bias - B u - A^T lambda for each velocity.
std::vector<ReferenceRow> defined_rows(const Model& model,
                                       const std::vector<Arguments<Real>>& states) {
  std::vector<ReferenceRow> rows(model.velocities.size());
  const std::size_t inputs = model.inputs.size();
  const std::size_t constraints = model.constraints.size();
  for (const Arguments<Real>& at : states) {
    const State state = exact_leaves(at);
    const OracleValues force = oracle_values(model, {.kind = OutputKind::inverse_dynamics}, state);
    const OracleValues matrix = matrix_at(model, OutputKind::input_matrix, inputs, state);
    const OracleValues slopes =
        matrix_at(model, OutputKind::constraint_jacobian, constraints, state);
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (!force || !matrix || !slopes) {
        rows[row].add(Real::undefined(), Real());
        continue;
      }
      Real total((*force)[row]);
      Real size = abs(total);
      const auto subtract = [&total, &size](const cln::cl_R& slope, const Real& by) {
        const Real term = Real(slope) * by;
        total = total - term;
        size = max(size, abs(term));
      };
      for (std::size_t u = 0; u < inputs; ++u) subtract((*matrix)[row * inputs + u], at.u[u]);
      for (std::size_t i = 0; i < constraints; ++i) {
        subtract((*slopes)[i * rows.size() + row], at.multipliers[i]);
      }
      rows[row].add(total, size);
    }
  }
  return rows;
}

/// For each constraint the values at all states: f(q, t) of a position constraint, phi(q, v, t) of
/// a velocity constraint.
std::vector<ReferenceRow> defined_constraints(const Model& model,
                                              const std::vector<Arguments<Real>>& states) {
  std::vector<ReferenceRow> rows(model.constraints.size());
  for (const Arguments<Real>& at : states) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto value =
          oracle_expression_value(model, model.constraints[i].value, exact_leaves(at));
      rows[i].add(value ? Real(*value) : Real::undefined(), value ? abs(Real(*value)) : Real());
    }
  }
  return rows;
}

/// The acceleration of the only velocity.
ReferenceRow defined_acceleration(const Model& model, const std::vector<Arguments<Real>>& states) {
  ReferenceRow row;
  for (const Arguments<Real>& at : states) {
    const OracleValues solved =
        oracle_values(model, {.kind = OutputKind::forward_dynamics}, exact_leaves(at));
    const Real value = solved ? Real(solved->front()) : Real::undefined();
    row.add(value, solved ? abs(value) : Real());
  }
  return row;
}

/// True if the row has a value at some state.
bool has_values(const ReferenceRow& row) {
  return std::ranges::any_of(row.values, [](const Real& value) { return value.is_defined(); });
}

void expect_solved(const Model& model, const PrintedEquation& equation,
                   WrittenEquations& equations) {
  const ReferenceRow solved = defined_acceleration(model, equations.states());
  const std::string wrong = equations.values(solved.values, solved.sizes, equation.right);
  INFO(wrong);
  CHECK(wrong.empty());
  CHECK(equation.left == "dot(dot(" + model.velocities[0].name + "))");
}

/// True if every velocity has a row in book form. The rows come before the last two functions: the
/// invariants and the accelerations.
bool all_rows_readable(const ReadableDerivation& steps, std::size_t velocities) {
  const std::vector<Function>& read = steps.program.readable;
  const auto end = read.end() - 2;
  const auto is_read = [](const Field& field) { return !field.entries.empty(); };
  return std::all_of(end - static_cast<std::ptrdiff_t>(velocities), end,
                     [&is_read](const Function& row) {
                       return !row.fields.empty() && std::ranges::all_of(row.fields, is_read);
                     });
}

/// Compares the equations of motion and of constraints, and for a single velocity also the solved
/// equation. Returns false if a row of motion is not in book form or the first row has no value.
bool expect_rows(const SourcePointer& source) {
  const Products products =
      products_with(&Products::steps, {source, nullptr}, {.goals = {Goal::steps}});
  const Model& model = products.checked->model;
  const std::string text = text_of(derivation_sections(model, *products.steps));
  INFO(text);
  const std::vector<PrintedEquation> equations = motion_equations(text);
  const std::size_t count = model.velocities.size();
  if (!all_rows_readable(*products.steps, count))
    return false;  // a row without book form is not printed as one equation
  REQUIRE(equations.size() >= count);
  WrittenEquations written({model, products.checked->scene, products.steps->program});
  std::vector<ReferenceRow> rows = defined_rows(model, written.states());
  const std::vector<ReferenceRow> others = defined_constraints(model, written.states());
  rows.insert(rows.end(), others.begin(), others.end());
  REQUIRE(equations.size() >= rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string row = "(" + equations[i].left + ") - (" + equations[i].right + ")";
    const std::string wrong = written.values(rows[i].values, rows[i].sizes, row);
    INFO(wrong);
    CHECK(wrong.empty());
  }
  if (count == 1 && equations.size() > rows.size()) {
    expect_solved(model, equations[1], written);
  }
  return has_values(rows.front());
}

}  // namespace

TEST_CASE("the printed equations of motion of all committed models are correct") {
  // These models have so many terms that the page shows the equations in parts.
  const std::set<std::string> large{"andrews.toml", "bicycle.toml", "body_on_springs.toml",
                                    "panda7.toml", "ur5.toml"};
  const std::filesystem::path root(ELGEN_SOURCE_DIR);
  for (const auto& folder : {root / "models", root / "tests/print/books"}) {
    for (const std::filesystem::path& path : files_in(folder, ".toml")) {
      if (large.count(path.filename().string()) != 0) continue;
      CHECK(expect_rows(test::source_of(path)));
    }
  }
}

TEST_CASE("the printed equations of motion of random models are correct") {
  constexpr std::uint64_t seeds = 300;
  std::uint64_t compared = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const random::System system = random::Generator(seed).system();
    if (expect_rows(make_source("model.toml", text_of(system.model)))) ++compared;
  }
  // Bodies that rotate in three dimensions have longer rows. A few models have no value at the
  // random states.
  CHECK(compared > seeds / 4);
}

TEST_CASE("definitions below the equations are substituted, the last one first") {
  const std::string text =
      "Energies\n  T = 0\n\nEquations of motion\n  One a coordinate.\n  b*x + ab = c\n"
      "  where c = 2*m\n  where b = c + 1\n\nEnergy function\n  E = 0\n";
  const std::vector<PrintedEquation> equations = motion_equations(text);
  REQUIRE(equations.size() == 1);
  CHECK(equations[0].left == "((2*m) + 1)*x + ab");
  CHECK(equations[0].right == "(2*m)");
}

TEST_CASE("a changed sign in an equation of motion is detected") {
  const std::filesystem::path path =
      std::filesystem::path(ELGEN_SOURCE_DIR) / "tests/print/books/cart_pole.toml";
  const Products products =
      products_with(&Products::steps, {test::source_of(path), nullptr}, {.goals = {Goal::steps}});
  const Model& model = products.checked->model;
  WrittenEquations written({model, products.checked->scene, products.steps->program});
  const ReferenceRow row = defined_rows(model, written.states())[0];
  const std::string right = "(M + m)*dot(dot(x)) + m*l*dot(dot(theta))*cos(theta) - u";
  const std::string centrifugal = "m*l*dot(theta)^2*sin(theta)";
  CHECK(written.values(row.values, row.sizes, right + " - " + centrifugal).empty());
  CHECK_FALSE(written.values(row.values, row.sizes, right + " + " + centrifugal).empty());
}

}  // namespace elgen::test
