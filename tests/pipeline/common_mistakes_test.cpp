// Common mistakes in derivations: each has a message, or the model language cannot express it.
#include <catch2/catch.hpp>

#include "pipeline/pipeline_testing.hpp"

namespace elgen::test {

namespace {

const std::string pendulum = R"toml(format = 1
[model]
name = "pendulum"
[[coordinate]]
name = "theta"
[parameters]
m = 1
l = 0.5
g = 9.81
[[point]]
name = "bob"
at = ["l*sin(theta)", "-l*cos(theta)"]
mass = "m"
)toml";

const std::string cart_pole = R"toml(format = 1
[model]
name = "cart_pole"
[[coordinate]]
name = "x"
[[coordinate]]
name = "theta"
[parameters]
M = 1
m = 0.1
l = 0.5
g = 9.81
)toml";

std::string found(const std::string& text) {
  return format(run_pipeline(inputs_of(text), {.goals = {Goal::emit}}).diagnostics);
}

/// The diagnostics of `verify` for wrong entries of [[expect]].
std::string disproved(const std::string& text) {
  Products products =
      run_pipeline(inputs_of(text), {.scene = {.purpose = purpose::verify}, .goals = {Goal::emit}});
  const auto& [model, scene] = *products.checked;
  VerifyOptions quick;
  quick.is_quick = true;
  quick.forms = &*products.closed_forms;
  return format(verify(model, scene, *products.program, {}, quick).diagnostics);
}

}  // namespace

TEST_CASE("too many coordinates: the direction without kinetic energy is reported") {
  const std::string text = found(R"toml(format = 1
[model]
name = "rod"
[[coordinate]]
name = "q1"
[[coordinate]]
name = "q2"
[[point]]
name = "tip"
at = ["cos(q1 + q2)", "sin(q1 + q2)"]
mass = 2
)toml");
  CHECK(mentions(text, "error[E501]: the motion `q1 : q2 = 1 : -1` has no kinetic energy"));
}

TEST_CASE(
    "too many coordinates: a configuration-dependent direction is reported at one configuration") {
  const std::string text = found(R"toml(format = 1
[model]
name = "twice"
[[coordinate]]
name = "x"
[[coordinate]]
name = "r"
range = [0.5, 2]
[[coordinate]]
name = "phi"
[[point]]
name = "particle"
at = ["x + r*cos(phi)", "r*sin(phi)"]
mass = 1
)toml");
  CHECK(mentions(text,
                 "error[E501]: rank 2 of 3 at every sampled configuration: the motion `x : r : "));
}

TEST_CASE("a velocity without the chain rule cannot be written for a point") {
  const std::string text = found(cart_pole + R"toml([[point]]
name = "bob"
at = ["x + l*sin(theta)*dot(theta)", "l*cos(theta)"]
mass = "m"
)toml");
  CHECK(mentions(text, "error[E319]"));
  CHECK(mentions(text, "a position takes none"));
}

TEST_CASE("a kinetic energy without its cross term is disproved, with both values") {
  const std::string text = disproved(cart_pole + R"toml([energy]
T = "1/2*M*dot(x)^2 + 1/2*m*(dot(x)^2 + l^2*dot(theta)^2)"
V = "m*g*l*cos(theta)"
[[expect]]
mass_matrix = [["M + m", "m*l*cos(theta)"], ["m*l*cos(theta)", "m*l^2"]]
)toml");
  CHECK(mentions(text, "error[E510]: mass_matrix[1,2] is "));
  CHECK(mentions(text, " by this form, 0 as derived, "));
}

TEST_CASE("the same system written with points is proved") {
  CHECK(disproved(cart_pole + R"toml([[point]]
name = "cart"
at = ["x", "0"]
mass = "M"
[[point]]
name = "bob"
at = ["x + l*sin(theta)", "l*cos(theta)"]
mass = "m"
[[expect]]
mass_matrix = [["M + m", "m*l*cos(theta)"], ["m*l*cos(theta)", "m*l^2"]]
)toml")
            .empty());
}

TEST_CASE("a rail given by a curve: its slope as an open function works, as the message suggests") {
  const std::string rail = R"toml(format = 1
[model]
name = "rail"
[[coordinate]]
name = "s"
[[coordinate]]
name = "th"
[parameters]
m = 2
l = 0.4
[[function]]
name = "X"
of = ["s"]
)toml";
  const std::string point = found(rail + R"toml([[point]]
name = "bob"
at = ["X + l*sin(th)", "-l*cos(th)"]
mass = "m"
)toml");
  CHECK(mentions(point, "error[E319]: `X` is an open function, but a position takes none"));
  CHECK(mentions(point, "`[[function]]` for the slope is allowed in `[energy] T`"));
  const std::string energy = found(rail + "[energy]\nT = \"m*dot(X)^2 + m*l^2*dot(th)^2\"\n");
  CHECK(mentions(energy, "the rate is slope*dot(argument)"));
  CHECK(disproved(rail + R"toml([[function]]
name = "slope"
of = ["s"]
[energy]
T = "1/2*m*(slope*dot(s))^2 + 1/2*m*((slope*dot(s) + l*cos(th)*dot(th))^2 + (l*sin(th)*dot(th))^2)"
[[expect]]
mass_matrix = [["2*m*slope^2", "m*l*slope*cos(th)"], ["m*l*slope*cos(th)", "m*l^2"]]
velocity_force = ["2*m*slope*slope_1*dot(s)^2 - m*l*slope*sin(th)*dot(th)^2", "m*l*slope_1*cos(th)*dot(s)^2"]
)toml")
            .empty());
}

TEST_CASE("a commanded acceleration: the force -m*a works, as the message suggests") {
  const std::string text = found(cart_pole + R"toml([[point]]
name = "bob"
at = ["x + l*sin(theta)", "l*cos(theta)"]
mass = "m"
[[input]]
name = "acc"
[[constraint]]
name = "command"
kind = "velocity"
equation = "dot(dot(x)) = acc"
)toml");
  CHECK(mentions(text, "error[E502]: `dot(dot(x))` is a second derivative"));
  CHECK(mentions(text, "omit the coordinate and give each mass the force -m*a"));
  CHECK_FALSE(mentions(found(pendulum + "[energy]\nV = \"dot(dot(theta))\"\n"), "-m*a"));
  CHECK(disproved(pendulum + R"toml([gravity]
vector = ["0", "-g"]
[[input]]
name = "acc"
[[force]]
at = "bob"
value = ["-m*acc", "0"]
[[expect]]
equations = ["l*dot(dot(theta)) = -g*sin(theta) - acc*cos(theta)"]
)toml")
            .empty());
}

TEST_CASE("the sign of the potential: a mass pushed upwards is noted") {
  CHECK(mentions(found(pendulum + "[energy]\nV = \"-m*g*y(bob)\"\n"),
                 "note[E512]: V falls as `bob` rises"));
  CHECK(mentions(found(pendulum + "[gravity]\nvector = [\"0\", \"g\"]\n"),
                 "note[E512]: gravity pulls along +y"));
  CHECK_FALSE(mentions(found(pendulum + "[gravity]\nvector = [\"0\", \"-g\"]\n"), "E512"));
}

}  // namespace elgen::test
