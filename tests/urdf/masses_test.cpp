// check_masses: what moves has mass, and an inertia that some body has.
#include <catch2/catch.hpp>

#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

std::string link(const std::string& name, const std::string& mass, const std::string& izz = "2") {
  return "<link name=\"" + name + "\"><inertial><mass value=\"" + mass +
         "\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"" + izz +
         "\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\n";
}

std::string said(const std::string& inside) {
  const urdf::Robot robot = robot_of("<robot name=\"r\">\n" + inside + "</robot>");
  return messages(urdf::check_masses(robot, tree_of(robot)));
}

}  // namespace

TEST_CASE("a joint that moves no mass is an error, one that carries mass further on a note") {
  CHECK(said("<link name=\"a\"/>\n<link name=\"b\"/>\n" + joint("ab", "revolute")) ==
        "E810 4:14 `ab` moves no mass | `b` has no `<mass>`, nor has a link behind it; `--weld "
        "massless` holds such joints\n");
  CHECK(said("<link name=\"a\"/>\n" + link("b", "0") + joint("ab", "floating")) ==
        "E810 4:14 `ab` moves no mass | `b` has no `<mass>`, nor has a link behind it; `--weld "
        "massless` holds such joints\n");
  CHECK(said("<link name=\"a\"/>\n<link name=\"b\"/>\n" + link("c", "1") + joint("ab", "revolute") +
             joint("bc", "revolute")) == "E816 3:13 `b` moves without a mass\n");
}

TEST_CASE("mass that a fixed joint holds to a link is as its own") {
  CHECK(said("<link name=\"a\"/>\n<link name=\"b\"/>\n" + link("c", "1") + joint("ab", "revolute") +
             joint("bc", "fixed"))
            .empty());
}

TEST_CASE("mass that a mimicking joint moves counts for the joint it mimics") {
  CHECK(said("<link name=\"a\"/>\n<link name=\"b\"/>\n" + link("c", "1") + joint("ab", "revolute") +
             joint("ac", "revolute", "<mimic joint=\"ab\"/>")) ==
        "E816 3:13 `b` moves without a mass\n");
}

TEST_CASE("in a chain of mimics it counts for the last") {
  CHECK(said("<link name=\"a\"/><link name=\"b\"/><link name=\"d\"/>\n" + link("c", "1") +
             joint("ab", "revolute") + joint("ad", "revolute", "<mimic joint=\"ab\"/>") +
             joint("ac", "revolute", "<mimic joint=\"ad\"/>")) ==
        "E816 2:29 `b` moves without a mass\n");
}

TEST_CASE("a root link with mass is the world") {
  CHECK(said(link("a", "5") + link("b", "1") + joint("ab", "revolute")) ==
        "E817 2:13 `a` is the world: its mass plays no part | `--floating-base` lets it move\n");
}

TEST_CASE("so is what fixed joints hold to it, and a root link called world says it is") {
  const std::string rest = link("b", "1") + link("c", "1") + link("d", "1") + joint("bc", "fixed") +
                           joint("cd", "revolute");
  CHECK(said("<link name=\"a\"/>\n" + rest + joint("ab", "fixed")) ==
        "E817 3:13 `b` and 1 more link are the world: their mass plays no part | "
        "`--floating-base` lets it move\n");
  std::string held = joint("ab", "fixed");
  held.replace(held.find("link=\"a\""), 8, "link=\"world\"");
  CHECK(said("<link name=\"world\"/>\n" + rest + held).empty());
}

TEST_CASE("a rotor is inertia enough") {
  const std::string rotor =
      "<transmission><joint name=\"ab\"/><actuator><drake:rotor_inertia value=\"0.1\"/></actuator>"
      "</transmission>\n";
  CHECK(said("<link name=\"a\"/>\n<link name=\"b\"/>\n" + joint("ab", "revolute") + rotor) ==
        "E816 3:13 `b` moves without a mass\n");
}

TEST_CASE("a robot in which nothing moves and nothing has mass is no model") {
  CHECK(said("<link name=\"a\"/>\n" + link("b", "0") + joint("ab", "fixed")) ==
        "E803 1:2 no link of `<robot>` has a `<mass>`\n");
}

TEST_CASE("an inertia that no body has is a warning") {
  CHECK(said("<link name=\"a\"/>\n" + link("b", "1", "3") + joint("ab", "revolute")) ==
        "E508 3:44 inertia 1, 1, 3, 0, 0, 0 of `b` belongs to no body | a principal inertia "
        "exceeds the sum of the other two\n");
}

}  // namespace elgen::test
