// Expressions of a model at a state, by hand.
#include "simulate/steps/state_function.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "simulate/compiled_model.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// What the law of `u` gives at x = 0.3, y = -2, dx/dt = 0.5, dy/dt = 7, t = 4, k = 3.
double law(const std::string& text) {
  const CheckedModel checked = checked_model(model_text("plane", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[parameters]
k = 3
[define]
product = "x*y"
[[prescribed]]
name = "push"
value = "2*t"
[[point]]
name = "P"
at = ["x", "y^2"]
mass = "k"
[[input]]
name = "u"
on = "x"
)toml"),
                                             start_options("", "u=" + text));
  const ExpressionId id = *checked.model.inputs[0].law;
  StateFunction function(checked.model, id, {3});
  const double q[] = {0.3, -2};
  const double v[] = {0.5, 7};
  return function(q, v, 4);
}

}  // namespace

TEST_CASE("sums, products, quotients, powers and functions") {
  CHECK(law("-k*x + y/4 - 1") == Approx(-0.9 - 0.5 - 1));
  CHECK(law("x^2 + k^(-1/2)") == Approx(0.09 + 1 / std::sqrt(3)));
  CHECK(law("atan2(x, y) + sin(pi*x)") == Approx(std::atan2(0.3, -2) + std::sin(M_PI * 0.3)));
  CHECK(law("max(min(dot(y), 2), sign(x)) + abs(y)") == 4);
  CHECK(law("exp(t) - log(k)") == Approx(std::exp(4) - std::log(3)));
}

TEST_CASE("names stand for what the model says of them") {
  CHECK(law("product + push") == Approx(-0.6 + 8));
  CHECK(law("y(P)") == 4);
}

TEST_CASE("rates are those along the motion") {
  CHECK(law("dot(x)*dot(y)") == 3.5);
  CHECK(law("dot(product)") == Approx(0.5 * -2 + 0.3 * 7));
  CHECK(law("v2(P)") == Approx(0.25 + 28 * 28));
  CHECK(law("dot(push)") == 2);
}

TEST_CASE("components of rotations turn with their angular velocity") {
  const CheckedModel checked = checked_model(model_text("body", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "e"
kind = "rotation"
[parameters]
m = 1
[[frame]]
name = "F"
parent = "world"
rotation = "e"
[[point]]
name = "P"
frame = "F"
at = ["m", "2*m", "3*m"]
mass = "m"
[[body]]
name = "B"
frame = "F"
inertia = ["3*m", "4*m", "5*m"]
[[input]]
name = "u"
on = "x"
[energy]
T = "dot(x)^2"
)toml"),
                                             start_options("", "u=v2(P) + dot(e[2])"));
  StateFunction function(checked.model, *checked.model.inputs[0].law, {1});
  const double q[] = {0, 1, 0, 0, 0};
  const double v[] = {0, 0.5, -1, 2};
  // w x p = (-1*3 - 2*2, 2*1 - 0.5*3, 0.5*2 + 1*1) at the axes of the world
  CHECK(function(q, v, 0) == Approx(49 + 0.25 + 4 - 1));
  const double turned[] = {0, 0.5, 0.5, -0.5, 0.5};
  CHECK(function(turned, v, 0) == Approx(49 + 0.25 + 4 - 1));
}
