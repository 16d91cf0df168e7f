// Values for leaves in every part of a Lagrangian: specialise_test.cpp has the parts one by one.
#include "specialise/replace.hpp"

#include <catch2/catch.hpp>

#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("a leaf is replaced through definitions, and equal values share one") {
  Lagrangian lagrangian = *formulate(checked_model(cart_pole_text()).model);
  const std::vector<Definition> old = lagrangian.definitions.list;
  replace(lagrangian, {{lagrangian.symbols.q[1], 0}});
  // The bob stands above the cart: its x is the cart's.
  CHECK(lagrangian.masses[1].position[0].is_equal(lagrangian.masses[0].position[0]));
  // The old definitions stay, unreached.
  REQUIRE(lagrangian.definitions.list.size() >= old.size());
  for (std::size_t i = 0; i < old.size(); ++i) {
    CHECK(lagrangian.definitions.list[i].symbol.is_equal(old[i].symbol));
    CHECK(lagrangian.definitions.list[i].value.is_equal(old[i].value));
  }
  CHECK_FALSE(dependence(lagrangian.definitions, lagrangian.masses[1].position[1])
                  .has_any(Opcode::coordinate));
}
