// make_draft: the order of a model, and what the head of its file tells.
#include "urdf/draft.hpp"

#include <catch2/catch.hpp>

#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

urdf::Draft small_draft() {
  const urdf::Robot robot = robot_of(with_arm(
      "<link name=\"tool\"/><joint name=\"tool_joint\" type=\"fixed\"><parent link=\"arm\"/><child "
      "link=\"tool\"/></joint><joint name=\"j\" type=\"revolute\"><parent link=\"base\"/><child "
      "link=\"arm\"/></joint>"));
  return urdf::make_draft(robot, tree_of(robot));
}

}  // namespace

TEST_CASE("links come with their parents first, each with its parameters") {
  const urdf::Draft draft = small_draft();
  CHECK(draft.name == "r");
  CHECK(draft.file == "r.urdf");
  REQUIRE(draft.links.size() == 2);
  CHECK(draft.links[0].frames[0].name == "arm");
  CHECK(draft.links[1].frames[0].parent == "arm");
  CHECK(draft.links[1].bodies.empty());
  CHECK(draft.parameters[0].title == "arm, on j");
  CHECK(draft.parameters[1].parameters.empty());
}

TEST_CASE("the tree names every link and its joint") {
  const urdf::Draft draft = small_draft();
  REQUIRE(draft.tree.size() == 3);
  CHECK(draft.tree[0].joint == "the world");
  CHECK(draft.tree[1].joint == "j, revolute");
  CHECK(draft.tree[2].depth == 2);
  CHECK(draft.tree[2].joint == "tool_joint, fixed");
}

TEST_CASE("a link that does not move has a frame and no body") {
  const urdf::Robot robot = robot_of(with_arm(
      "<link name=\"table\"><inertial><mass value=\"9\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" "
      "ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
      "<joint name=\"f\" type=\"fixed\"><parent link=\"base\"/><child link=\"table\"/></joint>"
      "<joint name=\"j\" type=\"revolute\"><parent link=\"table\"/><child link=\"arm\"/></joint>"));
  const urdf::Draft draft = urdf::make_draft(robot, tree_of(robot));
  CHECK(draft.links[0].frames.size() == 1);
  CHECK(draft.links[0].bodies.empty());
  CHECK(draft.links[1].bodies.size() == 1);
}

}  // namespace elgen::test
