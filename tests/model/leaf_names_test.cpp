// The names, numbers and ranges of the leaves of a model.
#include "elgen/leaf_names.hpp"

#include <catch2/catch.hpp>

#include "check/check_testing.hpp"

namespace elgen::test {
namespace {

TEST_CASE("leaves are called what the model calls them") {
  const Model model = checked(file_text("models/chain.toml")).model;
  const LeafNames leaves = leaf_names(model);
  REQUIRE(leaves.q.size() == 5);
  CHECK(leaves.q[4] == "q[5]");
  CHECK(leaves.u[0] == "tau[1]");
  CHECK(leaves.parameters.front() == "m[1]");
  CHECK_FALSE(leaves.uses_time);
  CHECK(leaf_names(checked(file_text("models/rotating_hoop.toml")).model).uses_time);
}

TEST_CASE("leaves are written as models and as C++ write them") {
  const LeafNames leaves = leaf_names(checked(file_text("models/chain.toml")).model);
  CHECK(leaf_text(leaves, Opcode::coordinate, 0) == "q[1]");
  CHECK(leaf_text(leaves, Opcode::velocity, 0) == "dot(q[1])");
  CHECK(leaf_text(leaves, Opcode::acceleration, 4) == "dot(dot(q[5]))");
  CHECK(leaf_text(leaves, Opcode::time, 0) == "t");
  CHECK(leaves.h.empty());  // until a function takes it
  CHECK(identifier_of("q[5]") == "q_5");
  CHECK(identifier_of("x_cart") == "x_cart");
}

TEST_CASE("leaves are counted by what has one of each") {
  const Model model = checked(file_text("models/chain.toml")).model;
  CHECK(leaf_count(model, Opcode::parameter) == 11);
  CHECK(leaf_count(model, Opcode::coordinate) == 5);
  CHECK(leaf_count(model, Opcode::velocity) == 5);
  CHECK(leaf_count(model, Opcode::acceleration) == 5);
  CHECK(leaf_count(model, Opcode::input) == 5);
  CHECK(leaf_count(model, Opcode::time) == 1);
  const Model top = checked(file_text("models/free_body.toml")).model;
  CHECK(leaf_count(top, Opcode::coordinate) == leaf_count(top, Opcode::velocity) + 1);
}

TEST_CASE("a leaf has the range that its entry declares") {
  Model model = checked(file_text("models/cart_pole.toml")).model;
  model.coordinates[1].range = Interval{-2, 2};
  model.velocities[0].rate_range = Interval{-3, 3};
  model.inputs[0].limits = Interval{-4, 4};
  CHECK(declared_range(model, Opcode::coordinate, 1)->high == 2);
  CHECK(declared_range(model, Opcode::velocity, 0)->high == 3);
  CHECK(declared_range(model, Opcode::input, 0)->high == 4);
  CHECK_FALSE(declared_range(model, Opcode::acceleration, 0));
  CHECK_FALSE(declared_range(model, Opcode::time, 0));
}

}  // namespace
}  // namespace elgen::test
