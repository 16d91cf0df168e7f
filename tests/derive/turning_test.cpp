// Rotations: Euler's equations and the Christoffel form for angular velocities follow from the
// energy alone.
#include "derive/lagrangian/turning.hpp"

#include <catch2/catch.hpp>

#include "derive/formulate/chain_rule.hpp"
#include "derive/formulate/written_out.hpp"
#include "derive/outputs/outputs.hpp"

namespace elgen::test {
namespace {

using GiNaC::ex;

/// A rotation with T = 1/2 (2 w1^2 + 3 w2^2 + 5 w3^2).
Lagrangian top() {
  Model model;
  Rotation rotation;
  rotation.name = rotation.identifier = "e";
  append_rotation(model, rotation);
  Result<UnreducedLagrangian> lagrangian = formulate(model);
  REQUIRE(lagrangian);
  const std::vector<ex> v = lagrangian->symbols.v;
  for (std::size_t i = 0; i < 3; ++i) {
    const int inertia = i == 0 ? 2 : i == 1 ? 3 : 5;
    lagrangian->kinetic.push_back({GiNaC::numeric(inertia, 2) * v[i] * v[i]});
  }
  return std::move(*lagrangian);
}

}  // namespace

TEST_CASE("velocity forces agree with Euler's equations") {
  Derivation derivation(top());
  const std::vector<ex>& w = derivation.symbols.v;
  const RealVector force = velocity_force(derivation);
  const RealVector expected{2 * w[1] * w[2], -3 * w[2] * w[0], w[0] * w[1]};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK((written_out(derivation.definitions, force[i]) - expected[i]).expand().is_zero());
  }
}

TEST_CASE("C is skew-symmetric if M is constant") {
  Derivation derivation(top());
  const RealVector c = coriolis_matrix(derivation);
  const RealVector force = velocity_force(derivation);
  for (std::size_t i = 0; i < 3; ++i) {
    ex product = -force[i];
    for (std::size_t j = 0; j < 3; ++j) {
      product += c[3 * i + j] * derivation.symbols.v[j];
      const ex sum = c[3 * i + j] + c[3 * j + i];
      CHECK(written_out(derivation.definitions, sum).expand().is_zero());
    }
    CHECK(written_out(derivation.definitions, product).expand().is_zero());
  }
}

TEST_CASE("gradients are along infinitesimal rotations") {
  Derivation derivation(top());
  const std::vector<ex>& e = derivation.symbols.q;
  // The slope of R_33 = w^2 - x^2 - y^2 + z^2 is -R_32 about x, R_31 about y, and 0 about z.
  const ex height = e[0] * e[0] - e[1] * e[1] - e[2] * e[2] + e[3] * e[3];
  const RealVector slope = derivation.gradient_by_position({{height, 1}});
  const RealVector expected{-2 * (e[2] * e[3] + e[0] * e[1]), 2 * (e[1] * e[3] - e[0] * e[2]), 0};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK((written_out(derivation.definitions, slope[i]) - expected[i]).expand().is_zero());
    Tangent along = derivation.displacement_tangent(i);
    CHECK((along(height) - expected[i]).expand().is_zero());
  }
}

TEST_CASE("normalized quaternions have length 1") {
  Derivation derivation(top());
  ex square = 0;
  for (const ex& component : normalized(derivation)) square += component * component;
  CHECK(written_out(derivation.definitions, square).normal().is_equal(1));
}

}  // namespace elgen::test
