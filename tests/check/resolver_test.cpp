// Resolved expressions: names, calls and indices, and messages about unknown names.
#include "check/expressions/resolver.hpp"

#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen::test {

namespace {

std::string block_potential(const std::string& text, const CheckOptions& wanted = {}) {
  return dump_lines(block("V = \"" + text + "\"\n"), "energy V", wanted);
}

const std::string pushed_masses = R"toml(format = 1
[model]
name = "masses"
[sizes]
n = 3
[[coordinate]]
for = "i in 1..n"
name = "x[i]"
unit = "m"
[parameters]
m = { size = "n", value = [1, 2, 3], unit = "kg" }
k = { value = 10, unit = "N/m" }
[[point]]
name = "top"
at = ["0", "0"]
[[input]]
name = "u"
unit = "N"
on = "x[n]"
[energy]
T = "sum(i, 1, n, 1/2*m[i]*dot(x[i])^2)"
)toml";

std::string masses_error(const std::string& text) {
  return messages(pushed_masses + "V = \"" + text + "\"\n");
}

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
  return dump_lines(two_points + "V = \"" + text + "\"\n", "energy V");
}

std::string points_error(const std::string& text) {
  return messages(two_points + "V = \"" + text + "\"\n");
}

}  // namespace

TEST_CASE("operations on numbers are folded, and other expressions stay as written") {
  const Rows rows{
      {"1/2*k*x^2", "1/2*k*x^2"},
      {"k*x^2 - (1/3 + 1/6)*k*x^2", "k*x^2 - 1/2*k*x^2"},
      {"k*x*x + 0*k*x^2", "k*x*x + 0*k*x^2"},
      {"k*x^2*sqrt(4)", "k*x^2*2"},
      {"k*x^2/2/3", "k*x^2/2/3"},
      {"-(k*x^2)", "-(k*x^2)"},
  };
  for (const auto& [text, printed] : rows) {
    CHECK(block_potential(text) == "energy V = " + printed + "\n");
  }
}

TEST_CASE("exponents are rational constants") {
  CHECK(block_potential("k*x^(4/2)") == "energy V = k*x^2\n");
  CHECK(block_potential("k*x^(5-3)") == "energy V = k*x^2\n");
  CHECK(block_potential("k*x^(3/2)*x^0.5") == "energy V = k*x^(3/2)*sqrt(x)\n");
  CHECK(potential_messages("k^x") ==
        "E311 12:8 `x` is not a rational constant | write exp(y*log(x)) for x^y\n");
  CHECK(potential_messages("k^pi").substr(0, 9) == "E311 12:8");
  // Only the outermost non-constant exponent is named.
  CHECK(potential_messages("k^x^m").substr(0, 17) == "E311 12:8 `x^m` i");
  CHECK(potential_messages("k^xx").substr(0, 9) == "E201 12:8");
}

TEST_CASE("exponents have a limit, which is still allowed") {
  CHECK(messages(block("V = \"k*x^2*(x/x)^64\"\n")).empty());
  CHECK(potential_messages("k*x^65") == "E905 12:10 `65` is beyond the limit 64\n");
  CHECK(potential_messages("k*x^-65").substr(0, 4) == "E905");
  CHECK(potential_messages("k*x^(1/65)") == "E905 12:10 `(1/65)` is beyond the limit 64\n");
  CHECK(potential_messages("2^(2^100)").substr(0, 10) == "E905 12:11");
  Limits limits;
  limits.integer_power = 65;
  CHECK(messages(block("V = \"k*x^2*(x/x)^65\"\n"), {.limits = limits}).empty());
}

TEST_CASE("the number of nodes of all expressions has a limit, which is reported once") {
  Limits limits;
  limits.derived_nodes = 50;
  const std::string model = block("V = \"sum(i, 1, 100, k*x^2)\"\nD = \"sum(i, 1, 100, m)\"\n");
  CHECK(messages(model, {.limits = limits}) ==
        "E908 12:25 the expressions have more than 50 nodes after repetition\n");
}

TEST_CASE("sums with too many terms are stopped") {
  CHECK(potential_messages("sum(i, 1, 1000000000, sum(j, 1, 1000000000, k*x^2))").substr(0, 4) ==
        "E908");
}

TEST_CASE("the same error in two terms is reported at both positions") {
  CHECK(potential_messages("foo + bar") ==
        "E201 12:6 unknown name `foo`\nE201 12:12 unknown name `bar`\n");
}

TEST_CASE("indices are resolved while repetitions are expanded") {
  CHECK(dump_lines(pushed_masses, "energy T") ==
        "energy T = 1/2*m[1]*dot(x[1])^2 + 1/2*m[2]*dot(x[2])^2 + 1/2*m[3]*dot(x[3])^2\n");
  CHECK(dump_lines(pushed_masses + "V = \"k*x[n-1]*x[max(1, n-2)]\"\n", "energy V") ==
        "energy V = k*x[2]*x[1]\n");
  CHECK(dump_lines(pushed_masses, "input") == "input u [N], on x[3]\n");
}

TEST_CASE("sizes and running indices are numbers inside expressions") {
  CHECK(dump_lines(pushed_masses + "V = \"n*k*sum(i, 1, 2, i*x[i]^2)\"\n", "energy V") ==
        "energy V = 3*k*(1*x[1]^2 + 2*x[2]^2)\n");
}

TEST_CASE("pi and time are predefined") {
  CHECK(dump_lines(pushed_masses + "V = \"k*x[1]^2*cos(pi*t*sqrt(k/m[1]))\"\n", "energy V") ==
        "energy V = k*x[1]^2*cos(pi*t*sqrt(k/m[1]))\n");
  CHECK(dump_lines(pushed_masses + "V = \"k*x[1]^2*cos(t*sqrt(k/m[1]))\"\n", "time") ==
        "time yes\n");
  CHECK(dump_lines(pushed_masses, "time") == "time no\n");
}

TEST_CASE("each kind of unknown or misused name has its own message") {
  const Rows rows{
      {"kk", "E201 22:6 unknown name `kk` | did you mean `k`? (parameter, line 12)"},
      {"sin", "E316 22:6 `sin` has no argument | write `sin(…)`"},
      {"x(y)", "E201 22:8 unknown place `y`"},
      {"k*x", "E208 22:8 `x` needs an index: `x` has the elements 1 to 3"},
      {"k[1]", "E208 22:6 `k` takes no index"},
      {"x[4]", "E207 22:6 there is no `x[4]`: `x` has the elements 1 to 3"},
      {"x[n+1]", "E207 22:6 `x[n+1]` is `x[4]`, but `x` has the elements 1 to 3"},
      {"sum(i, 1, n, x[i-1])", "E207 22:19 `x[i-1]` is `x[0]`, but `x` has the elements 1 to 3"},
      {"x[k]", "E201 22:8 unknown index `k`"},
      {"x[1.5]", "E318 22:8 `1.5` is not integer arithmetic over sizes and indices"},
      {"top", "E319 22:6 `top` is a point, not a number | its components are `x(top)` and so on"},
      {"y[top]", "E201 22:6 unknown name `y` | write `y(top)`"},
      {"y", "E201 22:6 unknown name `y` | declare it, or write `y(P)`"},
      {"PI*k", "E201 22:6 unknown name `PI` | write `pi`"},
      {"3*kg", "E201 22:8 unknown name `kg` | a unit belongs to a parameter: `unit = \"kg\"`"},
      {"e^k", "E201 22:6 unknown name `e` | e^x is written `exp(x)`"},
      {"v_x[2]", "E201 22:6 unknown name `v_x` | a rate is written `dot(x[2])`"},
      {"pow(k, 2)", "E202 22:6 unknown function `pow` | write `k^2`"},
      {"pow(x[1] + k, 1/2)", "E202 22:6 unknown function `pow` | write `(x[1] + k)^(1/2)`"},
      {"ln(k + 1)", "E202 22:6 unknown function `ln` | write `log(k + 1)`"},
      {"arctan2(k, 2)", "E202 22:6 unknown function `arctan2` | did you mean `atan2`?"},
      {"ddot(x[1])", "E202 22:6 unknown function `ddot` | write `dot(dot(x[1]))`"},
      {"diff(x[1], t)", "E202 22:6 unknown function `diff` | write `dot(x[1])`"},
      {"diff(x[1], k)", "E202 22:6 unknown function `diff`"},
  };
  for (const auto& [text, error] : rows) {
    INFO(text);
    CHECK(masses_error(text) == error + "\n");
  }
}

TEST_CASE("a very long name is cut in the message") {
  const std::string message = masses_error(std::string(100'000, 'x'));
  CHECK(message == "E201 22:6 unknown name `" + std::string(60, 'x') + "…`\n");
}

TEST_CASE("uses of a coordinate t, whose declaration fails, are not the time") {
  CHECK(messages("format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"t\"\nunit = \"m\"\n"
                 "[parameters]\nm = { value = 1, unit = \"kg\" }\n[energy]\n"
                 "T = \"1/2*m*dot(t)^2\"\nV = \"m*t\"\nD = \"m*cos(t)\"\n") ==
        "E204 5:9 `t` is reserved: it is time | `t_1` is free\n");
}

TEST_CASE("uses of a name whose declaration failed are not reported") {
  const std::string model = R"(format = 1
[model]
name = "a"
[[coordinate]]
name = "q"
[parameters]
double = 2
[energy]
T = "double*dot(q)^2"
)";
  CHECK(messages(model) ==
        "E204 7:1 `double` is reserved: it is a keyword of C++ | `double_1` is free\n");
}

TEST_CASE("functions of points become functions of their components") {
  // A coordinate and a function may share the name x: a name before "(" is the function.
  CHECK(points_potential("c*x*x(P)") == "energy V = c*x*x(P)\n");
  CHECK(points_potential("c*y(Q[1])^2") == "energy V = c*y(Q[1])^2\n");
  CHECK(points_potential("c*dist2(P, Q[1])") ==
        "energy V = c*((x(Q[1]) - x(P))^2 + (y(Q[1]) - y(P))^2)\n");
  CHECK(dump_lines(two_points + "T = \"m*v2(P)\"\n", "energy T") ==
        "energy T = m*(dot(x(P))^2 + dot(y(P))^2)\n");
}

TEST_CASE("dot of a coordinate is its rate, of anything else a total derivative") {
  CHECK(dump_lines(two_points + "T = \"m*dot(x)^2 + m*dot(x*y)*0\"\n", "energy T") ==
        "energy T = m*dot(x)^2 + m*dot(x*y)*0\n");
  const Model model = checked(two_points + "T = \"m*dot(x)*dot(x + y)\"\n").model;
  const Expression& product = model.expressions[*model.energies.T];
  CHECK(is_leaf(model.expressions[product.operands[1]], Opcode::velocity));
  CHECK(model.expressions[product.operands[2]].kind == ExpressionKind::time_derivative);
  CHECK(points_potential("c*x^2*(1 + dot(3))") == "energy V = c*x^2*1\n");
}

TEST_CASE(
    "a function defined by other functions is replaced by its definition, at the call's position") {
  CHECK(points_potential("c*sqrt(4)*x^2") == points_potential("c*2*x^2"));
  CHECK(mentions(points_error("c*sqrt(-4)*x^2"), "`sqrt(-4)`"));
  CHECK(mentions(points_error("c*sqrt(x, y)"), "`sqrt` takes 1"));
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
        "energy V = 2*c*x^2\n");
}

TEST_CASE("terms of a sum that differ only in a numeric factor are combined") {
  CHECK(points_potential("sum(i, 1, 3, i*c*x^2 - c*x*y/(2*i))") ==
        "energy V = 6*c*x^2 + (-11/12*c*x*y)\n");
  CHECK(points_potential("sum(i, 1, 10000, i*c*x^2)") == "energy V = 50005000*c*x^2\n");
  CHECK(points_potential("sum(i, 1, 3, (i - 2)*c*x^2)") == "energy V = c*x^2 - c*x^2\n");
  // Terms that differ in the argument of a function are not combined.
  CHECK(points_potential("sum(i, 1, 2, c*x^2*sin(i*x/y))") ==
        "energy V = c*x^2*sin(1*x/y) + c*x^2*sin(2*x/y)\n");
}

TEST_CASE("errors in combined terms of a sum are reported, even if the terms cancel") {
  check_rows({{"sum(i, 1, 3, i*c*x)", "E403 21:6 `sum(i, 1, 3, i*c*x)` is in N, but V is in J\n"},
              {"c*x^2 + sum(i, -1, 1, i*c*x)",
               "E401 21:14 `sum(i, -1, 1, i*c*x)` is in N, but the sum is in J\n"},
              {"sum(i, -1, 1, i*abs(x)*c*x)",
               "E315 21:22 `abs(x)` is a function with a kink, but V takes none | a smooth "
               "approximation is tanh(x/width)\n"}},
             points_error);
  // Factors whose sum has more than largest_exact_digits digits are not added, and neither are
  // quotients with divisor 0.
  const Model model =
      checked(two_points + "V = \"sum(i, 1, 2, c*x^2*1e300^10 + c*x^2/1e300^10)\"\n").model;
  CHECK(model.expressions[*model.energies.V].operands.size() == 2);
  CHECK(points_potential("sum(i, 0, 1, c*x^3/(i*y))") == "energy V = c*x^3/(0*y) + c*x^3/(1*y)\n");
}

TEST_CASE("a sum over an empty range is 0") {
  CHECK(points_potential("c*x^2 + sum(i, 3, 2, c*x^2)") == "energy V = c*x^2 + 0\n");
  CHECK(points_potential("sum(i, 3, 1, c*x^2)") == "energy V = 0\n");
  CHECK(points_potential("sum(i, 1, 2, sum(j, i, 1, c*x^2))") == "energy V = c*x^2 + 0\n");
}

TEST_CASE("refused calls") {
  const Rows rows{
      {"sine(x)", "E202 21:6 unknown function `sine` | did you mean `sin`?"},
      {"sin(x, y)", "E309 21:6 2 arguments, but `sin` takes 1"},
      {"atan2(x)", "E309 21:6 1 argument, but `atan2` takes 2"},
      {"hypot(x)", "E309 21:6 1 argument, but `hypot` takes 2"},
      {"sinc(x, y)", "E309 21:6 2 arguments, but `sinc` takes 1"},
      {"stumpff(x, 41)", "E318 21:17 `41` is not from -40 to 40"},
      {"stumpff(x, -41)", "E318 21:17 `-41` is not from -40 to 40"},
      {"stumpff(x, 1/2)", "E318 21:17 `1/2` is not integer arithmetic over sizes and indices"},
      {"stumpff(x, y)", "E201 21:17 unknown index `y`"},
      {"sum(i, 1, x)", "E309 21:6 3 arguments, but `sum` takes 4"},
      {"sum(2*i, 1, 2, x)",
       "E210 21:10 `2*i` is not the name of a running index | write `sum(i, 1, n, …)`"},
      {"sum(i, 1, c, x)", "E201 21:16 unknown index `c`"},
      {"delta(x, 1)", "E201 21:12 unknown index `x`"},
      {"z(P)", "E516 21:6 `P` is planar, so it has no z"},
      {"v2(R)", "E201 21:9 unknown place `R`"},
      {"x(2*P)", "E201 21:8 unknown place `2*P`"},
      {"x(Q)", "E208 21:8 `Q` needs an index: `Q` has the elements 1 to 1"},
      {"x(Q[2])", "E207 21:8 there is no `Q[2]`: `Q` has the elements 1 to 1"},
      {"dist2(P)", "E309 21:6 1 argument, but `dist2` takes 2"},
  };
  for (const auto& [text, error] : rows) {
    INFO(text);
    CHECK(points_error(text) == error + "\n");
  }
}

}  // namespace elgen::test
