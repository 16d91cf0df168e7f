// Constraints that constrain nothing (E536), follow from other constraints (E537) or admit no pose
// (E538).
#include <catch2/catch.hpp>

#include "inspect/checks.hpp"
#include "inspect/found.hpp"
#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A point with coordinates x and y that starts at (1, 2). Each of `equations` is an expression
/// that a constraint sets to 0; the constraints are named a, b, c, ...
ModelBuilder constrained(const std::vector<std::string>& equations) {
  ModelBuilder b;
  b.coordinate("x").coordinate("y").parameter("l", "1").T("x_d^2 + y_d^2");
  b.model.coordinates[0].start_value = 1;
  b.model.coordinates[1].start_value = 2;
  for (const std::string& equation : equations) {
    Constraint constraint;
    constraint.name = std::string(1, static_cast<char>('a' + b.model.constraints.size()));
    constraint.value = b.expression(equation);
    b.model.constraints.push_back(constraint);
  }
  return b;
}

std::string constraint_findings(const ModelBuilder& b) {
  return text_of(inspect_constraints({b.model, {}}));
}

std::string constraint_findings(const std::vector<std::string>& equations) {
  return constraint_findings(constrained(equations));
}

}  // namespace

TEST_CASE("independent and consistent constraints are not reported") {
  CHECK(constraint_findings(std::vector<std::string>{}).empty());
  CHECK(constraint_findings({"x^2 + y^2 - l^2"}).empty());
  CHECK(constraint_findings({"x^2 + y^2 - l^2", "x - y"}).empty());
}

TEST_CASE("an equation without coordinates constrains nothing") {
  CHECK(constraint_findings({"x - y", "sin(x)^2 + cos(x)^2 - 1"}) ==
        "E536: `b` constrains nothing: it is 0 for all coordinates");
  ModelBuilder b = constrained({"x_d - x_d + x"});
  b.model.constraints[0].is_position = false;
  CHECK(constraint_findings(b) == "E536: `a` constrains nothing: it is the same for all rates");
}

TEST_CASE("a dependent constraint is reported with its linear combination") {
  CHECK(constraint_findings({"x^2 + y^2 - 4*l^2", "6*l^2 - 3/2*(x^2 + y^2)"}) ==
        "E537: `b` follows from other constraints: its row of A is -3/2*a");
  ModelBuilder b = constrained({"x - y", "x_d + y_d"});
  b.model.constraints[1].is_position = false;
  CHECK(constraint_findings(b).empty());
}

TEST_CASE("a combination of several rows has a factor for each row") {
  ModelBuilder b = constrained({"x - l", "y - l", "2*x - y - l"});
  CHECK(constraint_findings(b) ==
        "E537: `c` follows from other constraints: its row of A is 2*a - b");
}

TEST_CASE("equations may be dependent at one pose only") {
  CHECK(constraint_findings({"x", "x*y"}) ==
        "E537: `b` follows from other constraints: its row of A is 2*a at one pose");
}

TEST_CASE("a dead centre at the start is no dependence") {
  ModelBuilder b = constrained({"x^2 - y^2"});
  b.model.coordinates[0].start_value = 0;
  b.model.coordinates[1].start_value = 0;
  CHECK(constraint_findings(b).empty());
}

TEST_CASE("if there is no pose, the residual of each constraint is reported") {
  CHECK(constraint_findings({"x - l", "x - 3*l"}) ==
        "E538: no coordinates near the start meet the constraints: the residual is 0 of `a`, 2 of "
        "`b`");
  ModelBuilder standing = constrained({"x^2 + y^2 - l^2"});
  standing.model.coordinates[0].start_value = 0;
  standing.model.coordinates[1].start_value = 0;
  CHECK(constraint_findings(standing) ==
        "E538: no coordinates near the start meet the constraints: the residual is 1 of `a`");
  CHECK(constraint_findings({"sqrt(-1 - x^2) - y"}) ==
        "E538: no coordinates near the start meet the constraints: the residual is undefined");
}

TEST_CASE("a pose without consistent rates is rejected") {
  CHECK(constraint_findings({"y - 2*l - l*t", "y - 2*l - 3*l*t"}) ==
        "E538: no rates near the start meet the constraints: the residual is 0 of `a`, 2 of `b`");
}
