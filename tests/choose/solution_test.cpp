// Accelerations of links that are nearly aligned, one of them far lighter than the other: the
// pivots of M must keep the digits that differences of its entries lose.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "choose/chosen.hpp"
#include "choose/points.hpp"
#include "forms/write/rewritings.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

ChosenForms solved(const std::string& text) {
  SceneOptions options;
  options.outputs = {make_source("command line", "forward_dynamics")};
  return chosen(text, options);
}

/// The largest error of the accelerations in float, relative to the largest acceleration.
double float_error(const ChosenForms& c, const Arguments<float>& at) {
  const Program& program = c.choice.program;
  const Function& function = *find_function(program, OutputKind::forward_dynamics);
  const auto exact = [](float x) { return Real(exact_value(static_cast<double>(x))); };
  const std::vector<float> own = evaluate(program, function, at);
  const std::vector<Real> truth =
      evaluate(c.recursive, c.recursive.functions.front(), map_leaves(exact, at));
  double error = 0;
  double largest = 0;
  for (std::size_t i = 0; i < at.v.size(); ++i) {
    error = std::max(error, std::abs(to_double((exact(own[i]) - truth[i]).value())));
    largest = std::max(largest, std::abs(to_double(truth[i].value())));
  }
  return error / largest;
}

/// The largest float_error() at states at which the links are 1e-3 from alignment.
double worst_aligned_error(const ChosenForms& c, const std::vector<float>& parameters,
                           const std::vector<float>& u, bool is_relative_angle) {
  Arguments<float> at =
      map_leaves([](double x) { return static_cast<float>(x); },
                 domain_of({c.checked.model, c.checked.scene, c.recursive.leaves}).states.front());
  at.parameters = parameters;
  at.u = u;
  at.v = {0.7F, -1.1F};
  double worst = 0;
  for (float angle = 0.3F; angle < 1.4F; angle += 0.1F) {
    at.q = {angle, is_relative_angle ? 1e-3F : angle + 1e-3F};
    worst = std::max(worst, float_error(c, at));
  }
  return worst;
}

}  // namespace

TEST_CASE("a double pendulum keeps its digits in float at m2/m1 = 1000 and aligned arms") {
  const ChosenForms c = solved(model_file("double_pendulum"));
  // m1, m2, l1, l2, g: the masses are at the ends of their ranges. With D_2 as a difference of
  // entries of M, the error is 3e-4. sin(theta1) + sin(theta1 - 2 theta2) still cancels.
  CHECK(worst_aligned_error(c, {0.01F, 10, 0.5F, 0.4F, 9.81F}, {}, false) <= 1e-5);
}

TEST_CASE("an acrobot with a torque keeps its digits in float if its first link is light") {
  const ChosenForms c = solved(model_file("acrobot"));
  // m1, m2, l1, c1, c2, I1, I2, b1, b2, g; with D_2 as a difference, the error is 2e-3.
  const std::vector<float> light{0.1F, 10, 1, 0.05F, 0.8F, 1e-3F, 1e-3F, 0.1F, 0.05F, 9.81F};
  CHECK(worst_aligned_error(c, light, {5}, true) <= 1e-5);
}

TEST_CASE("a solution by determinants costs at most a quarter more than the recursive form") {
  for (const char* const name : {"double_pendulum", "acrobot", "two_link_arm", "triple_pendulum"}) {
    INFO(name);
    const ChosenForms c = solved(model_file(name));
    const FormCosts& costs = c.choice.costs.front();
    const std::size_t price = cost(count_operations(c.choice.program.functions.front()));
    CHECK(4 * price <= 5 * cost(costs.recursive) + 16);  // 16 is 4 times the cost of a division
  }
}

TEST_CASE("a determinant with a negative term has no form in which nothing cancels") {
  const auto has_safe_pivot = [](const std::string& text) {
    const ChosenForms c = solved(text);
    const std::optional<Fraction>& pivot = c.forms.functions.front().fields[1].entries[1];
    return has_nonnegative_terms(c.forms.algebra, pivot.value(), c.recursive.leaves);
  };
  const auto coupled = [](const std::string& assumption) {
    return model_text("coupled",
                      "[[coordinate]]\nname = \"x\"\n[[coordinate]]\nname = \"y\"\n"
                      "[parameters]\na = { value = 2" +
                          assumption +
                          " }\n"
                          "b = { value = 1" +
                          assumption +
                          " }\n[energy]\n"
                          "T = \"1/2*(a + b)*dot(x)^2 + b*cos(x)*dot(x)*dot(y) + "
                          "1/2*b*dot(y)^2\"\nV = \"sin(y)\"\n");
  };
  // The pivot is (a + b sin(x)^2)/(a + b).
  CHECK(has_safe_pivot(coupled(", assume = \"positive\"")));
  CHECK_FALSE(has_safe_pivot(coupled("")));
  // (a^2 - b^2 cos(x)^2)/a^2
  CHECK_FALSE(has_safe_pivot(model_text("crossed", R"toml(
[[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[parameters]
a = { value = 2, assume = "positive" }
b = { value = 1, assume = "positive" }
[energy]
T = "1/2*a*dot(x)^2 + b*cos(x)*dot(x)*dot(y) + 1/2*a*dot(y)^2"
V = "sin(y)"
)toml")));
}

TEST_CASE("comparison points of small solutions have parameters from all of their bounds") {
  const ChosenForms c = solved(model_file("double_pendulum"));
  const Domain domain = domain_of({c.checked.model, c.checked.scene, c.recursive.leaves});
  const Points points = comparison_points(c.recursive, c.recursive.functions.front(), domain);
  double least = std::numeric_limits<double>::infinity();
  double largest = 0;
  for (const Arguments<double>& point : points) {
    for (const std::size_t mass : {0U, 1U}) {
      CHECK(point.parameters[mass] >= 0.01);
      CHECK(point.parameters[mass] <= 10);
    }
    const double ratio = point.parameters[1] / point.parameters[0];
    least = std::min(least, ratio);
    largest = std::max(largest, ratio);
  }
  CHECK(largest > 32);
  CHECK(least < 1.0 / 32);
}
