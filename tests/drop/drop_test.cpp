// Small terms: which are dropped, what follows from it, and by how much entries are off.
#include "elgen/drop.hpp"

#include <catch2/catch.hpp>

#include "lower/read_program.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;
using cln::cl_RA;

namespace {

const std::string declarations_with_rate = R"toml([[coordinate]]
name = "x"
range = [-1, 1]
rate_range = [-2, 2]
[[coordinate]]
name = "y"
RATE
[parameters]
m = 2
e = 1e-3
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2)"
)toml";

Model model_of(const std::string& rate = "rate_range = [-3, 3]") {
  std::string text = declarations_with_rate;
  text.replace(text.find("RATE"), 4, rate);
  return checked_model(model_text("line", text)).model;
}

/// M = [m + e cos(y), e x; e x, m], C as derived from it, and dissipation [v1 + e v2, v2].
const std::string functions =
    "parameters m e\ncoordinates x y\n"
    "function mass_matrix\n  0 = parameter m\n  1 = parameter e\n  2 = coordinate y\n"
    "  3 = cos 2\n  4 = multiply 1 3\n  5 = add 0 4\n  6 = coordinate x\n  7 = multiply 1 6\n"
    "  result 2 2 = 5 7 7 0\n"
    "function velocity_force\n  0 = parameter e\n  1 = velocity x\n  2 = multiply 1 1\n"
    "  3 = coordinate y\n  4 = sin 3\n  5 = velocity y\n  6 = multiply 4 1\n  7 = multiply 6 5\n"
    "  8 = multiply 0 7\n  9 = negate 8\n  10 = multiply 4 2\n  11 = multiply 0 10\n"
    "  12 = constant 1/2\n  13 = multiply 12 11\n  14 = multiply 0 2\n  15 = add 13 14\n"
    "  result 2 1 = 9 15\n"
    "function dissipation\n  0 = velocity x\n  1 = velocity y\n  2 = parameter e\n"
    "  3 = multiply 2 1\n  4 = add 0 3\n  result 2 1 = 4 1\n";

Dropping dropping_of(const cl_RA& below) {
  Dropping dropping{below, {}, {}};
  for (const OutputKind kind : {OutputKind::mass_matrix, OutputKind::dissipation}) {
    OutputRequest part;
    part.kind = kind;
    dropping.parts.push_back(part);
  }
  return dropping;
}

Result<ReducedForms> dropped(const cl_RA& below, const Model& model = model_of(),
                             const PresentBudget& budget = {}) {
  const Program program = testing::read_program(functions);
  Scene scene;
  scene.dropping = dropping_of(below);
  return drop_terms(program, program, present(program, budget), {model, scene});
}

std::vector<std::string> lines_of(const Reduction& reduction) {
  std::vector<std::string> lines;
  for (const DroppedTerm& term : reduction.terms) {
    lines.push_back(std::string(output_row(term.output).name) + " " + std::to_string(term.row + 1) +
                    " " + std::to_string(term.column + 1) + " " + term.text);
  }
  return lines;
}

}  // namespace

TEST_CASE("terms below the share of the largest are dropped") {
  const auto reduced = dropped(cl_RA(1) / 100);
  REQUIRE(reduced);
  CHECK(lines_of(reduced->reduction) ==
        std::vector<std::string>{"mass_matrix 1 1 e*cos(y)", "dissipation 1 1 e*dot(y)"});
  CHECK(reduced->reduction.terms[0].bound == cl_RA(1) / 1000);
  CHECK(reduced->reduction.terms[1].bound == cl_RA(3) / 1000);
}

TEST_CASE("the largest term alone is never small") {
  const auto reduced = dropped(cl_RA(1) / 100);
  REQUIRE(reduced);
  const auto& mass = reduced->forms.functions[0].fields[0].entries;
  CHECK(mass[0]->numerator.size() == 1);
  CHECK(mass[1]->numerator.size() == 1);  // e x, however small beside m
}

TEST_CASE("what follows from M loses its share") {
  const auto reduced = dropped(cl_RA(1) / 100);
  REQUIRE(reduced);
  const ClosedFunction& force = reduced->forms.functions[1];
  CHECK(force.is_reduced);
  CHECK(force.fields[0].entries[0]->numerator.empty());      // -e sin(y) v1 v2
  CHECK(force.fields[0].entries[1]->numerator.size() == 1);  // e v1^2 of M_12 stays
  const ReducedOutput* errors = find_reduced(reduced->reduction, OutputKind::velocity_force);
  REQUIRE(errors != nullptr);
  CHECK(errors->errors[0].constant == cl_RA(6) / 1000);
  CHECK(errors->errors[1].constant == cl_RA(2) / 1000);
}

TEST_CASE("where nothing is small nothing changes") {
  const auto reduced = dropped(cl_RA(1) / 10000);
  REQUIRE(reduced);
  CHECK(reduced->reduction.terms.empty());
  CHECK(reduced->reduction.outputs.empty());
  for (const ClosedFunction& function : reduced->forms.functions) {
    CHECK_FALSE(function.is_reduced);
  }
}

TEST_CASE("a missing range is an error") {
  const auto reduced = dropped(cl_RA(1) / 100, model_of(""));
  REQUIRE_FALSE(reduced);
  CHECK(reduced.diagnostics.at(0).code == Code::E616);
  CHECK(reduced.diagnostics[0].message == "`drop_below` needs the `rate_range` of `y`");
}

TEST_CASE("a closed form that was given up is an error") {
  const auto reduced = dropped(cl_RA(1) / 100, model_of(), {1, 1, 1});
  REQUIRE_FALSE(reduced);
  CHECK(reduced.diagnostics.at(0).code == Code::E608);
}
