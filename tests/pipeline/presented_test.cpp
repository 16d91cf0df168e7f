// A sensor of a milligram on an arm: what drop_below leaves out, states, and saves.
#include "pipeline/presented.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>

#include "elgen/certificate.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/pipeline.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const std::string model_path = ELGEN_SOURCE_DIR "/models/arm_with_sensor.toml";

/// Everything that `drop_below` reduces.
constexpr std::string_view scene_text = R"toml(format = 1
model = "arm_with_sensor.toml"
name = "light"

[outputs]
mass_matrix = true
coriolis_matrix = true
velocity_force = true
gravity = true
potential_energy = true
drift = true
dissipation = true
applied_force = true
bias = true
momentum = true
kinetic_energy = true
total_energy = true
energy_function = true
input_matrix = true
inverse_dynamics = true
dynamics = true
)toml";

Products run(const std::string& more) {
  const Inputs inputs{make_source("arm_with_sensor.toml", read_text(model_path)),
                      make_source("light.scene.toml", std::string(scene_text) + more)};
  Products products = run_pipeline(inputs, {});
  INFO(format(products.diagnostics));
  REQUIRE(products.files);
  return products;
}

const Products& exact() {
  static const Products products = run("");
  return products;
}

const Products& light() {
  static const Products products = run("[approximate]\ndrop_below = 1e-3\n");
  return products;
}

double to_double(const cln::cl_R& value) { return ScalarTraits<double>::from_real(value); }

double within(std::mt19937& random, const std::optional<Interval>& range, double otherwise) {
  const double low = range ? to_double(range->low) : -otherwise;
  const double high = range ? to_double(range->high) : otherwise;
  return low + (high - low) * std::generate_canonical<double, 53>(random);
}

Arguments<double> state_in(const Model& model, std::mt19937& random) {
  Arguments<double> state;
  for (const Parameter& parameter : model.parameters) {
    const auto& range = model.parameter_arrays[parameter.array].range;
    state.parameters.push_back(range ? within(random, range, 0) : to_double(parameter.value));
  }
  for (const Coordinate& q : model.coordinates) state.q.push_back(within(random, q.range, 1));
  for (const Velocity& v : model.velocities) state.v.push_back(within(random, v.rate_range, 1));
  for (std::size_t i = 0; i < state.v.size(); ++i) state.a.push_back(within(random, {}, 10));
  state.u.assign(model.inputs.size(), 0);
  return state;
}

double stated(const EntryError& error, const Arguments<double>& state) {
  double bound = to_double(error.constant);
  for (std::size_t j = 0; j < error.by_acceleration.size(); ++j) {
    bound += to_double(error.by_acceleration[j]) * std::abs(state.a[j]);
  }
  return bound;
}

/// Largest |reduced - exact| / stated bound of each output, over so many states.
std::map<std::string, double> measured(std::size_t states) {
  const Program& reduced = *light().program;
  const Program& whole = *exact().program;
  std::map<std::string, double> worst;
  std::mt19937 random(7);
  for (std::size_t s = 0; s < states; ++s) {
    const Arguments<double> state = state_in(light().checked->model, random);
    for (std::size_t f = 0; f < whole.functions.size(); ++f) {
      const ReducedOutput* output = find_reduced(*reduced.reduction, whole.functions[f].kind);
      if (output == nullptr) continue;
      const std::vector<double> x = evaluate(reduced, reduced.functions[f], state);
      const std::vector<double> truth = evaluate(whole, whole.functions[f], state);
      for (std::size_t i = 0; i < x.size(); ++i) {
        const double bound = stated(output->errors[i], state) + 1e-13 * std::abs(truth[i]);
        if (bound == 0) continue;
        double& figure = worst[whole.functions[f].name];
        figure = std::max(figure, std::abs(x[i] - truth[i]) / bound);
      }
    }
  }
  return worst;
}

std::size_t operations(const Program& program) {
  std::size_t total = 0;
  for (const Function& function : program.functions) {
    if (function.kind != OutputKind::dynamics) total += cost(count_operations(function));
  }
  return total;
}

}  // namespace

TEST_CASE("the sensor's terms are listed") {
  const std::string page = dropped_page(light().checked->model, *light().program);
  const std::size_t first = page.find("\n\n") + 2;
  CHECK(page.substr(first, page.find("\n\n", first) - first) ==
        "entry             dropped term           at most\n"
        "mass_matrix[1,1]  ms*h^2                 1e-8 kg*m^2\n"
        "mass_matrix[1,1]  ms*l2^2                1.6e-7 kg*m^2\n"
        "mass_matrix[1,1]  -2*ms*l1*h*sin(q2)     1e-7 kg*m^2\n"
        "mass_matrix[1,1]  2*ms*l1*l2*cos(q2)     4e-7 kg*m^2\n"
        "mass_matrix[1,1]  ms*l1^2                2.5e-7 kg*m^2\n"
        "mass_matrix[1,2]  ms*h^2                 1e-8 kg*m^2\n"
        "mass_matrix[1,2]  ms*l2^2                1.6e-7 kg*m^2\n"
        "mass_matrix[1,2]  -ms*l1*h*sin(q2)       5e-8 kg*m^2\n"
        "mass_matrix[1,2]  ms*l1*l2*cos(q2)       2e-7 kg*m^2\n"
        "mass_matrix[2,2]  ms*h^2                 1e-8 kg*m^2\n"
        "mass_matrix[2,2]  ms*l2^2                1.6e-7 kg*m^2\n"
        "potential_energy  ms*h*g*sin(q1 + q2)    9.81e-7 J\n"
        "potential_energy  -ms*l2*g*cos(q1 + q2)  3.93e-6 J\n"
        "potential_energy  -ms*l1*g*cos(q1)       4.91e-6 J");
}

TEST_CASE("the measured error stays below the stated bound, and is of its size") {
  const auto worst = measured(100'000);
  CHECK(worst.size() == 11);
  for (const auto& [output, figure] : worst) {
    INFO(output << " " << figure);
    CHECK(figure <= 1);
    CHECK(figure >= 0.01);
  }
}

TEST_CASE("the reduced code costs less") {
  const std::size_t before = operations(*exact().program);
  const std::size_t after = operations(*light().program);
  INFO(before << " -> " << after);
  CHECK(after < before);
}

TEST_CASE("self-check and verification hold") {
  CHECK(light().self_check->failure.empty());
  CHECK(light().self_check->states >= 2);
  VerifyOptions options;
  options.quick = true;
  const auto& [model, scene] = *light().checked;
  const Verification found = verify(model, scene, *light().program, {}, options);
  INFO(to_text(found.certificate));
  CHECK(holds(found.certificate));
}

TEST_CASE("a mistake beyond the stated bound is found") {
  Program broken = *light().program;
  for (ReducedOutput& output : broken.reduction->outputs) {
    for (EntryError& error : output.errors) error.constant = error.constant / 1000;
  }
  const auto& [model, scene] = *light().checked;
  CHECK_FALSE(self_check(model, scene, broken).failure.empty());
}

TEST_CASE("the header says that it is approximate") {
  const std::string& header =
      light().files->files.at("arm_with_sensor_light/arm_with_sensor_light.hpp");
  CHECK(header.find("Approximate: ") != std::string::npos);
  const std::string& page =
      light().files->files.at("arm_with_sensor_light/arm_with_sensor_light.md");
  CHECK(page.find("## Dropped terms") != std::string::npos);
}
