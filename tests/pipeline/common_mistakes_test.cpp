// What goes wrong in written derivations: each is caught with its own message, or cannot be
// written.
#include <catch2/catch.hpp>

#include "elgen/pipeline.hpp"

namespace elgen {

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
  PipelineOptions options;
  options.goals = {Goal::emit};
  return format(run_pipeline({make_source("model.toml", text), nullptr}, options).diagnostics);
}

/// The wrong entries of [[expect]], as `verify` finds them.
std::string disproved(const std::string& text) {
  PipelineOptions options;
  options.goals = {Goal::emit};
  options.scene.large_expectations = true;
  Products products = run_pipeline({make_source("model.toml", text), nullptr}, options);
  const auto& [model, scene] = *products.checked;
  VerifyOptions quick;
  quick.quick = true;
  quick.forms = &*products.closed_forms;
  return format(verify(model, scene, *products.program, {}, quick).diagnostics);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("too many coordinates: the direction is named") {
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
  CHECK(has(text, "error[E501]: the motion `q1 : q2 = 1 : -1` has no kinetic energy"));
}

TEST_CASE("too many coordinates: a direction that turns is named where it is") {
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
  CHECK(has(text, "error[E501]: rank 2 of 3 at every sampled configuration: the motion `x : r : "));
}

TEST_CASE("velocities without the chain rule cannot be given to a point") {
  const std::string text = found(cart_pole + R"toml([[point]]
name = "bob"
at = ["x + l*sin(theta)*dot(theta)", "l*cos(theta)"]
mass = "m"
)toml");
  CHECK(has(text, "error[E319]"));
  CHECK(has(text, "a position takes none"));
}

TEST_CASE("a kinetic energy without its cross term is disproved, with both values") {
  const std::string text = disproved(cart_pole + R"toml([energy]
T = "1/2*M*dot(x)^2 + 1/2*m*(dot(x)^2 + l^2*dot(theta)^2)"
V = "m*g*l*cos(theta)"
[[expect]]
mass_matrix = [["M + m", "m*l*cos(theta)"], ["m*l*cos(theta)", "m*l^2"]]
)toml");
  CHECK(has(text, "error[E510]: mass_matrix[1,2] is "));
  CHECK(has(text, " by this form, 0 as derived, "));
}

TEST_CASE("the same by points holds, and is proved") {
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

TEST_CASE("the sign of the potential: a mass that is pushed up is noted") {
  CHECK(has(found(pendulum + "[energy]\nV = \"-m*g*y(bob)\"\n"),
            "note[E512]: V falls as `bob` rises"));
  CHECK(has(found(pendulum + "[gravity]\nvector = [\"0\", \"g\"]\n"),
            "note[E512]: gravity pulls along +y"));
  CHECK(found(pendulum + "[gravity]\nvector = [\"0\", \"-g\"]\n").find("E512") ==
        std::string::npos);
}

}  // namespace elgen
