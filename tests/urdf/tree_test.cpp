// The tree of links, mimic joints, and joints that must move a mass.
#include "urdf/tree.hpp"

#include <catch2/catch.hpp>

#include "support/text.hpp"
#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

std::string links(const std::string& names) {
  std::string text = "<robot name=\"r\">\n";
  for (const char name : names) text += std::string("<link name=\"") + name + "\"/>";
  return text + "\n";
}

std::string tree_messages(const std::string& text) {
  const urdf::Robot robot = robot_of(text + "</robot>");
  return messages(urdf::make_tree(robot).diagnostics);
}

std::string link(const std::string& name, const std::string& mass, const std::string& izz = "2") {
  return "<link name=\"" + name + "\"><inertial><mass value=\"" + mass +
         "\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"" + izz +
         "\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\n";
}

std::string messages_about(const std::string& inside) {
  const urdf::Robot robot = robot_of("<robot name=\"r\">\n" + inside + "</robot>");
  return messages(urdf::check_masses(robot, tree_of(robot)));
}

}  // namespace

TEST_CASE("parents come first, children in the order of the file") {
  const urdf::Robot robot = robot_of(links("abcde") + joint("cd") + joint("ac", "fixed") +
                                     joint("ab") + joint("be") + "</robot>");
  const urdf::LinkTree tree = tree_of(robot);
  CHECK(tree.root == 0);
  std::string order;
  for (const urdf::Branch& branch : tree.branches) {
    order += robot.joints[branch.joint].name.text + std::to_string(branch.depth) +
             (branch.is_moving ? "m " : " ");
  }
  CHECK(order == "ac0 cd1m ab0m be1m ");
}

TEST_CASE("a fixed joint moves if a joint before it moves") {
  const urdf::Robot robot =
      robot_of(links("abc") + joint("ab") + joint("bc", "fixed") + "</robot>");
  CHECK(tree_of(robot).branches[1].is_moving);
}

TEST_CASE("errors for equal names") {
  CHECK(tree_messages(links("aba") + joint("ab") + joint("ab")) ==
        "E807 2:45 `a` names two links\n"
        "E807 4:14 `ab` names two joints\n"
        "E809 4:65 `b` is the child of two joints\n");
}

TEST_CASE("errors for links that do not exist") {
  CHECK(tree_messages("<robot name=\"r\"><link name=\"base\"/><link name=\"arm\"/>\n"
                      "<joint name=\"j\" type=\"fixed\"><parent link=\"bsae\"/>"
                      "<child link=\"gripper\"/></joint>") ==
        "E808 2:44 the robot has no link `bsae` | did you mean `base`?\n"
        "E808 2:64 the robot has no link `gripper`\n");
}

TEST_CASE("a link with two parents is reported at the second") {
  const urdf::Robot robot = robot_of(links("abc") + joint("ac") + joint("bc") + "</robot>");
  const Diagnostics found = urdf::make_tree(robot).diagnostics;
  CHECK(messages(found) == "E809 4:65 `c` is the child of two joints\n");
  CHECK(line_column(*found[0].related->source, found[0].related->begin).line == 3);
}

TEST_CASE("two roots, no root, no link, and a loop beside the tree") {
  CHECK(tree_messages(links("abc") + joint("ab")) ==
        "E809 2:45 `c` is a second root link: no joint leads to it\n");
  CHECK(tree_messages(links("ab") + joint("ab") + joint("ba")) ==
        "E809 4:65 the joints form a loop: a -> b -> a\n");
  CHECK(tree_messages(links("abcd") + joint("ab") + joint("cd") + joint("dc")) ==
        "E809 5:65 the joints form a loop: c -> d -> c\n");
  CHECK(tree_messages(links("a") + joint("aa")) == "E809 3:65 the joints form a loop: a -> a\n");
  CHECK(tree_messages("<robot name=\"r\">") == "E803 1:2 `<robot>` has no element `link`\n");
}

TEST_CASE("errors for mimic joints") {
  const std::string start = links("abcd") + joint("ab");
  const auto mimic = [](const std::string& name) { return "<mimic joint=\"" + name + "\"/>"; };
  const urdf::Robot robot =
      robot_of(start + joint("ac", "revolute", mimic("ab")) + joint("ad") + "</robot>");
  CHECK(tree_of(robot).mimicked_joints[1] == 0U);
  CHECK(tree_messages(start + joint("ac", "revolute", mimic("bc")) + joint("ad")) ==
        "E812 4:83 the robot has no joint `bc` | did you mean `ac`?\n");
  CHECK(tree_messages(start + joint("ac", "revolute", mimic("ad")) +
                      joint("ad", "revolute", mimic("ac"))) ==
        "E812 4:83 `ac` mimics itself\nE812 5:83 `ad` mimics itself\n");
  CHECK(tree_messages(start + joint("ac", "revolute", mimic("ac")) + joint("ad")) ==
        "E812 4:83 `ac` mimics itself\n");
  CHECK(tree_messages(start + joint("ac", "revolute", mimic("ad")) + joint("ad", "fixed")) ==
        "E812 4:83 `ad` is fixed: it has no coordinate to share | `--weld ac` fixes the joint that "
        "mimics\n");
  CHECK(tree_messages(start + joint("ac", "planar", mimic("ab")) + joint("ad")) ==
        "E812 4:81 `ac` is planar: it has no coordinate to share | `--weld ac` fixes the joint "
        "that mimics\n");
}

TEST_CASE("a chain of mimics ends at the joint with the shared coordinate") {
  const auto mimic = [](const std::string& name) { return "<mimic joint=\"" + name + "\"/>"; };
  const urdf::Robot robot =
      robot_of(links("abcd") + joint("ab", "revolute", mimic("bc")) +
               joint("bc", "revolute", mimic("cd")) + joint("cd") + "</robot>");
  const urdf::LinkTree tree = tree_of(robot);
  CHECK(tree.leader(0) == 2);
  CHECK(tree.leader(1) == 2);
  CHECK(tree.leader(2) == 2);
}

TEST_CASE("a cycle of mimics is an error") {
  std::string text = "<robot name=\"r\"><link name=\"l0\"/>";
  for (int i = 1; i <= 103; ++i) {
    const std::string here = std::to_string(i);
    text += "<link name=\"l" + here + "\"/>\n<joint name=\"j" + here +
            "\" type=\"revolute\"><parent link=\"l" + std::to_string(i - 1) +
            "\"/><child link=\"l" + here + "\"/>" +
            (i == 1 ? "" : "<mimic joint=\"j" + std::to_string(i - 1) + "\"/>") + "</joint>";
  }
  CHECK(tree_messages(text) ==
        "E812 102:91 `j101` mimics through 100 joints or more\n"
        "E812 103:91 `j102` mimics through 100 joints or more\n"
        "E812 104:91 `j103` mimics through 100 joints or more\n");
}

TEST_CASE("the longest chain that a file can contain does not overflow the stack") {
  std::string text = "<robot name=\"r\"><link name=\"l0\"/>";
  for (int i = 1; i < 20000; ++i) {
    const std::string here = std::to_string(i);
    text += "<link name=\"l" + here + "\"/><joint name=\"j" + here +
            "\" type=\"fixed\"><parent link=\"l" + std::to_string(i - 1) + "\"/><child link=\"l" +
            here + "\"/></joint>";
  }
  const urdf::Robot robot = robot_of(text + "</robot>");
  CHECK(tree_of(robot).branches.size() == 19999);
}

TEST_CASE(
    "a joint that moves no mass is an error, one that moves mass through other joints a note") {
  CHECK(messages_about("<link name=\"a\"/>\n<link name=\"b\"/>\n" + joint("ab", "revolute")) ==
        "E810 4:14 `ab` moves no mass | `b` has no `<mass>`, nor has any link that it carries; "
        "`--weld massless` fixes such joints\n");
  CHECK(messages_about("<link name=\"a\"/>\n" + link("b", "0") + joint("ab", "floating")) ==
        "E810 4:14 `ab` moves no mass | `b` has a `<mass>` of 0, and no link that it carries has "
        "mass; `--weld massless` fixes such joints\n");
  CHECK(messages_about("<link name=\"a\"/>\n<link name=\"b\"/>\n" + link("c", "1") +
                       joint("ab", "revolute") + joint("bc", "revolute")) ==
        "E816 3:13 `b` moves but has no mass\n");
}

TEST_CASE("an inertia without a mass suffices for a joint that rotates, not for one that slides") {
  const std::string rotor = "<link name=\"a\"/>\n" + link("b", "0");
  CHECK(messages_about(rotor + joint("ab", "continuous")).empty());
  CHECK(messages_about("<link name=\"a\"/>\n<link name=\"b\"/>\n" + link("c", "0") +
                       joint("ab", "revolute") + joint("bc", "fixed"))
            .empty());
  CHECK(messages_about(rotor + joint("ab", "prismatic")) ==
        "E810 4:14 `ab` moves no mass | `b` has a `<mass>` of 0, and no link that it carries has "
        "mass; `--weld massless` fixes such joints\n");
}

TEST_CASE("a world that no file declares exists") {
  const std::string hung = replaced(joint("ab"), "link=\"a\"", "link=\"world\"");
  CHECK(tree_messages("<robot name=\"r\">\n<link name=\"b\"/>\n" + hung).empty());
  CHECK(messages_about(link("b", "1") + hung).empty());
}

TEST_CASE("a mass fixed to a link counts as the link's own") {
  CHECK(messages_about("<link name=\"a\"/>\n<link name=\"b\"/>\n" + link("c", "1") +
                       joint("ab", "revolute") + joint("bc", "fixed"))
            .empty());
}

TEST_CASE("mass moved by a mimic joint counts for the joint that it mimics") {
  CHECK(messages_about("<link name=\"a\"/>\n<link name=\"b\"/>\n" + link("c", "1") +
                       joint("ab", "revolute") +
                       joint("ac", "revolute", "<mimic joint=\"ab\"/>")) ==
        "E816 3:13 `b` moves but has no mass\n");
}

TEST_CASE("in a chain of mimics, mass counts for the last joint") {
  CHECK(messages_about("<link name=\"a\"/><link name=\"b\"/><link name=\"d\"/>\n" + link("c", "1") +
                       joint("ab", "revolute") + joint("ad", "revolute", "<mimic joint=\"ab\"/>") +
                       joint("ac", "revolute", "<mimic joint=\"ad\"/>")) ==
        "E816 2:29 `b` moves but has no mass\n");
}

TEST_CASE("a root link with mass is the world, with a note") {
  CHECK(messages_about(link("a", "5") + link("b", "1") + joint("ab", "revolute")) ==
        "E817 2:13 `a` belongs to the world: its mass has no effect | `--floating-base` lets it "
        "move\n");
}

TEST_CASE("links fixed to the root belong to the world, and a root called world gives no note") {
  const std::string rest = link("b", "1") + link("c", "1") + link("d", "1") + joint("bc", "fixed") +
                           joint("cd", "revolute");
  CHECK(messages_about("<link name=\"a\"/>\n" + rest + joint("ab", "fixed")) ==
        "E817 3:13 `b` and 1 more link belong to the world: their mass has no effect | "
        "`--floating-base` lets it move\n");
  const std::string held = replaced(joint("ab", "fixed"), "link=\"a\"", "link=\"world\"");
  CHECK(messages_about("<link name=\"world\"/>\n" + rest + held).empty());
}

TEST_CASE("the inertia of a rotor suffices for a joint") {
  const std::string rotor =
      "<transmission><joint name=\"ab\"/><actuator><drake:rotor_inertia value=\"0.1\"/></actuator>"
      "</transmission>\n";
  CHECK(messages_about("<link name=\"a\"/>\n<link name=\"b\"/>\n" + joint("ab", "revolute") +
                       rotor) == "E816 3:13 `b` moves but has no mass\n");
}

TEST_CASE("a robot without motion or without mass is an error") {
  CHECK(messages_about("<link name=\"a\"/>\n" + link("b", "0") + joint("ab", "fixed")) ==
        "E803 1:2 no link of `<robot>` has a `<mass>`\n");
}

TEST_CASE("an inertia that no body can have gives a warning") {
  CHECK(messages_about("<link name=\"a\"/>\n" + link("b", "1", "3") + joint("ab", "revolute")) ==
        "E508 3:44 inertia 1, 1, 3, 0, 0, 0 of `b` belongs to no body | a principal inertia "
        "exceeds the sum of the other two\n");
}

}  // namespace elgen::test
