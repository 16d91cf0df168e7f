// Tests the variables of a tree, and TreeColumns, which pairs two variables if one path to the root
// contains both.
#include <catch2/catch.hpp>
#include <set>

#include "derive/tree/tree_matrices.hpp"
#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using Pairs = std::multiset<std::pair<std::size_t, std::size_t>>;

Pairs visited_pairs(Derivation& derivation) {
  KinematicTree& tree = tree_of(derivation);
  const std::vector<TreeVariable> variables = tree_variables(tree).list;
  TreeColumns columns(tree, variables,
                      {derivation.rate_at_fixed_time, derivation.rate_at_fixed_time});
  Pairs pairs;
  columns.for_each_pair({ColumnKind::inertia}, [&](const ColumnPair& pair) {
    CHECK(pair.columns.size() == 1);
    CHECK(pair.is_mutual == (pair.upper != pair.lower &&
                             variables[pair.upper].transform == variables[pair.lower].transform));
    pairs.emplace(pair.upper, pair.lower);
  });
  return pairs;
}

}  // namespace

TEST_CASE("a variable is paired with itself and its ancestors, never with another arm",
          "[frames]") {
  Derivation derivation(Framed(read_model("two_arms")).lagrangian);
  // The variables by index: 0 x, 1 a1, 2 a1 + a2, 3 b1, 4 b2.
  CHECK(visited_pairs(derivation) ==
        Pairs{{0, 0}, {1, 1}, {1, 0}, {2, 2}, {2, 0}, {3, 3}, {3, 0}, {4, 4}, {4, 3}, {4, 0}});
}

TEST_CASE("variables of one step are paired in both orders", "[frames]") {
  Derivation derivation(Framed(read_model("sliders")).lagrangian);
  const Pairs pairs = visited_pairs(derivation);
  CHECK(pairs.count({0, 1}) == 1);
  CHECK(pairs.count({1, 0}) == 1);
  CHECK(pairs.count({2, 0}) == 1);
  CHECK(pairs.count({0, 2}) == 0);
}

TEST_CASE("the inertia column of a rotation is the composite inertia about its axis", "[frames]") {
  const Framed system(read_model("planar"));
  Derivation derivation(system.lagrangian);
  KinematicTree& tree = tree_of(derivation);
  const std::vector<TreeVariable> variables = tree_variables(tree).list;
  const std::vector<CompositeInertia> inertias = composite_inertias(tree);
  TreeColumns columns(tree, variables,
                      {derivation.rate_at_fixed_time, derivation.rate_at_fixed_time});
  columns.for_each_pair({ColumnKind::inertia}, [&](const ColumnPair& pair) {
    const TreeVariable& variable = variables[pair.upper];
    if (pair.upper != pair.lower || is_zero(variable.spin)) return;
    const GiNaC::ex entry = columns.twist_product(pair.lower, TwistKind::unit, pair.columns[0]);
    const NumbersAt at(derivation.symbols, derivation.definitions, some_state(system.checked));
    CHECK(nearly_equal({at(entry)}, {at(inertias[variable.transform].inertia[2])}));
  });
}

TEST_CASE("moving angles and components of offsets are variables", "[frames]") {
  const Framed system(read_model("sliders"));
  Derivation derivation(system.lagrangian);
  const TreeVariables variables = tree_variables(tree_of(derivation));
  CHECK(variables.is_complete);
  // The variables are x and x/3 of the cabin, q of the arm, s and s^2/3 of the bead, and 2 s and
  // s q of the nozzle.
  REQUIRE(variables.list.size() == 7);
  CHECK(variables.list[0].velocity[0].is_equal(1));
  CHECK(variables.list[1].velocity[1].is_equal(1));
  CHECK(variables.list[2].spin[1].is_equal(1));
  CHECK(variables.list[0].transform == variables.list[1].transform);
  CHECK(variables.list[0].transform < variables.list[2].transform);
}

TEST_CASE("a step moved only by time is no variable", "[frames]") {
  const Framed system(read_model("turntable"));
  Derivation derivation(system.lagrangian);
  KinematicTree& tree = tree_of(derivation);
  const TreeVariables variables = tree_variables(tree);
  REQUIRE(variables.list.size() == 2);
  const std::vector<JacobianEntry> row = jacobian_row(tree, variables.list[1]);
  REQUIRE(row.size() == 2);
  CHECK(row[0].velocity == 0);
  CHECK(row[0].value.is_equal(2));
  CHECK(row[1].value.is_equal(1));
  CHECK(is_constant(derivation.definitions, row));
}

TEST_CASE("derivatives by columns need variables that are linear in the coordinates", "[frames]") {
  Derivation over_coordinates(Framed(read_model("quaternion")).lagrangian);
  CHECK_FALSE(tree_variables(tree_of(over_coordinates)).is_complete);
  const auto is_linear = [](const std::string& text) {
    Derivation derivation(Framed(text).lagrangian);
    return has_linear_variables(tree_of(derivation));
  };
  CHECK(is_linear(read_model("two_turns")));
  CHECK(is_linear(read_model("turntable")));
  CHECK(is_linear(read_model("two_arms")));
  CHECK_FALSE(is_linear(read_model("sliders")));
  CHECK_FALSE(is_linear(read_model("quaternion")));
}
