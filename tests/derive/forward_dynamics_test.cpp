// Forward dynamics undo inverse dynamics, and pivots say how regular M is.
#include "derive/outputs/forward_dynamics.hpp"

#include <catch2/catch.hpp>

#include "derive/outputs/forces.hpp"
#include "derive/outputs/matrices.hpp"
#include "derived.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("M a + bias = B u for the acceleration found, in every system") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    Derived s(text);
    const ForwardDynamics solved = forward_dynamics(s.derivation);
    const Vector mass = mass_matrix(s.derivation);
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

TEST_CASE("relative pivots are one where coordinates are decoupled") {
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
  Derived s(cart_pole_text());
  const ForwardDynamics solved = forward_dynamics(s.derivation);
  const GiNaC::ex m00 = s.textbook.mass(0, 0);
  const GiNaC::ex m11 = s.textbook.mass(1, 1);
  const GiNaC::ex m01 = s.textbook.mass(0, 1);
  CHECK(s.agree(solved.relative_pivots[0], 1));
  CHECK(s.agree(solved.relative_pivots[1], (m00 * m11 - m01 * m01) / (m00 * m11)));
}

TEST_CASE("accelerations are named by identifiers, for repeated coordinates too") {
  Derived s(chain_text());
  const auto solved = forward_dynamics(s.derivation);
  const auto& place = s.derivation.definitions.places.at(solved.acceleration.back());
  CHECK(s.derivation.definitions.list[place.index].name == "acceleration_q_3");
}
