// Rotations: the rate of a unit quaternion is normal to it, and has half the length of the spin.
#include "formulate/rotations.hpp"

#include <catch2/catch.hpp>

#include "elgen/leaf_names.hpp"

namespace elgen::test {
namespace {

using GiNaC::ex;

/// A plain coordinate, then a rotation.
Model model() {
  Model result;
  append_coordinate(result, {.name = "x", .identifier = "x"});
  Rotation rotation;
  rotation.name = rotation.identifier = "e";
  append_rotation(result, rotation);
  return result;
}

Lagrangian formulated() {
  Result<Lagrangian> lagrangian = formulate(model());
  REQUIRE(lagrangian);
  return std::move(*lagrangian);
}

}  // namespace

TEST_CASE("a plain rate is its velocity, that of a quaternion a definition") {
  const Lagrangian lagrangian = formulated();
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
  const Lagrangian lagrangian = formulated();
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
