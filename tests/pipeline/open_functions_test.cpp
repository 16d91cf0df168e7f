// Open functions in whole models: proofs, pages, and code in all languages. Callers of the code
// pass the values of a potential.
#include <catch2/catch.hpp>

#include "pipeline/pipeline_testing.hpp"

namespace elgen::test {

namespace {

constexpr const char* wanted_outputs =
    "[outputs]\ninverse_dynamics = true\npotential_energy = true\n"
    "inverse_dynamics_derivatives = true\n";

/// Passes V = -k/r to the code of the open model. Prints for each language whether the code gives
/// the values of the closed model.
constexpr const char* comparison = R"source(
#include "central_force_open_c/central_force_open_c.h"
#include "central_force_open_closed/central_force_open_closed.hpp"
#include "central_force_open_cpp/central_force_open_cpp_batch.hpp"
#include "central_force_open_cpp/central_force_open_cpp_eigen.hpp"
#include <cmath>
#include <cstdio>
#include <vector>

namespace o = central_force_open_cpp;
namespace closed = central_force_open_closed;
constexpr std::size_t states = 7;
double worst[5] = {};

void compare(int language, double x, double y) {
  if (!(std::fabs(x - y) <= worst[language])) worst[language] = std::fabs(x - y);
}

int main() {
  const o::Parameters<double> p{};
  const closed::Parameters<double> of_model{};
  const central_force_open_c_parameters in_c = CENTRAL_FORCE_OPEN_C_DEFAULT_PARAMETERS;
  const o::Velocities<double> v{{0.5, -0.75}};
  const o::Accelerations<double> a{{0.25, 2}};
  std::vector<double> all_f(3 * states), all_q(2 * states), all_v(2 * states), all_a(2 * states);
  std::vector<double> batch(2 * states), expected(2 * states);
  for (std::size_t i = 0; i < states; ++i) {
    const double r = 1 + 0.25 * static_cast<double>(i);
    const double k = of_model.k;
    const o::Coordinates<double> q{{r, 0.5}};
    const o::OpenValues<double> f{{-k / r, k / (r * r), -2 * k / (r * r * r)}};
    for (std::size_t n = 0; n < 3; ++n) all_f[n * states + i] = f[n];
    for (std::size_t n = 0; n < 2; ++n) {
      all_q[n * states + i] = q[n];
      all_v[n * states + i] = v[n];
      all_a[n * states + i] = a[n];
    }
    const auto torque = closed::inverse_dynamics(of_model, q, v, a);
    const auto slopes = closed::inverse_dynamics_derivatives(of_model, q, v, a);
    const auto by_array = o::inverse_dynamics(p, f, q, v, a);
    const auto by_eigen = o::eigen::inverse_dynamics(
        p, Eigen::Vector3d(f[0], f[1], f[2]), Eigen::Vector2d(q[0], q[1]),
        Eigen::Vector2d(v[0], v[1]), Eigen::Vector2d(a[0], a[1]));
    double by_c[2];
    central_force_open_c_inverse_dynamics(&in_c, f.data(), q.data(), v.data(), a.data(), by_c);
    for (std::size_t n = 0; n < 2; ++n) {
      compare(0, by_array[n], torque[n]);
      compare(1, by_eigen(static_cast<int>(n)), torque[n]);
      compare(2, by_c[n], torque[n]);
      expected[n * states + i] = torque[n];
    }
    const auto open_slopes = o::inverse_dynamics_derivatives(p, f, q, v, a);
    for (std::size_t n = 0; n < 4; ++n) {
      compare(3, open_slopes.by_position[n], slopes.by_position[n]);
      compare(3, open_slopes.by_velocity[n], slopes.by_velocity[n]);
    }
    compare(3, o::potential_energy(p, f, q), closed::potential_energy(of_model, q));
  }
  o::batch::inverse_dynamics<double>(p, states, all_f.data(), all_q.data(), all_v.data(),
                                     all_a.data(), batch.data());
  for (std::size_t i = 0; i < batch.size(); ++i) compare(4, batch[i], expected[i]);
  for (const char* name : o::open_value_names) std::printf("%s ", name);
  for (const double difference : worst) std::printf(difference < 1e-14 ? "equal " : "differs ");
  return CENTRAL_FORCE_OPEN_C_OPEN_VALUE_COUNT == 3 ? 0 : 1;
}
)source";

std::string scene_of(const std::string& name, const std::string& rest) {
  return "format = 1\nmodel = \"model.toml\"\nname = \"" + name + "\"\n" + wanted_outputs + rest;
}

/// The number of proved [[expect]] rows, and the number of [[expect]] rows that are only sampled.
std::pair<std::size_t, std::size_t> proved_rows(const std::string& model) {
  const Workspace folder;
  folder.write("model.toml", model_file(model));
  const Outcome outcome = folder.run("elgen verify --quick -v model.toml");
  INFO(outcome.output << outcome.errors);
  CHECK(outcome.status == 0);
  return {count(outcome.output, "proved: "), count(outcome.output, "sampled, no proof")};
}

}  // namespace

TEST_CASE("closed forms with open functions are proved by the chain rule alone") {
  for (const char* model : {"central_force_open", "particle_in_potential"}) {
    const auto [proved, sampled] = proved_rows(model);
    INFO(model);
    CHECK(proved > 0);
    CHECK(sampled == 0);
  }
}

TEST_CASE("an identity of one particular potential is no closed form of an open potential") {
  const Workspace folder;
  const std::string zero_of_sample = "drift = [\"V_11*r + 2*V_1\", \"0\"]\n";
  folder.write("model.toml", model_file("central_force_open") + zero_of_sample);
  const Outcome outcome = folder.run("elgen verify --quick model.toml");
  CHECK(outcome.status != 0);
  CHECK(mentions(outcome.errors, "E510"));
}

TEST_CASE("code called with the values of a potential equals the closed model") {
  const Workspace folder;
  folder.write("model.toml", model_file("central_force_open"));
  folder.write("cpp.scene.toml", scene_of("cpp", "[emit]\neigen = true\nbatch = true\n"));
  folder.write("c.scene.toml", scene_of("c", "[emit]\nlanguage = \"c99\"\n"));
  folder.write("closed.scene.toml", scene_of("closed", "[functions]\nV = \"-k/r\"\n"));
  folder.prepare("elgen generate -q -o . cpp.scene.toml c.scene.toml closed.scene.toml");
  folder.write("main.cpp", comparison);
  folder.prepare(
      "c++ -std=c++17 -O1 -ffp-contract=off -I. -isystem /usr/include/eigen3 main.cpp "
      "-o main");
  const Outcome outcome = folder.run("./main");
  CHECK(outcome.status == 0);
  CHECK(outcome.output == "V V_1 V_11 equal equal equal equal equal ");
}

TEST_CASE("pages print derivatives of open functions as books do") {
  const auto page_of = [](const char* model) {
    const Workspace folder;
    folder.write("model.toml", model_file(model));
    folder.prepare("elgen generate -q -o . --outputs gravity,inverse_dynamics model.toml");
    return folder.read(std::string(model) + "/" + model + ".md");
  };
  const std::string central = page_of("central_force_open");
  CHECK(mentions(central, "V'(r)"));
  CHECK(mentions(central, "$V(r)$"));
  CHECK(mentions(page_of("particle_in_potential"), "\\frac{\\partial V}{\\partial x}"));
}

TEST_CASE("the sidecar lists open functions and their values") {
  const Workspace folder;
  folder.write("model.toml", model_file("central_force_open"));
  folder.prepare("elgen generate -q -o . --outputs gravity model.toml");
  const std::string json = folder.read("central_force_open/central_force_open.equations.json");
  CHECK(mentions(json, R"("functions": [{"name": "V", "unit": "J", "of": ["r"]}])"));
  CHECK(mentions(json, R"({"name": "V_1", "unit": "N", "function": "V", "by": [1]})"));
}

TEST_CASE("files of models without open functions do not mention them") {
  const Workspace folder;
  folder.write("model.toml", model_file("simple_pendulum"));
  folder.prepare("elgen generate -q -o . --outputs gravity model.toml");
  for (const char* ending : {".hpp", ".equations.json", ".md"}) {
    const std::string text = folder.read(std::string("simple_pendulum/simple_pendulum") + ending);
    CHECK_FALSE(mentions(text, "open_value"));
    CHECK_FALSE(mentions(text, "OpenValues"));
  }
}

TEST_CASE("runs use the sample of an open function") {
  const Workspace folder;
  folder.write("model.toml", model_file("central_force_open"));
  const Outcome outcome =
      folder.run("elgen simulate --time 1 --method midpoint --step 0.01 model.toml");
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.errors, "note[E634]: `V` is `-k/r` here, which is its `sample`"));
}

}  // namespace elgen::test
