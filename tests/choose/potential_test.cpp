// One form of V for all functions: typed sums stay whole if whole sums keep digits, and every
// function uses the chosen form.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "choose/chosen.hpp"
#include "elgen/evaluate.hpp"
#include "program/evaluate/subject.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Unit masses on the lines x, y and z: one mass for each of `ranges`.
ChosenForms masses_with(const std::string& potential, const std::vector<std::string>& ranges,
                        const std::string& parameters = {}) {
  std::string text;
  std::string T;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const std::string name(1, static_cast<char>('x' + i));
    text += "[[coordinate]]\nname = \"" + name + "\"\nrange = " + ranges[i] + "\n";
    T += (T.empty() ? "1/2*dot(" : " + 1/2*dot(") + name + ")^2";
  }
  return chosen(model_text(
      "masses", text + parameters + "[energy]\nT = \"" + T + "\"\nV = \"" + potential + "\"\n"));
}

std::vector<double> values_at_rest(const ChosenForms& c, OutputKind kind,
                                   const std::vector<double>& q) {
  const Program& program = c.choice.program;
  return evaluate(program, *find_function(program, kind), state_at_rest(c, q));
}

std::size_t cost_of(const ChosenForms& c, OutputKind kind) {
  return cost(count_operations(*find_function(c.choice.program, kind)));
}

}  // namespace

TEST_CASE("with a rewritten V inverse and forward dynamics at rest equal gravity bit by bit") {
  const std::string parameters =
      "[parameters]\nk = { value = 3, assume = \"positive\" }\nl = 0.7\n";
  struct Row {
    std::string potential;
    std::vector<std::string> ranges;
    std::vector<double> q;
  };
  const std::vector<Row> rows{
      {"1/2*k*(sqrt(l^2 + x^2) - l)^2", {"[-1, 1]"}, {1e-8}},
      {"k*((x - 1)*(x + 1))^2", {"[-2, 2]"}, {1 + 9e-9}},
      {"k*log(1 - exp(-x))", {"[1e-6, 20]"}, {18}},
      {"1/2*k*((x - y)^2 + (y - z)^2)", {"[0.5, 3]", "[0.5, 3]", "[0.5, 3]"}, {2, 2 + 1e-8, 2}},
      {"k*sqrt((x - 3/4)^2 + (y - l)^2)", {"[-3, 4]", "[-3, 4]"}, {0.75 + 1e-8, 0.7 + 1e-8}}};
  for (const auto& [potential, ranges, q] : rows) {
    INFO(potential);
    const ChosenForms c = masses_with(potential, ranges, parameters);
    const std::vector<double> gravity = values_at_rest(c, OutputKind::gravity, q);
    CHECK(values_at_rest(c, OutputKind::inverse_dynamics, q) == gravity);
    CHECK(values_at_rest(c, OutputKind::bias, q) == gravity);
    std::vector<double> accelerations = values_at_rest(
        c, OutputKind::forward_dynamics, q);  // the relative pivots follow and are dropped
    accelerations.resize(gravity.size());
    for (double& a : accelerations) a = -a;
    CHECK(accelerations == gravity);
  }
}

TEST_CASE("with a rewritten V every function has the values of its text") {
  const ChosenForms c = masses_with("k*sqrt((x - 3/4)^2 + (y - l)^2)", {"[-3, 4]", "[-3, 4]"},
                                    "[parameters]\nk = 3\nl = 0.7\n");
  const Domain domain = domain_of({c.checked.model, c.checked.scene, c.recursive.leaves});
  const FormChoice without = *choose(c.recursive, c.forms, domain, c.checked.scene);
  std::size_t derivatives = 0;
  for (std::size_t i = 0; i < c.recursive.functions.size(); ++i) {
    const Function& function = c.choice.program.functions[i];
    INFO(function.name);
    const bool is_replaced = function.instructions != without.program.functions[i].instructions;
    if (output_row(function.kind).differentiates && is_replaced) ++derivatives;
    const auto text = evaluate(c.recursive, c.recursive.functions[i], domain.states.front());
    const auto values = evaluate(c.choice.program, function, domain.states.front());
    for (std::size_t k = 0; k < values.size(); ++k) {
      CHECK(values[k] == Approx(text[k]).epsilon(1e-12).margin(1e-12));
    }
  }
  CHECK(derivatives == 3);  // of gravity, and of inverse and forward dynamics
}

TEST_CASE("a sum of squares stays whole for any anchor") {
  // If the squares were multiplied out, V would lose all digits at some anchors and none at others,
  // depending on how the numbers are rounded.
  const std::vector<std::vector<double>> anchors{{1, 2}, {1, 0.75}, {1.25, 0.6875}, {-0.5, 1}};
  for (const std::vector<double>& anchor : anchors) {
    const std::string x = std::to_string(anchor[0]);
    const std::string y = std::to_string(anchor[1]);
    INFO(x << ' ' << y);
    const ChosenForms c =
        masses_with("40*sqrt((x - (" + x + "))^2 + (y - " + y + ")^2)", {"[-3, 4]", "[-3, 4]"});
    const double away = 0x1p-30;
    const auto V = values_at_rest(c, OutputKind::potential_energy,
                                  {anchor[0] + 3 * away, anchor[1] + 4 * away});
    CHECK(V.front() == Approx(200 * away).epsilon(1e-14));
  }
}

TEST_CASE("a sum is multiplied out if it loses digits as a whole") {
  const ChosenForms c =
      masses_with("k*((l + x)^2 - l^2)", {"[-1, 1]"},
                  "[parameters]\nk = 3\nl = { value = 0.7, assume = \"positive\" }\n");
  const double x = 1e-9;
  const double V = values_at_rest(c, OutputKind::potential_energy, {x}).front();
  CHECK(V == Approx(3 * x * (1.4 + x)).epsilon(1e-14));
}

TEST_CASE("a V that cancels the weight of bodies stays separate from it") {
  const std::string text = R"toml([[coordinate]]
name = "z"
range = [-1, 1]
[gravity]
vector = ["0", "0", "-9.81"]
[parameters]
m = { value = 3, assume = "positive" }
k = { value = 40, assume = "positive" }
l = { value = 0.7, assume = "positive" }
[[point]]
name = "P"
at = ["0", "0", "z"]
mass = "m"
[energy]
V = "k*(sqrt(l^2 + z^2) - l) - 9.81*m*z"
)toml";
  const ChosenForms c = chosen(model_text("preload", text));
  const double z = 1e-9;
  const double force = values_at_rest(c, OutputKind::gravity, {z}).front();
  CHECK(force == Approx(40 * z / std::sqrt(0.49 + z * z)).epsilon(1e-13));
  CHECK(values_at_rest(c, OutputKind::inverse_dynamics, {z}).front() == Approx(force));
}

TEST_CASE("sums of rates keep their operations") {
  const std::string text = R"toml([[coordinate]]
name = "x"
unit = "rad"
[[coordinate]]
name = "y"
unit = "rad"
[energy]
T = "1/2*((cos(x) + cos(y))^2 + (sin(x) + sin(y))^2)*dot(x)^2 + 1/2*dot(y)^2"
V = "3*sqrt((x - 1)^2 + (y - 3/4)^2)"
)toml";
  const ChosenForms c = chosen(model_text("circles", text));
  // 4 cos((x - y)/2)^2 costs as much as 24 multiplications; the form with sines of x and y, 45.
  CHECK(cost_of(c, OutputKind::mass_matrix) <= 26 + 4);
}
