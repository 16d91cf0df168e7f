// Outputs agree with the textbook derivation and obey general laws of mechanics.
#include "derive/outputs/outputs.hpp"

#include <catch2/catch.hpp>

#include "derived.hpp"
#include "elgen/specialise.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A vector output and its textbook entries; `of_quadratic`: the output needs an L quadratic in v.
struct VectorOutput {
  const char* name;
  RealVector (*derived)(Derivation& derivation);
  GiNaC::ex (Textbook::*expected)(std::size_t i) const;
  bool of_quadratic;
};

const VectorOutput vectors[] = {
    {"inverse_dynamics", inverse_dynamics, &Textbook::inverse_dynamics, false},
    {"bias", [](Derivation& d) { return bias(d); }, &Textbook::bias, false},
    {"momentum", momentum, &Textbook::momentum, false},
    {"position_gradient", position_gradient, &Textbook::position_gradient, false},
    {"velocity_force", [](Derivation& d) { return velocity_force(d); }, &Textbook::velocity_force,
     true},
    {"gravity", gravity, &Textbook::gravity, true},
    {"drift", drift, &Textbook::drift, true},
};

template <class Expected>
void check_entries(const Derived& system, const RealVector& derived, const Expected& expected) {
  REQUIRE(derived.size() == system.size());
  for (std::size_t i = 0; i < derived.size(); ++i) {
    INFO("entry " << i);
    CHECK(system.agree(derived[i], expected(i)));
  }
}

void check_matrix(const Derived& system, const RealVector& derived,
                  GiNaC::ex (Textbook::*expected)(std::size_t i, std::size_t j) const) {
  const std::size_t n = system.size();
  REQUIRE(derived.size() == n * n);
  for (std::size_t k = 0; k < n * n; ++k) {
    INFO("entry " << k);
    CHECK(system.agree(derived[k], (system.textbook.*expected)(k / n, k % n)));
  }
}

}  // namespace

TEST_CASE("vector outputs of every system agree with the textbook") {
  for (const auto& [name, text] : systems()) {
    for (const VectorOutput& output : vectors) {
      INFO(name << " " << output.name);
      Derived s(text);
      if (output.of_quadratic && !s.source.is_quadratic) continue;
      check_entries(s, output.derived(s.derivation),
                    [&](std::size_t i) { return (s.textbook.*output.expected)(i); });
    }
  }
}

TEST_CASE(
    "mass matrices and Christoffel's Coriolis matrices of every system agree with the textbook") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    Derived s(text);
    const RealVector mass = mass_matrix(s.derivation);
    check_matrix(s, mass, &Textbook::mass);
    for (std::size_t k = 0; k < mass.size(); ++k) {
      CHECK(mass[k].is_equal(mass[k % s.size() * s.size() + k / s.size()]));
    }
    if (!s.source.is_quadratic) continue;
    Derived other(text);
    check_matrix(other, coriolis_matrix(other.derivation), &Textbook::coriolis);
  }
}

TEST_CASE("energies of every system agree with the textbook") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    Derived s(text);
    CHECK(s.agree(energy_function(s.derivation), s.textbook.energy()));
    if (!s.source.is_quadratic) continue;
    CHECK(s.agree(kinetic_energy(s.derivation), s.textbook.kinetic()));
    CHECK(s.agree(potential_energy(s.derivation), s.textbook.potential0()));
    CHECK(s.agree(total_energy(s.derivation), s.textbook.total()));
  }
}

TEST_CASE("a Lagrangian L is split by its degree in the rates") {
  Derived s(model_text("oscillator", R"toml(
[[coordinate]]
name = "x"
[parameters]
m = 2
k = 3
e = 5
[energy]
L = "1/2*m*dot(x)^2 + e*x*dot(x) - 1/2*k*x^2"
)toml"));
  const GiNaC::ex x = s.source.symbols.q[0];
  const GiNaC::ex v = s.source.symbols.v[0];
  const auto& p = s.source.symbols.parameters;
  CHECK(s.agree(kinetic_energy(s.derivation), p[0] * v * v / 2));
  CHECK(s.agree(potential_energy(s.derivation), p[1] * x * x / 2));
  CHECK(s.agree(total_energy(s.derivation), p[0] * v * v / 2 + p[1] * x * x / 2 - p[2] * x * v));
}

TEST_CASE("applied forces with and without inputs") {
  Derived s(read_model("everything"));
  const auto force = [&](std::size_t i) { return s.textbook.force(i); };
  const auto without = [&](std::size_t i) { return s.textbook.without_inputs(force(i)); };
  check_entries(s, applied_force(s.derivation, InputForces::acting), force);
  check_entries(s, applied_force(s.derivation, InputForces::absent), without);
  check_entries(s, bias(s.derivation, InputForces::acting),
                [&](std::size_t i) { return s.textbook.bias(i) + without(i) - force(i); });
}

TEST_CASE("dissipation is the gradient of D with respect to the rates") {
  Derived s(read_model("everything"));
  const RealVector force = dissipation(s.derivation);
  const GiNaC::ex D = s.textbook.write_out(s.source.dissipation.front().value);
  CHECK(s.agree(force[0], Textbook::derivative_by(D, s.source.symbols.v[0])));
  CHECK(force[1].is_zero());
}

TEST_CASE("without time the drift is zero") {
  Derived s(read_model("chain"));
  for (const GiNaC::ex& entry : drift(s.derivation)) CHECK(entry.is_zero());
}

TEST_CASE("the mass matrix of a quadratic L contains no rates") {
  Derived s(read_model("everything"));
  for (const GiNaC::ex& entry : mass_matrix(s.derivation)) {
    CHECK_FALSE(dependence(s.derivation.definitions, entry).has_any(Opcode::velocity));
  }
}

TEST_CASE("input matrices are the derivatives of forces with respect to inputs") {
  Derived s(read_model("everything"));
  const RealVector matrix = input_matrix(s.derivation);
  REQUIRE(matrix.size() == 4);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      CHECK(s.agree(matrix[i * 2 + j],
                    Textbook::derivative_by(s.textbook.force(i), s.source.symbols.u[j])));
    }
  }
}

TEST_CASE("Jacobians and second rates of declared outputs") {
  Derived s(read_model("everything"));
  const Terms& values = s.source.outputs.front().values;
  const RealVector slopes = jacobian(s.derivation, values);
  const RealVector rates = second_rate(s.derivation, values);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const GiNaC::ex value = s.textbook.write_out(values[k]);
    for (std::size_t j = 0; j < s.size(); ++j) {
      CHECK(
          s.agree(slopes[k * s.size() + j], Textbook::derivative_by(value, s.source.symbols.q[j])));
    }
    CHECK(s.agree(rates[k], s.textbook.coasting(s.textbook.rate(s.textbook.rate(value)))));
  }
}

TEST_CASE("forward dynamics satisfies M a + bias = B u in every system") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    Derived s(text);
    const ForwardDynamics solved = forward_dynamics(s.derivation);
    const RealVector mass = mass_matrix(s.derivation);
    for (std::size_t i = 0; i < s.size(); ++i) {
      GiNaC::ex inertia = 0;
      for (std::size_t j = 0; j < s.size(); ++j) {
        inertia += mass[i * s.size() + j] * solved.acceleration[j];
      }
      const GiNaC::ex force = s.textbook.force(i);
      CHECK(s.agree(inertia, force - s.textbook.without_inputs(force) - s.textbook.bias(i)));
    }
  }
}

TEST_CASE("relative pivots are 1 if coordinates are decoupled") {
  Derived s(model_text("two_masses", R"toml(
[[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[parameters]
m = 2
[energy]
T = "1/2*m*dot(x)^2 + 3*m*dot(y)^2"
)toml"));
  const ForwardDynamics solved = forward_dynamics(s.derivation);
  CHECK(s.agree(solved.relative_pivots[0], 1));
  CHECK(s.agree(solved.relative_pivots[1], 1));
}

TEST_CASE("the second relative pivot is det M over the product of the diagonal") {
  Derived s(read_model("cart_pole"));
  const ForwardDynamics solved = forward_dynamics(s.derivation);
  const GiNaC::ex m00 = s.textbook.mass(0, 0);
  const GiNaC::ex m11 = s.textbook.mass(1, 1);
  const GiNaC::ex m01 = s.textbook.mass(0, 1);
  CHECK(s.agree(solved.relative_pivots[0], 1));
  CHECK(s.agree(solved.relative_pivots[1], (m00 * m11 - m01 * m01) / (m00 * m11)));
}

TEST_CASE("names of accelerations are identifiers, also for repeated coordinates") {
  Derived s(read_model("chain"));
  const auto solved = forward_dynamics(s.derivation);
  const auto& place = s.derivation.definitions.places.at(solved.acceleration.back());
  CHECK(s.derivation.definitions.list[place.index].name == "acceleration_q_3");
}

TEST_CASE("the reaction of a locked cart is the force of the swinging bob") {
  const CheckedModel checked =
      checked_scene(read_model("cart_pole"), "[lock]\nx = { value = 0, reaction = true }\n");
  Derivation d(*specialise(*formulate(checked.model), checked));
  const RealVector before = gravity(d);
  const RealVector force = reaction(d);
  const RealVector after = gravity(d);
  REQUIRE(force.size() == 1);
  const auto& [theta, omega, alpha] = std::tie(d.symbols.q[0], d.symbols.v[0], d.symbols.a[0]);
  const GiNaC::ex m = d.symbols.parameters[1];
  const GiNaC::ex l = d.symbols.parameters[2];
  // The reaction is m l (cos(theta) theta'' - sin(theta) theta'^2). The model's input acts on the
  // locked cart, and is no input of the scene.
  CHECK(d.symbols.u.empty());
  const GiNaC::ex expected = m * l * (cos(theta) * alpha - sin(theta) * omega * omega);
  const auto whole = [&](const GiNaC::ex& value) { return written_out(d.definitions, value); };
  CHECK((whole(force[0]) - expected).expand().is_zero());
  CHECK((whole(before[0]) - whole(after[0])).expand().is_zero());
}
