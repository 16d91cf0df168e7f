// Rewritings that lose digits which the text keeps, the points that reveal the loss, and models
// whose code once lost digits.
#include "choose/text_errors.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "choose/chosen.hpp"
#include "program/expression_leaves.hpp"
#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Arguments<double> at(double a, double b) {
  Arguments<double> point;
  point.q = {a, b, 0.5, 0.25, 2};
  return point;
}

/// True if `rewriting` is less accurate than `text` at the point (`a`, `b`).
bool is_inaccurate(const std::string& rewriting, const std::string& text, double a, double b) {
  const Program program = program_of(Texts{text});
  const FormErrors errors(program, program.functions[0], {at(a, b)});
  return !errors.errors_if_accurate(expressions_of({rewriting}), 0);
}

const std::string strut = R"toml(format = 1
[model]
name = "strut"
[parameters]
a = { value = 0.4, unit = "m", assume = "positive", min = 0.1, max = 0.5 }
b = { value = 0.4, unit = "m", assume = "positive" }
c = { value = 0.4, unit = "kg", assume = "positive" }
F = { value = 300, unit = "N" }
[[coordinate]]
name = "th"
unit = "rad"
range = [-0.5, 3.2]
[[point]]
name = "P"
at = ["a*cos(th)", "a*sin(th)"]
[[point]]
name = "Q"
at = ["b", "0"]
[energy]
T = "1/2*c*a^2*dot(th)^2"
V = "F*sqrt(dist2(P, Q))"
)toml";

std::string well(const std::string& potential) {
  return R"toml(format = 1
[model]
name = "well"
[parameters]
m = { value = 1, unit = "kg*m^2" }
k = { value = 3, unit = "J" }
[[coordinate]]
name = "x"
unit = "1"
[energy]
T = "1/2*m*dot(x)^2"
V = ")toml" +
         potential + "\"\n";
}

std::size_t index_of(const Program& program, const std::string& name) {
  const auto named = [&](const Function& f) { return f.name == name; };
  return static_cast<std::size_t>(std::ranges::find_if(program.functions, named) -
                                  program.functions.begin());
}

/// The bound on the relative error of the force at `x`, in u.
double error_of_force(const ChosenForms& model, double x) {
  const Program& program = model.choice.program;
  const Function& gravity = program.functions[index_of(program, "gravity")];
  Arguments<double> point =
      domain_of({model.checked.model, {}, model.recursive.leaves}).states.front();
  point.q = {x};
  const RunningErrorRules<Real> rules{running_leaves<Real>(point, LeafRounding::exact)};
  const RunningValue<Real> force =
      entries_of(gravity, fold<RunningValue<Real>>(rules, program, gravity)).at(0);
  return to_double((force.error / abs(force.value)).value());
}

Points points_of_gravity(const ChosenForms& model) {
  const Program& program = model.recursive;
  return comparison_points(program, program.functions[index_of(program, "gravity")],
                           domain_of({model.checked.model, {}, program.leaves}));
}

}  // namespace

TEST_CASE("a rewriting is inaccurate if it loses digits that the text keeps") {
  const std::string text = "(a - b)*(a + b)";
  const std::string rewriting = "a^2 - b^2";
  CHECK(is_inaccurate(rewriting, text, 1, 1.0000001));
  CHECK_FALSE(is_inaccurate(rewriting, text, 1, 1.5));
  CHECK_FALSE(is_inaccurate(text, rewriting, 1, 1.0000001));
  CHECK_FALSE(is_inaccurate("1 - cos(a)", "1 - cos(a)", 1e-8, 0));
  CHECK(is_inaccurate("1 - cos(a)", "2*sin(1/2*a)^2", 1e-8, 0));
}

TEST_CASE("a rewriting without a value is inaccurate only if the text has a value") {
  CHECK(is_inaccurate("b/(a - a*b)", "1/a", 0.5, 1));
  CHECK_FALSE(is_inaccurate("1/(a - b)", "a/(a - b)", 1, 1));
}

TEST_CASE("inaccuracy is found for each entry of a function") {
  const Program text = program_of(Texts{"a*b", "(a - b)*(a + b)"});
  const Program form = program_of(Texts{"b*a", "a^2 - b^2"});
  const FormErrors errors(text, text.functions[0], {at(1, 3), at(1, 1.0000001)});
  CHECK(errors.first_inaccurate_entry(form, form.functions[0]) == std::size_t{1});
  CHECK(errors.first_inaccurate_entry(text, text.functions[0]) == std::nullopt);
}

TEST_CASE("the force of a strut with anchors at equal distances from the hinge has all digits") {
  const ChosenForms model = chosen(strut);
  for (const double angle : {1e-1, 1e-4, 1e-8}) CHECK(error_of_force(model, angle) < 64);
}

TEST_CASE("typed wells keep the digits at their minima") {
  for (const char* potential : {"k*((x - 1)*(x + 1))^2", "k*(x - 1)^2*(x + 2)"}) {
    const ChosenForms model = chosen(well(potential));
    INFO(potential);
    for (const double away : {1e-2, 1e-5, 1e-8}) CHECK(error_of_force(model, 1 + away) < 64);
  }
}

TEST_CASE("the preference speed takes the cheaper form despite lost digits") {
  const auto gravity = [](const ChosenForms& model) {
    return model.choice.costs[index_of(model.recursive, "gravity")];
  };
  const ChosenForms speedy = chosen(strut, {}, Preference::speed);
  CHECK_FALSE(gravity(speedy).inaccurate_entry);
  CHECK(error_of_force(speedy, 1e-8) > 1e6);
  CHECK(error_of_force(chosen(strut), 1e-8) < 64);
}

TEST_CASE(
    "comparison points are inside the ranges and near zeros, and keep equal parameters equal") {
  const Points points = points_of_gravity(chosen(strut));
  CHECK(points.size() <= 66);
  std::size_t others = 0;
  std::size_t near_zero = 0;
  bool has_different = false;
  for (const Arguments<double>& point : points) {
    CHECK(std::clamp(point.q[0], -0.5, 3.2) == point.q[0]);
    near_zero += std::abs(point.q[0]) < 2e-8 ? 1 : 0;
    const double a = point.parameters[0];
    others += a != 0.4 ? 1 : 0;
    has_different = has_different || point.parameters[2] != a;
    CHECK(std::clamp(a, 0.1, 0.5) == a);
    if (a != 0.5 && a != 0.1) CHECK(point.parameters[1] == a);
  }
  CHECK(others > 0);
  CHECK(others <= 4);
  CHECK(near_zero >= 2);
  CHECK(has_different);
}

TEST_CASE("zeros of sums are found at the values of the parameters") {
  const auto has_near = [](const ChosenForms& model, double place) {
    const Points points = points_of_gravity(model);
    return std::ranges::any_of(points, [place](const Arguments<double>& point) {
      return std::abs(point.q[0] - place) < 1e-7 * std::abs(place);
    });
  };
  const ChosenForms linear = chosen(well("k*(2*x - 3)^4"));
  CHECK(has_near(linear, 1.5));
  CHECK_FALSE(has_near(linear, -1.5));
  const ChosenForms squares = chosen(well("k*(x^2 - 2)^2"));
  CHECK(has_near(squares, std::sqrt(2)));
  CHECK(has_near(squares, -std::sqrt(2)));
  CHECK(has_near(chosen(well("k*sin(x)^2")), 3.141592653589793));
}
