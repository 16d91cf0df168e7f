// Which method, by which steps, for which system: what is refused, and why.
#include "simulate/method_choice.hpp"

#include <catch2/catch.hpp>

#include "simulate/compiled_model.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string message(const Diagnostics& diagnostics) {
  if (diagnostics.empty()) return "";
  const Diagnostic& first = diagnostics.front();
  return std::string(code_row(first.code).name) + " " + first.message +
         (first.hint.empty() ? "" : " | " + first.hint);
}

std::string rule_of(const SimulationOptions& options) {
  return message(step_rule(*find_method(options.method), options).diagnostics);
}

/// What a method says of a model.
std::string method_refusal(const std::string& method, const std::string& text,
                           const SceneOptions& scene = {}, std::optional<double> hold = {}) {
  const CompiledSystem compiled(text, scene);
  SimulationOptions options;
  options.hold = hold;
  return message(
      refuse_method(*find_method(method), compiled.checked(), compiled.program(), options));
}

std::string plane(const std::string& rest) {
  return model_text("plane", "[[coordinate]]\nname = \"x\"\n[[coordinate]]\nname = \"y\"\n" + rest);
}

const std::string separable =
    "[energy]\nT = \"dot(x)^2 + dot(x)*dot(y) + dot(y)^2\"\nV = \"x*y\"\n";

}  // namespace

TEST_CASE("methods have names") {
  CHECK(find_method("rk4")->name == "rk4");
  CHECK(message(find_method("rk5").diagnostics) ==
        "E620 unknown method `rk5` | did you mean `rk4`?");
  CHECK(message(find_method("gauss").diagnostics) ==
        "E620 unknown method `gauss` | one of euler, verlet, midpoint, rk4, dopri5, fehlberg78");
}

TEST_CASE("times, steps and tolerances are positive, and one rule decides the steps") {
  CHECK(rule_of({.time = 1}).empty());
  CHECK(step_rule(*find_method("dopri5"), {.time = 1})->tolerance == 1e-9);
  CHECK(rule_of({.time = -1}) == "E621 `--time -1` is not a positive number");
  CHECK(rule_of({.from = 1.0 / 0.0, .time = 1}) == "E621 `--from inf` is not a number");
  CHECK(rule_of({.time = 1, .step = 0}) == "E621 `--step 0` is not a positive number");
  CHECK(rule_of({.time = 1, .tolerance = 0}) == "E621 `--tolerance 0` is not a positive number");
  CHECK(rule_of({.time = 1, .hold = -2}) == "E621 `--hold -2` is not a positive number");
  CHECK(rule_of({.time = 1, .step = 0.1, .tolerance = 0.1}) ==
        "E621 `--step` and `--tolerance` are given, but one follows from the other");
  CHECK(rule_of({.time = 1, .every = 2}) ==
        "E621 `--every 2` is longer than the whole run, `--time 1`");
  CHECK(rule_of({.method = "rk4", .time = 1}) == "E621 `rk4` needs a step | give it `--step`");
  CHECK(rule_of({.method = "rk4", .time = 1, .tolerance = 1e-3}) ==
        "E621 `rk4` does not choose its steps by a tolerance | give it `--step`, or take `dopri5` "
        "or `fehlberg78`");
}

TEST_CASE("verlet takes what is separable") {
  const std::string midpoint = " | `midpoint` is symplectic there too";
  const std::string refused = "E622 `verlet` is not for this system: ";
  CHECK(method_refusal("verlet", plane(separable)).empty());
  CHECK(method_refusal("verlet", plane("[energy]\nT = \"x^2*dot(x)^2 + dot(y)^2\"\n")) ==
        refused + "M depends on `x`" + midpoint);
  CHECK(method_refusal("verlet", plane("[energy]\nT = \"exp(t)*dot(x)^2 + dot(y)^2\"\n")) ==
        refused + "M depends on `t`" + midpoint);
  CHECK(method_refusal("verlet", plane("[energy]\nL = \"-sqrt(1 - dot(x)^2) + dot(y)^2\"\n")) ==
        refused + "M depends on `dot(x)`" + midpoint);
  CHECK(method_refusal("verlet", plane("[energy]\nL = \"dot(x)^2 + dot(y)^2 + x*dot(y)\"\n")) ==
        refused + "L has terms linear in the rates" + midpoint);
  CHECK(method_refusal("verlet", plane("[energy]\nL = \"dot(x)^2 + dot(y)^2 + 3*dot(y)\"\n")) ==
        refused + "L has terms linear in the rates" + midpoint);
  CHECK(method_refusal("verlet", plane(separable + "D = \"dot(y)^2\"\n")) ==
        refused + "a force depends on `dot(y)`" + midpoint);
}

TEST_CASE("verlet takes laws of inputs that do not depend on rates, or are held") {
  const std::string driven = plane(separable + "[[input]]\nname = \"u\"\non = \"x\"\n");
  CHECK(method_refusal("verlet", driven, start_options("", "u=-x + sin(t)")).empty());
  CHECK(method_refusal("verlet", driven, start_options("", "u=-dot(x)")) ==
        "E622 `verlet` is not for this system: the law of `u` depends on rates | `midpoint` is "
        "symplectic there too");
  CHECK(method_refusal("verlet", driven, start_options("", "u=-dot(x)"), 0.1).empty());
}

TEST_CASE("rotations are for the methods that normalise them") {
  const std::string body = model_text("body", R"toml([[coordinate]]
name = "e"
kind = "rotation"
[parameters]
J = 1
[[frame]]
name = "F"
parent = "world"
rotation = "e"
[[body]]
name = "B"
frame = "F"
inertia = ["J", "J", "J"]
)toml");
  for (const std::string method : {"verlet", "midpoint"}) {
    CHECK(method_refusal(method, body) ==
          "E622 `" + method +
              "` is not for this system: `e` is a rotation | `rk4`, "
              "`dopri5` and `fehlberg78` take rotations");
  }
  CHECK(method_refusal("dopri5", body).empty());
}
