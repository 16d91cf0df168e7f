// introduction: the equation of motion with the terms a model has, and the table of operations.
#include "emit/pages/introduction.hpp"

#include <algorithm>

#include "elgen/render.hpp"
#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;
using Lines = std::vector<std::string>;

namespace {

std::string equation(const Subject& subject) {
  return equation_of_motion(subject.model, subject.program).text;
}

bool has_line(const Lines& lines, const std::string& line) {
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

}  // namespace

TEST_CASE("a term nothing is known of stays") {
  Subject subject = cart_pole();
  CHECK(equation(subject) == "M(q) a + C(q,v) v + g(q) = B(q) u");
  subject.model.may_drift = true;
  CHECK(equation(subject) == "M(q) a + C(q,v) v + drift(q,v) + g(q) = B(q) u");
}

TEST_CASE("rates are not named where no function knows of them") {
  Subject subject = cart_pole();
  subject.program = elgen::testing::read_program(
      "coordinates x theta\nfunction gravity\n  0 = coordinate x\n  result 2 1 = 0 0\n");
  const Lines lines = introduction(subject.model, subject.scene, subject.program);
  CHECK(has_line(lines, "   g(q) = B(q) u"));
  CHECK(has_line(lines, "   at rest"));
  CHECK_FALSE(has_line(lines, "   v = dq/dt, a = dv/dt"));
}

TEST_CASE("a term that is zero, or that the model cannot have, is left out") {
  Subject subject = cart_pole();
  subject.program = elgen::testing::read_program(
      "coordinates x theta\nfunction gravity\n  0 = constant 0\n  result 2 1 = 0 0\n"
      "function drift\n  0 = constant 0\n  result 2 1 = 0 0\n");
  subject.model.inputs.clear();
  subject.model.may_drift = true;
  CHECK(equation(subject) == "M(q) a + C(q,v) v = 0");
}

TEST_CASE("dissipation, other forces and time") {
  Subject subject = cart_pole();
  subject.model.energies.D = 0;
  subject.model.forces.emplace_back();
  subject.model.uses_time = subject.model.may_drift = true;
  CHECK(equation(subject) ==
        "M(q,t) a + C(q,v,t) v + drift(q,v,t) + g(q,t) + dD/dv = B(q,t) u + Q(q,v,t)");
}

TEST_CASE("an L that is not quadratic has a bias only") {
  Subject subject = cart_pole();
  subject.model.quadratic = false;
  CHECK(equation(subject) == "M(q,v) a + bias(q,v) = B(q) u");
}

TEST_CASE("title, variables and fixed parameters") {
  Subject subject = cart_pole();
  subject.scene.specialisation.fixed[3] = {cln::cl_RA(981) / 100};
  const Lines lines = introduction(subject.model, subject.scene, subject.program);
  CHECK(lines.front() == " Cart and pole with a force on the cart");
  CHECK(has_line(lines, "   q = (x [m], theta [rad])"));
  CHECK(has_line(lines, "   v = dq/dt, a = dv/dt"));
  CHECK(has_line(lines, "   u = (u [N])"));
  CHECK(lines.back() == " Fixed: g = 9.81.");
}

TEST_CASE("what is left out is said, and nothing where nothing is") {
  Subject subject = cart_pole();
  const Lines without = introduction(subject.model, subject.scene, subject.program);
  subject.scene.left_out = {{LeftOutReason::kinked_force, {"linearization"}}};
  const Lines lines = introduction(subject.model, subject.scene, subject.program);
  REQUIRE(lines.size() == without.size() + 2);
  CHECK(lines[without.size()].empty());
  CHECK(lines.back() ==
        " Left out, as forces with abs, sign, min or max have no derivatives: linearization.");
}

TEST_CASE("an expansion is said") {
  Subject subject = cart_pole();
  subject.model.expressions = {Expression{}};  // the number 0
  Approximation approximation;
  approximation.coordinates = {{}, 0};
  approximation.inputs = {{}};
  approximation.small = {false, true};
  subject.model.approximation = approximation;
  const Lines lines = introduction(subject.model, subject.scene, subject.program);
  const auto said = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find(" Expanded about theta = 0: ") == 0;
  });
  CHECK(said != lines.end());
}

TEST_CASE("many variables are shown by the first two and the last") {
  Subject subject = cart_pole();
  for (int i = 0; i < 10; ++i) append_coordinate(subject.model, subject.model.coordinates[0]);
  const Lines lines = introduction(subject.model, subject.scene, subject.program);
  CHECK(has_line(lines, "   q = (x [m], theta [rad], ..., x [m])"));
}

TEST_CASE("one row per function, columns aligned") {
  Program program = cart_pole().program;
  program.functions[1].form = Form::closed;
  const Lines table = operation_table(program);
  REQUIRE(table.size() == 1 + program.functions.size());
  CHECK(table[0] == "function             add    mul   div  sqrt sincos other  definitions  form");
  CHECK(table[1] ==
        "mass_matrix            1      4     0     0      1     0            2  recursive");
  CHECK(table[2].find("  closed") != std::string::npos);
}
