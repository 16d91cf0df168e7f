// Leaf names and dimensions of a model.
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

TEST_CASE("dimensions count scalars") {
  const Dimensions size = dimensions(checked(file_text("models/chain.toml")).model);
  CHECK(size.coordinates == 5);
  CHECK(size.velocities == 5);
  CHECK(size.inputs == 5);
  CHECK(size.parameters == 11);
}

}  // namespace
}  // namespace elgen::test
