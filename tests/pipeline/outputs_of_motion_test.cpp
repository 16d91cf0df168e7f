// Outputs that depend on rates, accelerations or inputs: values, derivatives, arguments, refusals.
#include <catch2/catch.hpp>

#include "model/requests.hpp"
#include "numbers/exact_number.hpp"
#include "pipeline/pipeline_testing.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen::test {
namespace {

/// A pendulum on a cart. The bob is an IMU that rotates freely. `output` is appended.
std::string carried(const std::string& output) {
  return R"toml(format = 1
[model]
name = "carried"
[[coordinate]]
name = "x"
unit = "m"
[[coordinate]]
name = "theta"
unit = "rad"
[[coordinate]]
name = "attitude"
kind = "rotation"
[parameters]
m = { value = 2, unit = "kg", assume = "positive" }
l = { value = 0.5, unit = "m", assume = "positive" }
J = { value = 0.3, unit = "kg*m^2", assume = "positive" }
g = { value = 9.81, unit = "m/s^2" }
[[frame]]
name = "bob"
parent = "world"
translate = ["x + l*sin(theta)", "0", "-l*cos(theta)"]
rotate = [["y", "-theta"]]
[[frame]]
name = "imu"
parent = "bob"
rotation = "attitude"
[[body]]
name = "imu"
frame = "imu"
mass = "m"
inertia = ["J", "2*J", "5/2*J"]
[gravity]
vector = ["0", "0", "-g"]
[[input]]
name = "u"
unit = "N"
on = "x"
)toml" + output;
}

const std::string sensors = R"toml([[output]]
name = "gyro"
value = ["wx(imu, imu)", "wy(imu, imu)", "wz(imu, imu)"]
jacobian = true
[[output]]
name = "accelerometer"
value = ["dot(dot(x(imu)))", "dot(dot(z(imu))) + g"]
jacobian = true
[[output]]
name = "power"
value = "u*dot(x)"
jacobian = true
[[output]]
name = "largest"
value = "max(dot(x), l*dot(theta))"
jacobian = true
)toml";

State random_state(const CheckedModel& checked) {
  State state = nominal_state(checked.model, checked.scene);
  const auto fill = [](std::vector<cln::cl_R>& leaves, int first) {
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      leaves[i] = cln::cl_RA(first + 7 * static_cast<int>(i)) / 10 - static_cast<int>(i);
    }
  };
  fill(state.q, 3);
  fill(state.v, 11);
  fill(state.a, -8);
  fill(state.u, 5);
  set_rational_quaternions(checked.model, state);
  return state;
}

std::vector<double> rounded(const std::vector<cln::cl_R>& values) {
  std::vector<double> result;
  for (const cln::cl_R& value : values) result.push_back(cln::double_approx(value));
  return result;
}

/// The diagnostics of a request for `outputs` of the model `carried`.
std::string refusal(const std::string& outputs) {
  const PipelineOptions options{.scene = {.outputs = {make_source("--outputs", outputs)}}};
  const Products products = run_pipeline(inputs_of(carried(sensors)), options);
  return format(products.diagnostics);
}

}  // namespace

TEST_CASE("outputs of rates, accelerations and inputs have the oracle's values and derivatives") {
  const Products products = derived(inputs_of(carried(sensors)));
  const State state = random_state(*products.checked);
  std::size_t compared = 0;
  for (const Function& function : products.program->functions) {
    const OutputRequest request =
        make_request(products.checked->model, function.kind, function.user);
    if (!output_row(function.kind).is_user_output) continue;
    INFO(function.name);
    const std::vector<double> truth =
        rounded(oracle_values(products.checked->model, request, state).value());
    const std::vector<double> found =
        evaluate(*products.program, function, arguments_at<double>(state));
    REQUIRE(found.size() == truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i) {
      CHECK(found[i] == Approx(truth[i]).margin(1e-12));
    }
    ++compared;
  }
  CHECK(compared == 7);
}

TEST_CASE("an output has derivatives by all its possible arguments") {
  const Products products = derived(inputs_of(carried(sensors)), "power_derivatives");
  const Function& function = products.program->functions.front();
  REQUIRE(function.fields.size() == 4);
  const State state = random_state(*products.checked);
  const std::vector<double> entries =
      evaluate(*products.program, function, arguments_at<double>(state));
  const double u = cln::double_approx(state.u[0]);
  const double v = cln::double_approx(state.v[0]);
  const std::vector<double> expected{0, 0, 0, 0, 0, u, 0, 0, 0, 0, 0, 0, 0, 0, 0, v};
  CHECK(entries == expected);
}

TEST_CASE("functions of outputs take only the arguments that they need") {
  const Products products = derived(inputs_of(carried(sensors)));
  REQUIRE(products.files);
  std::string header;
  for (const auto& [path, text] : products.files->files) {
    if (path.ends_with("carried.hpp")) header = text;
  }
  CHECK(mentions(header, "y = y(q, v)\n"));
  CHECK(mentions(header, "y = y(q, v, a)"));
  CHECK(mentions(header, "y = y(q, v, u)"));
}

TEST_CASE("derivatives that do not exist are refused") {
  CHECK(mentions(refusal("gyro_jacobian"),
                 "`gyro_jacobian` needs an output of positions; an output of rates, accelerations "
                 "or inputs has `gyro_derivatives`"));
  CHECK(mentions(refusal("largest_derivatives"),
                 "`largest_derivatives` needs outputs with derivatives, but `abs`, `sign`, `min` "
                 "and `max` have none"));
  CHECK(refusal("largest,gyro,gyro_derivatives").empty());
}

}  // namespace elgen::test
