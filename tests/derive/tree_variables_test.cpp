// What moves a tree, and how it depends on the coordinates.
#include "derive/tree/tree_variables.hpp"

#include <catch2/catch.hpp>

#include "derive/tree/tree_matrices.hpp"
#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("angles and components of offsets that coordinates move are variables", "[frames]") {
  const Framed system(sliders_text());
  Derivation derivation(system.lagrangian);
  const TreeVariables variables = tree_variables(tree_of(derivation));
  CHECK(variables.is_complete);
  // x, x/3 of the cabin; q of the arm; s, s^2/3 of the bead; 2 s, s q of the nozzle
  REQUIRE(variables.list.size() == 7);
  CHECK(variables.list[0].velocity[0].is_equal(1));
  CHECK(variables.list[1].velocity[1].is_equal(1));
  CHECK(variables.list[2].spin[1].is_equal(1));
  CHECK(variables.list[0].step == variables.list[1].step);
  CHECK(variables.list[0].step < variables.list[2].step);
}

TEST_CASE("what time moves is no variable", "[frames]") {
  const Framed system(turntable_text());
  Derivation derivation(system.lagrangian);
  Tree& tree = tree_of(derivation);
  const TreeVariables variables = tree_variables(tree);
  REQUIRE(variables.list.size() == 2);
  const std::vector<Coefficient> row = jacobian_row(tree, variables.list[1]);
  REQUIRE(row.size() == 2);
  CHECK(row[0].velocity == 0);
  CHECK(row[0].value.is_equal(2));
  CHECK(row[1].value.is_equal(1));
  CHECK(is_constant(derivation.definitions, row));
}

TEST_CASE("quaternions over coordinates have no variables", "[frames]") {
  const Framed system(quaternion_text());
  Derivation derivation(system.lagrangian);
  CHECK_FALSE(tree_variables(tree_of(derivation)).is_complete);
}

TEST_CASE("derivatives by columns need variables linear in the coordinates", "[frames]") {
  const auto is_linear = [](const std::string& text) {
    Derivation derivation(Framed(text).lagrangian);
    return has_linear_variables(tree_of(derivation));
  };
  CHECK(is_linear(two_turns_text()));
  CHECK(is_linear(turntable_text()));
  CHECK(is_linear(two_arms_text()));
  CHECK_FALSE(is_linear(sliders_text()));
  CHECK_FALSE(is_linear(quaternion_text()));
}
