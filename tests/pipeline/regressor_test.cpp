// Regressors: Y pi + rest = tau for every model with a regressor, closed forms, names, reference
// velocities, and refused models. The self-check (E911) and `verify` compare the values with the
// values of the oracle.
#include <catch2/catch.hpp>
#include <filesystem>

#include "elgen/inertial_parameters.hpp"
#include "model/requests.hpp"
#include "numbers/exact_number.hpp"
#include "pipeline/constrained_testing.hpp"

namespace elgen::test {
namespace {

/// max |Y pi + rest - tau|, relative to the largest term of Y pi.
double imbalance(const Constrained& system, OutputKind kind, const State& state,
                 const ExactNumbers& forces) {
  const ExactNumbers y = system.exactly(kind, "matrix", state);
  const ExactNumbers rest = system.exactly(kind, "rest", state);
  const ExactNumbers pi = system.exactly(OutputKind::regressor_parameters, "", state);
  cln::cl_R largest = 0;
  cln::cl_R worst = 0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    cln::cl_R sum = rest[i] - forces[i];
    for (std::size_t k = 0; k < pi.size(); ++k) {
      const cln::cl_R term = y[i * pi.size() + k] * pi[k];
      largest = cln::max(largest, cln::abs(term));
      sum = sum + term;
    }
    worst = cln::max(worst, cln::abs(sum));
  }
  return cln::zerop(largest) ? double_of(worst) : double_of(worst / largest);
}

std::vector<std::string> names_of(const Model& model) {
  std::vector<std::string> names;
  for (const InertialParameter& parameter : inertial_parameters(model)) {
    names.push_back(parameter.name);
  }
  return names;
}

constexpr const char* outputs = "regressor,regressor_parameters,inverse_dynamics";

Products products_of(const std::string& scene, const std::string& model) {
  return run_pipeline(inputs_of(model, scene), {.goals = {Goal::choose}});
}

std::string slider(const std::string& more) {
  return R"toml(format = 1
[model]
name = "slider"
[[coordinate]]
name = "x"
unit = "m"
armature = "J"
[[coordinate]]
name = "y"
unit = "m"
[parameters]
J = { value = 0.2, unit = "kg" }
m = { value = 2, unit = "kg" }
k = { value = 3, unit = "N/m" }
l = { value = 1, unit = "m" }
d = { value = 0.1, unit = "N*s/m" }
c = { value = 0.1, unit = "N*s/m" }
b = { value = 0.3, unit = "1" }
w = { value = 2, unit = "m/s" }
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2)"
V = "1/2*k*(x - l)^2"
D = "1/2*d*dot(x)^2 + 1/2*c*b*w*abs2*dot(y)"
[define]
abs2 = "dot(y)/w"
)toml" + more;
}

}  // namespace

TEST_CASE("the regressor times its parameters is the inverse dynamics") {
  std::size_t count = 0;
  for (const std::filesystem::path& path : model_paths()) {
    INFO(path);
    const std::string text = read_text(path);
    const Constrained whole(text, "inverse_dynamics");
    if (!is_available(whole.model(), make_request(whole.model(), OutputKind::regressor, 0)))
      continue;
    const Constrained system(text, outputs);
    const State state = random_state(system);
    const ExactNumbers forces = system.exactly(OutputKind::inverse_dynamics, "", state);
    CHECK(imbalance(system, OutputKind::regressor, state, forces) < 1e-50);
    ++count;
  }
  CHECK(count > 30);
}

TEST_CASE("a reference velocity replaces one velocity in C v") {
  for (const char* const name : {"two_link_arm", "panda7", "free_body", "heavy_top", "cart_pole"}) {
    INFO(name);
    const Constrained system(
        model_file(name),
        "regressor_reference,regressor_parameters,mass_matrix,coriolis_matrix,gravity,dissipation,"
        "applied_force");
    const State state = random_state(system);
    State by_reference = state;
    by_reference.v = state.reference;
    const std::size_t n = state.v.size();
    const ExactNumbers m = system.exactly(OutputKind::mass_matrix, "", state);
    const ExactNumbers c = system.exactly(OutputKind::coriolis_matrix, "", state);
    const ExactNumbers g = system.exactly(OutputKind::gravity, "", state);
    const ExactNumbers d = system.exactly(OutputKind::dissipation, "", by_reference);
    const ExactNumbers q = system.exactly(OutputKind::applied_force, "", state);
    ExactNumbers forces(n);
    for (std::size_t i = 0; i < n; ++i) {
      forces[i] = g[i] + d[i] - q[i];
      for (std::size_t j = 0; j < n; ++j) {
        forces[i] = forces[i] + m[i * n + j] * state.a[j] + c[i * n + j] * state.reference[j];
      }
    }
    CHECK(imbalance(system, OutputKind::regressor_reference, state, forces) < 1e-50);
  }
}

TEST_CASE("scenes with locks and fixed parameters have regressors of the remaining model") {
  for (const auto& [name, rest] :
       {std::pair("panda7", "[lock]\nq3 = { value = \"0.4 + 0.2*t\" }\nq5 = { value = 1 }\n"),
        std::pair("ur5", "[parameters]\nfixed = \"all\"\n"),
        std::pair("pendulum_in_lift", "[parameters]\nfixed = \"all\"\n")}) {
    INFO(name);
    const std::string wanted =
        "[outputs]\nregressor = true\nregressor_reference = true\nregressor_parameters = true\n";
    PipelineOptions options;
    options.goals = {Goal::self_check};  // this goal compares with the oracle
    const Products products =
        products_with(&Products::self_check, inputs_of(model_file(name), wanted + rest), options);
    const Program& program = *products.program;
    const std::size_t n = products.checked->model.velocities.size();
    CHECK(find_function(program, OutputKind::regressor)->fields[0].rows == n);
    CHECK(find_function(program, OutputKind::regressor)->fields[0].columns ==
          names_of(products.checked->model).size());
  }
}

TEST_CASE("parameters of a regressor have names, units and an order") {
  const Constrained arm(model_file("two_link_arm"), outputs);
  CHECK(names_of(arm.model()) ==
        std::vector<std::string>{"link1.m", "link1.Izz", "link2.m", "link2.Izz"});
  const Constrained top(model_file("free_body"), outputs);
  CHECK(names_of(top.model()).size() == 10);
  CHECK(names_of(top.model()).front().ends_with(".m"));
  CHECK(names_of(top.model()).back().ends_with(".Iyz"));
  const Products slides = products_of(
      "[regressor]\nparameters = [\"k\", \"m\"]\n"
      "[outputs]\nregressor = true\n",
      slider(""));
  INFO(format(slides.diagnostics));
  REQUIRE(slides.program);
  const Model& model = slides.checked->model;
  CHECK(names_of(model) == std::vector<std::string>{"armature.x", "d", "k", "m"});
  CHECK(to_string(*inertial_parameters(model)[0].unit) == "kg");
  CHECK(to_string(*inertial_parameters(model)[2].unit) == "kg/s^2");
}

TEST_CASE("regressor parameters in which the forces are not affine are refused") {
  const auto message = [](const std::string& parameters, const std::string& more = "") {
    return format(products_of("[regressor]\nparameters = " + parameters +
                                  "\n[outputs]\nregressor = true\n" + more,
                              slider(""))
                      .diagnostics);
  };
  using Catch::Contains;
  CHECK_THAT(message("[\"k\", \"l\"]"), Contains("E649") && Contains("not affine in `l`"));
  CHECK_THAT(message("[\"c\", \"b\"]"), Contains("a product of `c` and `b`"));
  CHECK_THAT(message("[\"J\"]"), Contains("`J` occurs in a mass, an inertia"));
  CHECK_THAT(message("[\"q\"]"), Contains("E602"));
  CHECK_THAT(message("[\"k\"]", "[parameters]\nfixed = \"all\"\n"), Contains("`k` is fixed"));
  const std::string bare = R"toml(format = 1
[model]
name = "bare"
[[coordinate]]
name = "x"
[energy]
T = "1/2*dot(x)^2"
)toml";
  CHECK_THAT(format(products_of("[outputs]\nregressor = true\n", bare).diagnostics),
             Contains("E603") && Contains("needs a body, a point with a mass"));
}

}  // namespace elgen::test
