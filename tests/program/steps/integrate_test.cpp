// Steps: refused systems, required outputs, and called functions.
#include "elgen/integrate.hpp"

#include <catch2/catch.hpp>

#include "program/steps/methods.hpp"
#include "program/steps/stepping.hpp"

namespace elgen::test {
namespace {

std::string refusal(const std::string& model, const std::string& method) {
  return format(stepped({model, method}).diagnostics);
}

std::string obstacle(const std::string& energies) {
  const std::string text = model_text(
      "plane", "[[coordinate]]\nname = \"x\"\n[[coordinate]]\nname = \"y\"\n[energy]\n" + energies);
  const Products products =
      run_pipeline({make_source("plane.toml", text), nullptr},
                   {.scene = {.outputs = {make_source("outputs", "mass_matrix, momentum, bias")}},
                    .goals = {Goal::choose}});
  return nonseparable_reason(*products.checked, *products.program);
}

Model point(const std::string& potential) {
  return checked_model(model_text("point",
                                  "[[coordinate]]\nname = \"x\"\n[energy]\n"
                                  "T = \"1/2*dot(x)^2\"\nV = \"" +
                                      potential + "\"\n"))
      .model;
}

}  // namespace

TEST_CASE("verlet is refused with a reason if it is not symplectic") {
  CHECK_THAT(refusal(model_file("cart_pole"), "verlet"),
             Catch::Contains("E622") &&
                 Catch::Contains("`verlet` does not apply to this system: M depends on `theta`") &&
                 Catch::Contains("next.scene.toml:5:1"));
  CHECK_THAT(refusal(model_file("free_body"), "verlet"), Catch::Contains("is a rotation"));
  CHECK_THAT(refusal(model_file("two_mass_damper"), "verlet"),
             Catch::Contains("a force depends on `dot(x1)`"));
}

TEST_CASE("midpoint is refused unless p = M v + b with coordinates only") {
  CHECK_THAT(
      refusal(model_file("free_body"), "midpoint"),
      Catch::Contains("`midpoint` does not apply to this system: `attitude` is a rotation") &&
          Catch::Contains("`rk4` takes any model"));
  CHECK_THAT(refusal(model_file("relativistic_particle"), "midpoint"),
             Catch::Contains("E622") && Catch::Contains("L is not quadratic in the rates"));
}

TEST_CASE("the outputs of a midpoint step are computed together, in the requested form") {
  const CheckedModel checked = checked_model(shaken);
  OutputRequest step{
      .kind = OutputKind::step, .form = Form::closed, .step = default_step(StepMethod::midpoint)};
  const std::vector<OutputRequest> needed = outputs_for_step(checked.model, step);
  CHECK(needed.size() == 7);
  CHECK(needed.back().kind == OutputKind::dynamics);
  for (const OutputRequest& each : needed) CHECK(each.form == Form::closed);
}

TEST_CASE("a step calls the requested form, and its requirements have no form") {
  const CheckedModel checked = checked_model(shaken);
  OutputRequest step{.kind = OutputKind::step, .step = default_step(StepMethod::verlet)};
  step.form = Form::recursive;
  const std::vector<OutputRequest> needed = outputs_for_step(checked.model, step);
  REQUIRE(needed.size() == 4);
  CHECK(needed[0].kind == OutputKind::mass_matrix);
  CHECK_FALSE(needed[0].form);
  CHECK(needed.back().kind == OutputKind::forward_dynamics);
  CHECK(needed.back().form == Form::recursive);
}

TEST_CASE("verlet needs a constant M, and forces and L without rates except in T") {
  const std::string kinetic = "T = \"dot(x)^2 + dot(x)*dot(y) + dot(y)^2\"\n";
  CHECK(obstacle(kinetic + "V = \"x*y + sin(t)*x\"\n").empty());
  CHECK(obstacle("T = \"x^2*dot(x)^2 + dot(y)^2\"\n") == "M depends on `x`");
  CHECK(obstacle("T = \"exp(t)*dot(x)^2 + dot(y)^2\"\n") == "M depends on `t`");
  CHECK(obstacle("L = \"-sqrt(1 - dot(x)^2) + dot(y)^2\"\n") == "M depends on `dot(x)`");
  for (const std::string linear : {"x*dot(y)", "3*dot(y)"}) {
    CHECK(obstacle("L = \"dot(x)^2 + dot(y)^2 + " + linear + "\"\n") ==
          "L has terms linear in the rates");
  }
  CHECK(obstacle(kinetic + "D = \"dot(y)^2\"\n") == "a force depends on `dot(y)`");
}

TEST_CASE("time advances if the model depends on it") {
  for (const bool moves : {false, true}) {
    const CheckedModel checked{point(moves ? "x*sin(t)" : "x^2"), {}};
    const StepCallees calls;
    Program program;
    Function function;
    Composition compose(program, function);
    const OutputRequest request{.step = StepSpec{.iterations = 3}};
    const StepContext step(checked, request, calls, compose);
    CHECK(step.iterations == 3);
    const std::size_t size = function.instructions.size();
    const std::uint32_t later = step.time_after(step.half_step);
    CHECK(function.instructions.size() == size + (moves ? 1 : 0));
    if (moves) CHECK(function.instructions[later].opcode == Opcode::add);
  }
}

}  // namespace elgen::test
