// Hamiltonian functions of textbooks, velocities as functions of momenta, the part b = p - M v of
// the momenta, and rotations.
#include <catch2/catch.hpp>

#include "derive/outputs/outputs.hpp"
#include "derived.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using GiNaC::ex;

/// True if `derived` and `expected` agree for all positions and momenta.
bool agree(const Derived& s, const ex& derived, const ex& expected) {
  std::vector<ex> leaves = s.source.symbols.momenta;
  for (const auto* list :
       {&s.source.symbols.parameters, &s.source.symbols.q, &s.source.symbols.u}) {
    leaves.insert(leaves.end(), list->begin(), list->end());
  }
  leaves.push_back(s.source.symbols.t);
  return vanishes(written_out(s.derivation.definitions, derived) - expected, leaves);
}

/// A system with coordinates x and y, parameters m and k, and the keys `energies` in [energy].
Derived plane_system(const std::string& energies) {
  return Derived(model_text("plane",
                            "[[coordinate]]\nname = \"x\"\n[[coordinate]]\nname = \"y\"\n"
                            "[parameters]\nm = 2\nk = 3\n[energy]\n" +
                                energies));
}

}  // namespace

TEST_CASE("Kepler in polar coordinates") {
  Derived s = plane_system("T = \"1/2*m*(dot(x)^2 + x^2*dot(y)^2)\"\nV = \"-k/x\"\n");
  const ex& r = s.source.symbols.q[0];
  const ex& m = s.source.symbols.parameters[0];
  const ex& k = s.source.symbols.parameters[1];
  const std::vector<ex>& p = s.source.symbols.momenta;
  CHECK(agree(s, hamiltonian(s.derivation),
              p[0] * p[0] / (2 * m) + p[1] * p[1] / (2 * m * r * r) - k / r));
  const HamiltonEquations rates = hamilton_equations(s.derivation);
  CHECK(agree(s, rates.coordinate_rates[0], p[0] / m));
  CHECK(agree(s, rates.coordinate_rates[1], p[1] / (m * r * r)));
  CHECK(agree(s, rates.momentum_rates[0], p[1] * p[1] / (m * r * r * r) - k / (r * r)));
  CHECK(rates.momentum_rates[1].is_zero());
}

TEST_CASE("in a magnetic field p - M v equals b") {
  Derived s = plane_system("T = \"1/2*m*(dot(x)^2 + dot(y)^2)\"\nV = \"-k*x*dot(y)\"\n");
  const ex& x = s.source.symbols.q[0];
  const ex& m = s.source.symbols.parameters[0];
  const ex& k = s.source.symbols.parameters[1];
  const std::vector<ex>& p = s.source.symbols.momenta;
  const ex free = p[1] - k * x;
  CHECK(agree(s, velocities_of_momenta(s.derivation)[1], free / m));
  CHECK(agree(s, hamiltonian(s.derivation), (p[0] * p[0] + free * free) / (2 * m)));
  CHECK(agree(s, hamilton_equations(s.derivation).momentum_rates[0], k * free / m));
}

TEST_CASE("on a rotating hoop H is not T + V") {
  Derived s(model_text("hoop", R"toml(
[[coordinate]]
name = "theta"
[[prescribed]]
name = "phi"
value = "Omega*t"
[parameters]
m = 2
R = 3
g = 9.81
Omega = 5
[[point]]
name = "bead"
at = ["R*sin(theta)*cos(phi)", "R*sin(theta)*sin(phi)", "-R*cos(theta)"]
mass = "m"
[gravity]
vector = ["0", "0", "-g"]
)toml"));
  const auto& parameter = s.source.symbols.parameters;
  const ex& theta = s.source.symbols.q[0];
  const ex& p = s.source.symbols.momenta[0];
  const ex inertia = parameter[0] * parameter[1] * parameter[1];
  const ex spin = parameter[3] * GiNaC::sin(theta);
  const ex weight = parameter[0] * parameter[2] * parameter[1];
  CHECK(agree(s, hamiltonian(s.derivation),
              p * p / (2 * inertia) - inertia * spin * spin / 2 - weight * GiNaC::cos(theta)));
  CHECK(agree(s, hamilton_equations(s.derivation).momentum_rates[0],
              inertia * parameter[3] * spin * GiNaC::cos(theta) - weight * GiNaC::sin(theta)));
}

TEST_CASE("inputs, forces and dissipation change momenta, at the velocities of the momenta") {
  Derived s(read_model("cart_pole") + "[energy]\nD = \"1/2*m*dot(x)^2\"\n");
  const RealVector v = velocities_of_momenta(s.derivation);
  const RealVector rates = hamilton_equations(s.derivation).momentum_rates;
  const ex& m = s.source.symbols.parameters[1];
  CHECK(
      agree(s, rates[0], s.source.symbols.u[0] - m * written_out(s.derivation.definitions, v[0])));
}

TEST_CASE("momenta of a free top turn in its axes: dp/dt = p x w") {
  Model model;
  Rotation rotation;
  rotation.name = rotation.identifier = "e";
  append_rotation(model, rotation);
  Result<UnreducedLagrangian> lagrangian = formulate(model);
  REQUIRE(lagrangian);
  const GiNaC::numeric inertias[] = {2, 3, 5};
  for (std::size_t i = 0; i < 3; ++i) {
    const ex& w = lagrangian->symbols.v[i];
    lagrangian->kinetic.push_back({inertias[i] * w * w / 2});
  }
  Derivation derivation(*lagrangian);
  const std::vector<ex>& p = derivation.symbols.momenta;
  const std::vector<ex>& e = derivation.symbols.q;
  const HamiltonEquations rates = hamilton_equations(derivation);
  REQUIRE(rates.coordinate_rates.size() == 4);
  const auto vanishes_at = [&](const ex& derived, const ex& expected) {
    return (written_out(derivation.definitions, derived) - expected).expand().is_zero();
  };
  CHECK(vanishes_at(rates.coordinate_rates[0],
                    -(e[1] * p[0] / 2 + e[2] * p[1] / 3 + e[3] * p[2] / 5) / 2));
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    CHECK(vanishes_at(rates.momentum_rates[k], p[i] * p[j] * (1 / inertias[j] - 1 / inertias[i])));
  }
}

TEST_CASE("momentum(velocities_of_momenta(p)) equals p in every system") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    Derived s(text);
    if (!s.source.is_quadratic) continue;
    const RealVector v = velocities_of_momenta(s.derivation);
    GiNaC::exmap moving;
    for (std::size_t i = 0; i < v.size(); ++i) {
      moving[s.source.symbols.v[i]] = written_out(s.derivation.definitions, v[i]);
    }
    for (std::size_t i = 0; i < v.size(); ++i) {
      CHECK(agree(s, s.source.symbols.momenta[i], s.textbook.momentum(i).subs(moving)));
    }
  }
}
