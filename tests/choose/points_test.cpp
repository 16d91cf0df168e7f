// Sums that vanish in several coordinates at once, and forces that hold a system at rest: the code
// must keep the digits of the text near these states.
#include "choose/points.hpp"

#include <cln/integer.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "accuracy/running_errors.hpp"
#include "choose/chosen.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Two coordinates x and y with T = 1/2 (v_x^2 + v_y^2).
ChosenForms plane_with(const std::string& potential, const std::string& parameters = {}) {
  return chosen(model_text(
      "plane", "[[coordinate]]\nname = \"x\"\n[[coordinate]]\nname = \"y\"\n" + parameters +
                   "[energy]\nT = \"1/2*(dot(x)^2 + dot(y)^2)\"\nV = \"" + potential + "\"\n"));
}

ChosenForms line_with(const std::string& potential, const std::string& rest = {}) {
  return chosen(model_text("line", "[[coordinate]]\nname = \"x\"\n" + rest +
                                       "[energy]\nT = \"1/2*dot(x)^2\"\nV = \"" + potential +
                                       "\"\n"));
}

std::size_t number_of(const ChosenForms& c, const std::string& name) {
  const auto named = [&name](const Function& f) { return f.name == name; };
  const auto& functions = c.recursive.functions;
  return static_cast<std::size_t>(std::ranges::find_if(functions, named) - functions.begin());
}

std::vector<RunningValue<Real>> entries_at(const Program& program, const Function& function,
                                           const Arguments<double>& point) {
  const RunningErrorRules<Real> rules{running_leaves<Real>(point, LeafRounding::exact)};
  return entries_of(function, fold<RunningValue<Real>>(rules, program, function));
}

/// The bound on the ratio of the code's error to the text's error at states that are no comparison
/// points of the choice. At comparison points the bound is 64.
constexpr int max_ratio_elsewhere = 512;

/// True if each entry of the code has an error of at most max_ratio_elsewhere * max(E, |x|), in u.
/// E and x are the error and the value of the entry in the text.
bool keeps_text(const ChosenForms& c, const std::string& name, const std::vector<double>& q) {
  const Arguments<double> point = state_at_rest(c, q);
  const std::size_t i = number_of(c, name);
  const auto text = entries_at(c.recursive, c.recursive.functions[i], point);
  const auto code = entries_at(c.choice.program, c.choice.program.functions[i], point);
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (!text[k].error.is_defined()) continue;
    if (!code[k].error.is_defined()) return false;
    const Real allowed =
        max(text[k].error, abs(text[k].value)) * Real(cln::cl_I(max_ratio_elsewhere));
    if (code[k].error.value() > allowed.value()) return false;
  }
  return true;
}

/// The largest error bound relative to an entry, in u; infinite if an entry is 0 or undefined.
double digits_lost(const ChosenForms& c, const std::string& name, const std::vector<double>& q) {
  const Function& function = c.choice.program.functions[number_of(c, name)];
  double worst = 0;
  for (const RunningValue<Real>& entry :
       entries_at(c.choice.program, function, state_at_rest(c, q))) {
    const Real lost = entry.error / abs(entry.value);
    if (!lost.is_defined()) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, to_double(lost.value()));
  }
  return worst;
}

}  // namespace

TEST_CASE("a distance keeps the digits of the text near the point where both differences vanish") {
  const std::string parameters = "[parameters]\na = 100\nb = 1\nc = 0.3\nk = 40\n";
  const std::vector<std::string> potentials{"40*sqrt((x - 1)^2 + (y - 0.3)^2)",
                                            "k*sqrt((x - b)^2 + (y - c)^2)",
                                            "k*((x - b)^2 + (y - c)^2)^(3/2)"};
  for (const std::string& potential : potentials) {
    const ChosenForms anchor = plane_with(potential, parameters);
    for (const double away : {1e-5, 1e-8}) {
      for (const char* name : {"potential_energy", "gravity", "inverse_dynamics"}) {
        INFO(potential << ' ' << name << ' ' << away);
        CHECK(keeps_text(anchor, name, {1 + away, 0.3 - 0.7 * away}));
      }
    }
  }
  const ChosenForms product = plane_with("k*(1/(a - x) - 1/a)*sqrt(x^2 + (y - c)^2)", parameters);
  CHECK(keeps_text(product, "potential_energy", {1e-8, 0.3 + 1e-8}));
  CHECK(keeps_text(product, "gravity", {1e-8, 0.3 + 1e-8}));
}

TEST_CASE("inverse dynamics at rest has the digits of the potential's gradient") {
  const ChosenForms spring = line_with("1/2*k*(sqrt(l^2 + x^2) - l)^2",
                                       "range = [-1, 1]\n[parameters]\nk = 40\nl = 0.7\n");
  CHECK(digits_lost(spring, "inverse_dynamics", {1e-8}) < 64);
  const ChosenForms well = line_with("3*((x - 1)*(x + 1))^2");
  CHECK(digits_lost(well, "inverse_dynamics", {1 + 9e-9}) < 64);
  CHECK(digits_lost(well, "inverse_dynamics", {9e-9 - 1}) < 64);
  const ChosenForms gas = line_with("3*log(1 - exp(-x))", "range = [1e-6, 20]\n");
  CHECK(digits_lost(gas, "inverse_dynamics", {18}) < 64);
}

TEST_CASE("comparison points of functions with rates include states at rest") {
  const ChosenForms model = plane_with("(x - 1)^2*(y - 0.3)^2");
  const auto points = [&model](const std::string& name) {
    const Program& program = model.recursive;
    const Domain domain = domain_of({model.checked.model, model.checked.scene, program.leaves});
    return comparison_points(program, program.functions[number_of(model, name)], domain);
  };
  const auto is_resting = [](const Arguments<double>& point) {
    return point.v == std::vector<double>(2) && point.a == std::vector<double>(2);
  };
  CHECK(std::ranges::count_if(points("inverse_dynamics"), is_resting) >= 5);
  CHECK(points("inverse_dynamics").size() <= 66);
}

TEST_CASE("each minimum of V gives four points at rest, one of them exactly there") {
  const ChosenForms model = plane_with("(x - 1)^2*(y - 0.3)^2");
  const Program& program = model.recursive;
  Domain domain = domain_of({model.checked.model, model.checked.scene, program.leaves});
  for (const char* name : {"inverse_dynamics", "gravity"}) {
    INFO(name);
    const Function& function = program.functions[number_of(model, name)];
    domain.minima.clear();
    const std::size_t before = comparison_points(program, function, domain).size();
    domain.minima = {{0.75, -0.25}};
    const Points points = comparison_points(program, function, domain);
    REQUIRE(points.size() == before + 4);
    CHECK(points[before].q == domain.minima.front());
    double distance = 1;
    for (std::size_t i = before; i < points.size(); ++i) {
      CHECK(points[i].v == std::vector<double>(2));
      CHECK(points[i].a == std::vector<double>(2));
      const double x = std::abs(points[i].q[0] - 0.75);
      CHECK(x < distance);
      distance = i == before ? 1e-3 : x / 1e3;
    }
  }
}

TEST_CASE("the code keeps the digits of V where all sums vanish together") {
  const ChosenForms rest = plane_with(
      "1/2*k*(sqrt((x - a)^2 + y^2) - l)^2 + J*(1 - cos(y)) + J*(cosh(x - a - l) - 1)",
      "[parameters]\na = { value = 0.5, assume = \"positive\" }\n"
      "l = { value = 0.3, assume = \"positive\" }\nk = { value = 9, assume = \"positive\" }\n"
      "J = { value = 2, assume = \"positive\" }\n");
  // sqrt((x - a)^2 + y^2) - l itself loses 8 of the 16 digits; 1 - cos(y) would lose all.
  for (const char* name : {"potential_energy", "gravity", "inverse_dynamics"}) {
    INFO(name);
    CHECK(digits_lost(rest, name, {0.8 + 3e-9, 1e-8}) < 1e10);
  }
}

TEST_CASE("the force of two equal sides is accurate at small angles between them") {
  const ChosenForms sides = line_with("40*sqrt(9/4 + 9/4 - 2*3/2*3/2*cos(x))");
  CHECK(digits_lost(sides, "gravity", {1e-8}) < 64);
}

TEST_CASE("without a range exponentials and logarithms keep their digits at large arguments") {
  const std::string parameters = "[parameters]\na = 1.5\nb = 1.25\n";
  const std::string well = "2*(1 - exp(-a*(x - b)))^2";
  const ChosenForms morse = line_with(well, parameters);
  // The exponent a (x - b) is at most 28.2. Its two roundings cost up to 56.4 u.
  for (const double x : {10.0, 15.0, 20.0}) CHECK(digits_lost(morse, "gravity", {x}) < 128);
  const ChosenForms vortex = line_with("12*log(b/x)", "[parameters]\nb = 0.45\n");
  CHECK(digits_lost(vortex, "potential_energy", {4e3}) < 64);
  const ChosenForms ranged = line_with(well, "range = [0.8, 2]\n" + parameters);
  CHECK(digits_lost(ranged, "gravity", {1.25 + 1e-8}) < 64);
}

TEST_CASE("without a range no rewriting loses digits that the text keeps far from the origin") {
  const std::string radius = "[parameters]\nr = { value = 0.3, assume = \"positive\" }\n";
  const ChosenForms conjugate = line_with("0.07*r^2/(hypot(x, r) + x)", radius);
  for (const double x : {1e4, 1e6, 1e8}) {
    INFO(x);
    CHECK(keeps_text(conjugate, "potential_energy", {x}));
    CHECK(keeps_text(conjugate, "gravity", {x}));
  }
  const ChosenForms product = plane_with("(exp(x*y) - 1)^2");
  for (const double y : {-15.0, -30.0, -40.0}) {
    INFO(y);
    CHECK(keeps_text(product, "gravity", {1, y}));
  }
}

TEST_CASE("an exponential keeps its digits beyond the range of its coordinate", "[!shouldfail]") {
  const ChosenForms morse =
      line_with("2*(1 - exp(-a*(x - b)))^2", "range = [0.8, 2]\n[parameters]\na = 1.5\nb = 1.25\n");
  CHECK(digits_lost(morse, "gravity", {10}) < 64);
}
