// Resolver, calls: what each function of the language becomes.
#include <catch2/catch.hpp>
#include <utility>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

const std::string two_points = R"(format = 1
[model]
name = "points"
[[coordinate]]
name = "x"
unit = "m"
[[coordinate]]
name = "y"
unit = "m"
[parameters]
m = { value = 1, unit = "kg" }
c = { value = 1, unit = "N/m" }
[[point]]
name = "P"
at = ["x", "2*y"]
mass = "m"
[[point]]
name = "Q[1]"
at = ["y", "x"]
[energy]
)";

std::string points_potential(const std::string& text) {
  return dumped(two_points + "V = \"" + text + "\"\n", "energy V");
}

std::string points_error(const std::string& text) {
  return messages(two_points + "V = \"" + text + "\"\n");
}

TEST_CASE("functions of points become functions of their components") {
  // A coordinate and a component may share a letter: a call is never a name.
  CHECK(points_potential("c*x*x(P)") == "energy V = c*x*x(P)\n");
  CHECK(points_potential("c*y(Q[1])^2") == "energy V = c*y(Q[1])^2\n");
  CHECK(points_potential("c*dist2(P, Q[1])") ==
        "energy V = c*((x(Q[1]) - x(P))^2 + (y(Q[1]) - y(P))^2)\n");
  CHECK(dumped(two_points + "T = \"m*v2(P)\"\n", "energy T") ==
        "energy T = m*(dot(x(P))^2 + dot(y(P))^2)\n");
}

TEST_CASE("dot of a coordinate is its rate, of anything else a total derivative") {
  CHECK(dumped(two_points + "T = \"m*dot(x)^2 + m*dot(x*y)*0\"\n", "energy T") ==
        "energy T = m*dot(x)^2 + m*dot(x*y)*0\n");
  const Model model = checked(two_points + "T = \"m*dot(x)*dot(x + y)\"\n").model;
  const Expression& product = model.expressions[*model.energies.T];
  CHECK(model.expressions[product.operands[1]].kind == ExpressionKind::rate);
  CHECK(model.expressions[product.operands[2]].kind == ExpressionKind::time_derivative);
  CHECK(points_potential("c*x^2*(1 + dot(3))") == "energy V = c*x^2*1\n");
}

TEST_CASE("what others make up is its definition, at the place of the call") {
  CHECK(points_potential("c*sqrt(4)*x^2") == points_potential("c*2*x^2"));
  CHECK(points_error("c*sqrt(-4)*x^2").find("`sqrt(-4)`") != std::string::npos);
  CHECK(points_error("c*sqrt(x, y)").find("`sqrt` takes 1") != std::string::npos);
}

TEST_CASE("sqrt is the power 1/2, delta a number, sum a sum") {
  const Model model = checked(two_points + "V = \"c*x^2*sqrt(x/y)\"\n").model;
  const Expression& product = model.expressions[*model.energies.V];
  const Expression& root = model.expressions[product.operands[2]];
  CHECK(root.kind == ExpressionKind::power);
  CHECK(root.number == cln::cl_RA(1) / 2);
  CHECK(points_potential("c*x^2*delta(1, 1) + c*delta(1, 2)") == "energy V = c*x^2*1 + c*0\n");
  CHECK(points_potential("sum(i, 2, 2, i*c*x^2)") == "energy V = 2*c*x^2\n");
  CHECK(points_potential("sum(i, 1, 2, sum(j, i, 2, delta(i, j)*c*x^2))") ==
        "energy V = (1*c*x^2 + 0*c*x^2) + 1*c*x^2\n");
}

TEST_CASE("a sum over no index is 0") {
  CHECK(points_potential("c*x^2 + sum(i, 3, 2, c*x^2)") == "energy V = c*x^2 + 0\n");
  CHECK(points_potential("sum(i, 3, 1, c*x^2)") == "energy V = 0\n");
  CHECK(points_potential("sum(i, 1, 2, sum(j, i, 1, c*x^2))") == "energy V = c*x^2 + 0\n");
}

TEST_CASE("calls that mean nothing") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"sine(x)", "E202 21:6 unknown function `sine` | did you mean `sin`?"},
      {"sin(x, y)", "E309 21:6 2 arguments, but `sin` takes 1"},
      {"atan2(x)", "E309 21:6 1 argument, but `atan2` takes 2"},
      {"sum(i, 1, x)", "E309 21:6 3 arguments, but `sum` takes 4"},
      {"sum(2*i, 1, 2, x)",
       "E210 21:10 `2*i` is not the name of a running index | write `sum(i, 1, n, …)`"},
      {"sum(i, 1, c, x)", "E201 21:16 unknown index `c`"},
      {"delta(x, 1)", "E201 21:12 unknown index `x`"},
      {"z(P)", "E516 21:6 `P` is planar, so it has no z"},
      {"v2(R)", "E201 21:9 unknown point `R`"},
      {"x(2*P)", "E201 21:8 unknown point `2*P`"},
      {"x(Q)", "E208 21:8 `Q` needs an index: `Q` has the elements 1 to 1"},
      {"x(Q[2])", "E207 21:8 there is no `Q[2]`: `Q` has the elements 1 to 1"},
      {"dist2(P)", "E309 21:6 1 argument, but `dist2` takes 2"},
  };
  for (const auto& [text, error] : rows) {
    INFO(text);
    CHECK(points_error(text) == error + "\n");
  }
}

}  // namespace
}  // namespace elgen::test
