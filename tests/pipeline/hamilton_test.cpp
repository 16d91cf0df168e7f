// Hamilton's functions of whole models agree to 50 digits with momenta, energies and accelerations.
// The functions are emitted in all languages and printed on pages.
#include <catch2/catch.hpp>

#include "elgen/oracle.hpp"
#include "pipeline/pipeline_testing.hpp"
#include "program/evaluate/exact_values.hpp"
#include "sample/states.hpp"

namespace elgen::test {
namespace {

constexpr const char* hamiltons_functions = "hamiltonian,velocities_of_momenta,hamilton_equations";

/// A point in the axes of a table that turns at rate Omega: b = m Omega (-y, x).
const std::string turntable = R"toml(format = 1
[model]
name = "turntable"
[[coordinate]]
name = "x"
unit = "m"
[[coordinate]]
name = "y"
unit = "m"
[parameters]
m     = { value = 2, unit = "kg", assume = "positive" }
k     = { value = 5, unit = "N/m" }
d     = { value = 0.3, unit = "N*s/m" }
Omega = { value = 3, unit = "rad/s" }
[[prescribed]]
name  = "turn"
value = "Omega*t"
unit  = "rad"
[[frame]]
name   = "table"
parent = "world"
rotate = [["z", "turn"]]
[[point]]
name  = "mass"
frame = "table"
at    = ["x", "y", "0"]
mass  = "m"
[energy]
V = "1/2*k*x^2"
D = "1/2*d*dot(y)^2"
)toml";

/// Ten models: rotating axes, a rotating hoop, a magnetic field, inputs, damping, a rotation, and
/// mass matrices that depend on angles.
std::vector<std::string> ten_models() {
  std::vector<std::string> texts{turntable};
  for (const char* name :
       {"rotating_hoop", "charged_particle", "cart_pole", "motor_pendulum", "two_mass_damper",
        "free_body", "heavy_top", "spherical_pendulum", "double_pendulum"}) {
    texts.push_back(model_file(name));
  }
  return texts;
}

SystemUnderTest subject_of(const Products& products) {
  return {products.checked->model, products.checked->scene, *products.program};
}

/// A random state, with the momenta of its velocities.
State moving_state(const SystemUnderTest& subject, Sampler& draw) {
  State state = nominal_state(subject.model, subject.scene);
  draw_motion(subject.model, draw, 0, state);
  const OracleValues p = oracle_values(subject.model, {.kind = OutputKind::momentum}, state);
  REQUIRE(p);
  state.momenta = *p;
  return state;
}

/// Checks that each error is at most 10^-50 times the largest expected |entry|.
void check_values(const std::vector<Real>& values, const std::vector<cln::cl_R>& expected) {
  REQUIRE(values.size() == expected.size());
  cln::cl_R scale = 0;
  for (const cln::cl_R& x : expected) scale = cln::max(scale, cln::abs(x));
  const cln::cl_R tolerance = scale * cln::expt(cln::cl_RA(10), -50);
  for (std::size_t i = 0; i < values.size(); ++i) {
    INFO("entry " << i);
    REQUIRE(values[i].is_defined());
    CHECK(cln::abs(cln::cl_R(values[i].value()) - expected[i]) <= tolerance);
  }
}

std::vector<cln::cl_R> numbers(const std::vector<Real>& values) {
  const OracleValues defined = to_oracle_values(values);
  REQUIRE(defined);
  return *defined;
}

/// dq/dt, then d/dt dL/dv, at the accelerations of the oracle.
std::vector<cln::cl_R> rates_along_motion(const SystemUnderTest& subject, const ExactValues& at) {
  const OracleValues a =
      oracle_values(subject.model, {.kind = OutputKind::forward_dynamics}, at.state());
  REQUIRE(a);
  Arguments<Real> motion = at.zero_direction();
  motion.q = at.coordinate_rates(at.arguments().v);
  for (std::size_t i = 0; i < at.size(); ++i) motion.v[i] = Real((*a)[i]);
  motion.t = Real(1);
  std::vector<Real> rates = motion.q;
  const std::vector<Real> of_momenta = at.directional_derivatives(OutputKind::momentum, motion);
  rates.insert(rates.end(), of_momenta.begin(), of_momenta.end());
  return numbers(rates);
}

}  // namespace

TEST_CASE("H = E, v and dp/dt agree with momenta and motion to 50 digits") {
  for (const std::string& text : ten_models()) {
    const Products products =
        derived(inputs_of(text), std::string("momentum,") + hamiltons_functions);
    const SystemUnderTest subject = subject_of(products);
    INFO(subject.model.name);
    Sampler draw(1);
    for (int sample = 0; sample < 3; ++sample) {
      const State state = moving_state(subject, draw);
      ExactValues at(subject, state);
      const OracleValues energy =
          oracle_values(subject.model, {.kind = OutputKind::energy_function}, state);
      REQUIRE(energy);
      check_values(at.entries(OutputKind::hamiltonian), *energy);
      check_values(at.entries(OutputKind::velocities_of_momenta), state.v);
      check_values(at.entries(OutputKind::hamilton_equations), rates_along_motion(subject, at));
    }
  }
}

TEST_CASE("Hamilton's functions are emitted in all languages, compared and balanced") {
  for (const char* model : {"cart_pole", "free_body"}) {
    INFO(model);
    const Workspace folder;
    const std::string outputs =
        "[outputs]\nmomentum = true\nhamiltonian = true\nvelocities_of_momenta = true\n"
        "hamilton_equations = true\n";
    const auto scene = [&](const std::string& name, const std::string& rest) {
      folder.write(name + ".scene.toml", "format = 1\nmodel = \"model.toml\"\nname = \"" + name +
                                             "\"\n" + outputs + rest);
    };
    folder.write("model.toml", model_file(model));
    scene("cpp", "[emit]\neigen = true\nbatch = true\n");
    scene("c", "[emit]\nlanguage = \"c99\"\n");
    const Outcome outcome =
        folder.run("elgen verify --build written -v --samples 8 cpp.scene.toml c.scene.toml");
    INFO(outcome.output << outcome.errors);
    CHECK(outcome.status == 0);
    CHECK(mentions(outcome.output, "Hamiltonian is the energy"));
    CHECK(mentions(outcome.output, "momenta of velocities"));
    CHECK(mentions(outcome.output, "Hamilton's equations along the motion"));
  }
}

TEST_CASE("functions of momenta are emitted only if they are named") {
  const Workspace folder;
  folder.write("model.toml", model_file("simple_pendulum"));
  folder.prepare("elgen generate -q -o all model.toml");
  const std::string all = folder.read("all/simple_pendulum/simple_pendulum.hpp");
  CHECK_FALSE(mentions(all, "hamilton"));
  CHECK_FALSE(mentions(all, "omenta"));
  folder.prepare("elgen generate -q -o some --outputs dynamics,bias,hamiltonian model.toml");
  const std::string some = folder.read("some/simple_pendulum/simple_pendulum.hpp");
  CHECK(mentions(some, "const Momenta<Scalar>& momenta"));
  const std::string dynamics = some.substr(some.find("struct Dynamics"));
  CHECK_FALSE(mentions(dynamics.substr(0, dynamics.find("};")), "hamiltonian"));
}

TEST_CASE("pages print H as books do") {
  const Workspace folder;
  folder.write("model.toml", model_file("simple_pendulum"));
  const Outcome latex =
      folder.run("elgen show --what hamiltonian,hamilton_equations --as latex model.toml");
  INFO(latex.output << latex.errors);
  CHECK(latex.status == 0);
  CHECK(mentions(latex.output, "p_{\\theta}^{2}"));
  CHECK(mentions(latex.output, "\\dot{p}"));
  const Outcome text =
      folder.run("elgen show --what hamiltonian,hamilton_equations --as text model.toml");
  CHECK(mentions(text.output, "p = dL/dv: momenta"));
  CHECK(mentions(text.output, "p(theta)^2"));
}

}  // namespace elgen::test
