// Outputs with `motion = true`: an accelerometer and the force in a rod as functions of the state
// and the inputs, the total derivatives of outputs, and refused outputs.
#include <catch2/catch.hpp>

#include "numbers/exact_number.hpp"
#include "pipeline/constrained_testing.hpp"

namespace elgen::test {
namespace {

using cln::cl_R;

std::string output_of(const std::string& value, const std::string& more = "motion = true\n") {
  return "[[output]]\nname = \"sensor\"\nvalue = " + value + "\njacobian = true\n" + more;
}

std::string said(const std::string& model) {
  return format(run_pipeline(inputs_of(model, ""), {.goals = {Goal::self_check}}).diagnostics);
}

}  // namespace

TEST_CASE(
    "an accelerometer's values and derivatives are rows of the dynamics and their derivatives") {
  const Constrained system(
      model_file("cart_pole") + output_of("[\"dot(dot(x))\", \"dot(dot(theta)) + dot(theta)^2\"]"),
      "sensor,sensor_derivatives,forward_dynamics,forward_dynamics_derivatives");
  const State state = random_state(system);
  const auto a = system.exactly(OutputKind::forward_dynamics, "acceleration", state);
  check_field(system, OutputKind::user_value, "", state, {a[0], a[1] + state.v[1] * state.v[1]});
  const auto of = [&](const std::string& field) {
    return system.exactly(OutputKind::forward_dynamics_derivatives, field, state);
  };
  ExactNumbers by_velocity = of("by_velocity");
  by_velocity[3] = by_velocity[3] + 2 * state.v[1];
  const OutputKind kind = OutputKind::user_derivatives;
  REQUIRE(system.function(kind).fields.size() == 3);
  check_digits(system.exactly(kind, "by_position", state), of("by_position"), 50);
  check_digits(system.exactly(kind, "by_velocity", state), by_velocity, 50);
  check_digits(system.exactly(kind, "by_input", state), of("by_input"), 50);
}

TEST_CASE("the force in a rod is a function of the state") {
  const Constrained system(model_file("pendulum_xy") + output_of("\"2*l*lambda(rod)\""),
                           "sensor,sensor_derivatives,forward_dynamics");
  State state = system.nominal();
  state.q = {cln::cl_RA(3) / 5, cln::cl_RA(-4) / 5};
  state.v = {2, cln::cl_RA(3) / 2};
  const auto lambda = system.exactly(OutputKind::forward_dynamics, "multipliers", state);
  const std::size_t l = 1;
  REQUIRE(system.model().parameters[l].name == "l");
  check_field(system, OutputKind::user_value, "", state, {2 * state.parameters[l] * lambda[0]});
  // At q.q = l^2 = 1: lambda = -m (v.v - g y)/2 - m zeta omega q.v
  const cl_R m = state.parameters[0];
  const cl_R gain = state.parameters[3] * state.parameters[4];
  const auto slope = [&](std::size_t i) {
    return -2 * state.parameters[l] * m * (state.v[i] + gain * state.q[i]);
  };
  check_digits(system.exactly(OutputKind::user_derivatives, "by_velocity", state),
               {slope(0), slope(1)}, 50);
}

TEST_CASE("outputs of the motion agree with the oracle") {
  for (const auto& [name, value] :
       {std::pair("four_bar", "[\"lambda(pin_x)*cos(a)\", \"dot(dot(b))\"]"),
        std::pair("rolling_disc", "\"lambda(roll_1)*dot(psi)\""),
        std::pair("pendulum_in_lift", "\"dot(dot(theta))\"")}) {
    INFO(name);
    const std::string found = said(model_file(name) + output_of(value));
    CHECK_THAT(found, !Catch::Contains("error"));
  }
}

TEST_CASE("the acceleration of a locked coordinate is the second derivative of its law") {
  const Constrained system(model_file("two_link_arm") + output_of("\"dot(dot(q1))\"", ""), "sensor",
                           "[outputs]\nsensor = true\n[lock]\nq1 = { value = \"3*t^2 + t\" }\n");
  const State state = random_state(system);
  check_field(system, OutputKind::user_value, "", state, {6});
}

TEST_CASE("multipliers are allowed only in outputs of the motion") {
  using Catch::Contains;
  CHECK_THAT(said(model_file("cart_pole") + output_of("\"lambda(rod)\"")),
             Contains("E201") && Contains("unknown constraint `rod`"));
  CHECK_THAT(said(model_file("pendulum_xy") + output_of("\"lambda(rod)\"", "")),
             Contains("is a multiplier, but an output takes none") &&
                 Contains("it is allowed in an `[[output]]` with `motion = true`"));
  CHECK_THAT(said(model_file("pendulum_xy") + output_of("\"lambda(rood)\"")),
             Contains("did you mean `rod`?"));
  CHECK_THAT(said(model_file("pendulum_xy") + output_of("\"2*l*lambda_rod\"")), !Contains("error"));
  CHECK_THAT(said(model_file("snakeboard") +
                  "[[output]]\nname = \"pose\"\nframe = \"board\"\nmotion = true\n"),
             Contains("E112") && Contains("`motion` needs a `value`"));
}

}  // namespace elgen::test
