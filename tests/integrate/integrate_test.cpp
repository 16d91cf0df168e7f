// Steps: what they are refused for, and what they call.
#include "elgen/integrate.hpp"

#include <catch2/catch.hpp>

#include "integrate/stepping.hpp"

namespace elgen::test {
namespace {

std::string refusal(const std::string& model, const std::string& method) {
  return format(stepped({model, method}).diagnostics);
}

}  // namespace

TEST_CASE("verlet is refused where it is not symplectic, and says why") {
  CHECK_THAT(refusal(model_file("cart_pole"), "verlet"),
             Catch::Contains("E622") &&
                 Catch::Contains("`verlet` is not for this system: M depends on `theta`") &&
                 Catch::Contains("next.scene.toml:5:1"));
  CHECK_THAT(refusal(model_file("free_body"), "verlet"), Catch::Contains("is a rotation"));
  CHECK_THAT(refusal(model_file("two_mass_damper"), "verlet"),
             Catch::Contains("a force depends on `dot(x1)`"));
}

TEST_CASE("midpoint is refused where p is not M v + b of the coordinates") {
  CHECK_THAT(refusal(model_file("free_body"), "midpoint"),
             Catch::Contains("`midpoint` is not for this system: `attitude` is a rotation") &&
                 Catch::Contains("`rk4` takes any model"));
  CHECK_THAT(refusal(model_file("relativistic_particle"), "midpoint"),
             Catch::Contains("E622") && Catch::Contains("L is not quadratic in the rates"));
}

TEST_CASE("what midpoint calls is computed together, in the form that is asked for") {
  const CheckedModel checked = checked_model(shaken);
  OutputRequest step{.kind = OutputKind::step, .user = 2, .form = Form::closed};
  const std::vector<OutputRequest> needed = needed_for_step(checked.model, step);
  CHECK(needed.size() == 7);
  CHECK(needed.back().kind == OutputKind::dynamics);
  for (const OutputRequest& each : needed) CHECK(each.form == Form::closed);
}

TEST_CASE("a step calls the form that is asked for, and is judged by what it needs") {
  const CheckedModel checked = checked_model(shaken);
  OutputRequest step{.kind = OutputKind::step, .user = 1};
  step.form = Form::recursive;
  const std::vector<OutputRequest> needed = needed_for_step(checked.model, step);
  REQUIRE(needed.size() == 4);
  CHECK(needed[0].kind == OutputKind::mass_matrix);
  CHECK_FALSE(needed[0].form);
  CHECK(needed.back().kind == OutputKind::forward_dynamics);
  CHECK(needed.back().form == Form::recursive);
}

}  // namespace elgen::test
