// Energies and forces of a model as terms over definitions, and rates of unit quaternions.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "derive/formulate/chain_rule.hpp"
#include "derive/formulate/written_out.hpp"
#include "elgen/lagrangian.hpp"
#include "elgen/leaf_names.hpp"
#include "support/systems.hpp"

namespace elgen::test {

using namespace elgen::test;
using GiNaC::ex;

namespace {

/// A scalar coordinate followed by a rotation.
Model model() {
  Model result;
  append_coordinate(result, {.name = "x", .identifier = "x"});
  Rotation rotation;
  rotation.name = rotation.identifier = "e";
  append_rotation(result, rotation);
  return result;
}

Lagrangian formulate_model() {
  Result<UnreducedLagrangian> lagrangian = formulate(model());
  REQUIRE(lagrangian);
  return std::move(*lagrangian);
}

}  // namespace

TEST_CASE("points with a mass become point masses, with gravity") {
  const auto lagrangian = formulate(checked_model(read_model("cart_pole")).model);
  REQUIRE(lagrangian);
  const Symbols& s = lagrangian->symbols;
  REQUIRE(lagrangian->masses.size() == 2);
  const auto& bob = lagrangian->masses[1];
  const auto out = [&](const ex& value) { return written_out(lagrangian->definitions, value); };
  CHECK(out(bob.position[0]).is_equal(s.q[0] + s.parameters[2] * sin(s.q[1])));
  CHECK(out(bob.position[1]).is_equal(s.parameters[2] * cos(s.q[1])));
  CHECK(bob.position[2].is_zero());
  CHECK(out((*lagrangian->gravity)[1]).is_equal(-s.parameters[3]));
  CHECK(lagrangian->forces[0].is_equal(s.u[0]));
  CHECK(lagrangian->forces[1].is_zero());
}

TEST_CASE("bodies add 1/2 w.I w, with products of inertia as off-diagonal entries") {
  const auto lagrangian = formulate(checked_model(read_model("gyroscope")).model);
  REQUIRE(lagrangian);
  CHECK(lagrangian->masses.empty());
  ex kinetic = 0;
  for (const EnergyTerm& term : lagrangian->kinetic) {
    CHECK(term.origin == EnergyOrigin::spin);
    kinetic += written_out(lagrangian->definitions, term.value);
  }
  const Symbols& s = lagrangian->symbols;
  const ex& theta = s.q[1];
  const ex& psi = s.q[2];
  const ex wx = s.v[0] * sin(theta) * sin(psi) + s.v[1] * cos(psi);
  const ex wy = s.v[0] * sin(theta) * cos(psi) - s.v[1] * sin(psi);
  const ex wz = s.v[0] * cos(theta) + s.v[2];
  const ex A = s.parameters[0], C = s.parameters[1], P = s.parameters[2];
  const ex expected = (A * wx * wx + A * wy * wy + C * wz * wz) / 2 + P * wx * wy + P / 2 * wy * wz;
  std::vector<ex> leaves = s.q;
  leaves.insert(leaves.end(), s.v.begin(), s.v.end());
  leaves.insert(leaves.end(), s.parameters.begin(), s.parameters.end());
  CHECK(vanishes(kinetic - expected, leaves));
}

TEST_CASE("an armature adds 1/2 J v^2, and forces keep their inputs") {
  const auto lagrangian = formulate(checked_model(read_model("everything")).model);
  REQUIRE(lagrangian);
  const Symbols& s = lagrangian->symbols;
  const ex rate = s.v[1];
  CHECK(lagrangian->kinetic.back().origin == EnergyOrigin::armature);
  CHECK(lagrangian->kinetic.back().value.is_equal(s.parameters[1] * rate * rate / 2));
  CHECK(lagrangian->point_forces.size() == 2);
  CHECK(lagrangian->point_forces[0].force[0].is_equal(-lagrangian->point_forces[1].force[0]));
  CHECK(lagrangian->forces[0].is_equal(s.u[1]));
  CHECK(dependence(lagrangian->definitions, lagrangian->forces[1]).has_any(Opcode::input));
}

TEST_CASE("an error is reported once, however many definitions depend on it") {
  std::string text =
      "[[coordinate]]\nname = \"x\"\n[energy]\nT = \"dot(x)^2/2\"\n[define]\n"
      "d0 = \"1/(x + 1 - (x + 1))\"\n";
  for (int i = 1; i <= 4000; ++i) {
    text += fmt::format("d{} = \"d{} + 1\"\n", i, i - 1);
  }
  const CheckedModel checked = checked_model(model_text("chain", text));
  const auto lagrangian = formulate(checked.model);
  REQUIRE(lagrangian.diagnostics.size() == 1);
  CHECK(lagrangian.diagnostics.front().code == Code::E312);
}

TEST_CASE("a division by zero found only by algebra is reported at its position") {
  // `checked` must outlive the error, whose span points into the model's source.
  const CheckedModel checked = checked_model(model_text("nowhere", R"toml(
[[coordinate]]
name = "x"
[parameters]
k = 2
[energy]
T = "k*dot(x)^2/2"
V = "k/(x + 1 - (x + 1))"
)toml"));
  const auto lagrangian = formulate(checked.model);
  REQUIRE_FALSE(lagrangian);
  const Diagnostic& error = lagrangian.diagnostics.front();
  CHECK(error.code == Code::E312);
  CHECK(covered_text(error.span) == "k/(x + 1 - (x + 1))");
}

TEST_CASE("the rate of a scalar is its velocity, the rate of a quaternion a definition") {
  const Lagrangian lagrangian = formulate_model();
  const Symbols& s = lagrangian.symbols;
  REQUIRE(s.q_rates.size() == 5);
  CHECK(s.q_rates[0].is_equal(s.v[0]));
  REQUIRE(s.rotations.size() == 1);
  CHECK(s.rotations[0].first_coordinate == 1);
  CHECK(s.rotations[0].first_velocity == 1);
  const SymbolPlace& place = lagrangian.definitions.places.at(s.q_rates[1]);
  REQUIRE(place.is_definition);
  CHECK(lagrangian.definitions.list[place.index].name == "e_w_dot");
}

TEST_CASE("N^T e = 0 and N^T N = 1/4 for unit quaternions") {
  const Lagrangian lagrangian = formulate_model();
  const Symbols& s = lagrangian.symbols;
  const auto n = rate_matrix(s, s.rotations[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    ex along = 0;
    for (std::size_t c = 0; c < 4; ++c) along += n[c][i] * s.q[1 + c];
    CHECK(along.expand().is_zero());
    for (std::size_t j = 0; j < 3; ++j) {
      ex product = 0;
      ex length = 0;
      for (std::size_t c = 0; c < 4; ++c) {
        product += n[c][i] * n[c][j];
        length += s.q[1 + c] * s.q[1 + c];
      }
      const ex expected = i == j ? length / 4 : ex(0);
      CHECK((product - expected).expand().is_zero());
    }
  }
}

}  // namespace elgen::test
