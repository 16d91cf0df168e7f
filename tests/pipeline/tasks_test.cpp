// Equations of motion along an output, the inverse of M, derivatives of input forces, and rates
// completed by constraints: closed forms, defining equations, and refused requests.
#include <catch2/catch.hpp>

#include "numbers/exact_number.hpp"
#include "pipeline/constrained_testing.hpp"
#include "support/matrices.hpp"

namespace elgen::test {
namespace {

using cln::cl_R;

ExactNumbers transposed(const ExactNumbers& a, std::size_t columns) {
  ExactNumbers result;
  for (std::size_t j = 0; j < columns; ++j) {
    for (std::size_t i = j; i < a.size(); i += columns) result.push_back(a[i]);
  }
  return result;
}

ExactNumbers sum(ExactNumbers a, const ExactNumbers& b, int factor = 1) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] + factor * b[i];
  return a;
}

ExactNumbers identity(std::size_t n) {
  ExactNumbers result(n * n);
  for (std::size_t i = 0; i < n; ++i) result[i * n + i] = 1;
  return result;
}

/// Checks that each entry differs from the expected entry by at most 10^-digits.
void check_equal(const ExactNumbers& found, const ExactNumbers& expected, int digits = 45) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    INFO("entry " << i << ": " << double_of(found[i]) << " instead of " << double_of(expected[i]));
    CHECK(cln::abs(found[i] - expected[i]) <= power_of_ten(-digits));
  }
}

std::string refusal(const std::string& model, const std::string& scene) {
  return format(run_pipeline(inputs_of(model, scene), {.goals = {Goal::choose}}).diagnostics);
}

std::string completing(const std::string& independent) {
  return "[outputs]\ncompleted = { independent = " + independent + " }\n";
}

constexpr const char* hand = R"toml(
[[output]]
name     = "hand"
frame    = "link7"
jacobian = true
)toml";

}  // namespace

TEST_CASE("a particle in polar coordinates has its mass and weight along Cartesian axes") {
  const Constrained system(model_file("kepler_polar") +
                               "[[output]]\nname = \"place\"\nvalue = [\"x(body)\", \"y(body)\"]\n"
                               "jacobian = true\n",
                           "place_operational,inverse_mass_matrix");
  const State state = random_state(system);
  const cl_R& m = state.parameters[0];
  const cl_R& mu = state.parameters[1];
  const cl_R& r = state.q[0];
  const OutputKind kind = OutputKind::user_operational;
  const cl_R force = mu * m / (r * r);
  const cl_R phi = cln::cl_float(state.q[1], cln::float_format(100));
  const cl_R c = cln::cos(phi);
  const cl_R s = cln::sin(phi);
  check_equal(system.exactly(kind, "inertia", state), {m, 0, 0, m});
  check_equal(system.exactly(kind, "bias", state), {force * c, force * s});
  check_equal(system.exactly(kind, "inverse_jacobian", state), {c, s, -s / r, c / r});
  check_equal(system.exactly(OutputKind::inverse_mass_matrix, "", state),
              {1 / m, 0, 0, 1 / (m * r * r)});
}

TEST_CASE("forces along a twist accelerate it as the equation along the twist says") {
  const Constrained system(model_file("panda7") + hand,
                           "hand_operational,hand_jacobian,hand_bias,inverse_mass_matrix,"
                           "mass_matrix,bias");
  const State state = random_state(system);
  const std::size_t n = 7;
  const std::size_t k = 6;
  const OutputKind kind = OutputKind::user_operational;
  const ExactNumbers j = system.exactly(OutputKind::user_jacobian, "", state);
  const ExactNumbers inertia = system.exactly(kind, "inertia", state);
  const ExactNumbers inverse = system.exactly(OutputKind::inverse_mass_matrix, "", state);
  check_equal(product(system.exactly(OutputKind::mass_matrix, "", state), inverse, n), identity(n));
  check_equal(product(inertia, product(j, product(inverse, transposed(j, n), n), n), k),
              identity(k));
  check_equal(product(j, system.exactly(kind, "inverse_jacobian", state), n), identity(k));
  const ExactNumbers force{3, -1, 2, 5, -4, 1};
  const ExactNumbers moving =
      sum(product(transposed(j, n), force, k), system.exactly(OutputKind::bias, "", state), -1);
  const ExactNumbers rate = sum(product(j, product(inverse, moving, n), n),
                                system.exactly(OutputKind::user_bias, "", state));
  check_equal(sum(product(inertia, rate, k), system.exactly(kind, "bias", state)), force, 40);
}

TEST_CASE("forces of inputs rotate with their point") {
  const Constrained system(R"toml(format = 1
[model]
name = "pushed"
[[coordinate]]
name = "theta"
unit = "rad"
[parameters]
m = { value = 2, unit = "kg" }
l = { value = 3, unit = "m" }
[[point]]
name = "bob"
at = ["l*sin(theta)", "-l*cos(theta)"]
mass = "m"
[[input]]
name = "f"
at = "bob"
)toml",
                           "input_force_derivatives");
  const State state = random_state(system);
  const cl_R l = state.parameters[1];
  const cl_R theta = cln::cl_float(state.q[0], cln::float_format(100));
  const cl_R expected = l * (state.u[1] * cln::cos(theta) - state.u[0] * cln::sin(theta));
  check_field(system, OutputKind::input_force_derivatives, "", state, {expected});
}

TEST_CASE("constraints complete rates and accelerations") {
  const std::string outputs = "completed,constraint_residual,constraint_jacobian,constraint_bias";
  for (const auto& [name, names] :
       {std::pair("five_bar", "[\"a1\", \"a2\"]"), std::pair("five_bar", "[\"b1\", \"a2\"]"),
        std::pair("four_bar", "[\"a\"]"), std::pair("slider_crank", "[\"b\"]"),
        std::pair("rolling_disc", "[\"psi\", \"phi\"]"),
        std::pair("chaplygin_sleigh", "[\"x\", \"theta\"]"),
        std::pair("ball_on_turntable", "[\"attitude\"]")}) {
    INFO(name << " " << names);
    const Constrained system(model_file(name), outputs, completing(names));
    const State state = random_state(system);
    const OutputKind kind = OutputKind::completed;
    State completed = state;
    completed.v = system.exactly(kind, "rates", state);
    completed.a = system.exactly(kind, "accelerations", state);
    check_equal(completed.v, system.truth(kind, "rates", state));
    check_equal(completed.a, system.truth(kind, "accelerations", state));
    REQUIRE_FALSE(system.function(kind).independent.empty());
    for (const std::uint32_t i : system.function(kind).independent) {
      check_equal({completed.v[i], completed.a[i]}, {state.v[i], state.a[i]});
    }
    const std::size_t m = system.model().constraints.size();
    check_equal(system.exactly(OutputKind::constraint_residual, "rate", completed),
                ExactNumbers(m));
    check_equal(sum(product(system.exactly(OutputKind::constraint_jacobian, "", completed),
                            completed.a, completed.a.size()),
                    system.exactly(OutputKind::constraint_bias, "", completed)),
                ExactNumbers(m));
  }
}

TEST_CASE("independent velocities that do not determine the others are refused") {
  using Catch::Contains;
  const std::string linkage = model_file("five_bar");
  CHECK_THAT(
      refusal(linkage, completing("[\"a1\"]")),
      Contains("E603") &&
          Contains(
              "as many independent velocities as the constraints leave free, 2, but 1 is named"));
  CHECK_THAT(refusal(linkage, completing("[\"a1\", \"a3\"]")),
             Contains("E612") && Contains("unknown coordinate `a3`"));
  CHECK_THAT(
      refusal(linkage, "[outputs]\ncompleted = true\n"),
      Contains("E603") && Contains("needs independent velocities: name them in `[outputs]`"));
  CHECK_THAT(refusal(linkage, "[outputs]\nbias = { independent = [\"a1\"] }\n"),
             Contains("E103") && Contains("`completed` has it"));
  CHECK_THAT(refusal(model_file("rolling_disc"), completing("[\"x\", \"y\"]")),
             Contains("E603") && Contains("rank 1 of 2 in A"));
  CHECK_THAT(refusal(model_file("cart_pole"), completing("[\"x\"]")),
             Contains("E603") && Contains("needs a `[[constraint]]`"));
}

TEST_CASE("outputs with dependent rows or under constraints have no equation of motion") {
  using Catch::Contains;
  const std::string twice =
      "[[output]]\nname = \"y\"\nvalue = [\"q1\", \"2*q1\"]\njacobian = true\n";
  const std::string wanted = "[outputs]\ny_operational = true\n";
  CHECK_THAT(refusal(model_file("two_link_arm") + twice, wanted),
             Contains("E603") && Contains("its Jacobian has rank 1 of 2"));
  const std::string flat = "[[output]]\nname = \"y\"\nframe = \"board\"\njacobian = true\n";
  CHECK_THAT(refusal(model_file("snakeboard") + flat, wanted),
             Contains("E539") && Contains("does not support constraints"));
  CHECK_THAT(
      refusal(model_file("two_link_arm") + "[[output]]\nname = \"y\"\nvalue = \"q1\"\n", wanted),
      Contains("E603") && Contains("needs `jacobian = true`"));
}

}  // namespace elgen::test
