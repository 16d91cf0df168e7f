// Many notes of an import as one line for each kind; errors and warnings as they are.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

const std::string mass =
    "<inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" "
    "iyz=\"0\"/></inertial>";

std::string turning(const std::string& parent, const std::string& child) {
  return "<joint name=\"" + parent + child + "\" type=\"revolute\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/></joint>\n";
}

/// What an import of a robot says: b and c have no mass, d has, a has and is the world.
std::string said(const std::string& options) {
  const Workspace workspace;
  write_text(workspace.path() / "r.urdf",
             "<robot name=\"r\"><link name=\"a\">" + mass +
                 "</link>\n<gazebo/>\n<gazebo/>\n<link name=\"b\"/>\n<link name=\"c\"/>\n"
                 "<link name=\"d\">" +
                 mass + "</link>\n<spring/>\n" + turning("a", "b") + turning("b", "c") +
                 turning("c", "d") + "</robot>\n");
  return shell("elgen import -o r.toml " + options + " r.urdf", workspace.path()).errors;
}

}  // namespace

TEST_CASE("what is said of many places is told once for each kind, with its count") {
  const std::string text = said("");
  CHECK(mentions(text,
                 "elgen: note[E815]: `<gazebo>` in `<robot>` is not imported, 2 times, from "
                 "line 2 on\n"));
  CHECK(mentions(text,
                 "elgen: note[E816]: `b` moves without a mass, and so for 1 other, from line "
                 "4 on\n"));
  CHECK(mentions(text, "r.urdf:7:2: note[E815]: `<spring>` in `<robot>` is not imported\n"));
  CHECK(mentions(text, "r.urdf:1:29: warning[E817]"));
  CHECK(mentions(text, "-v lists every note with its place\n"));
}

TEST_CASE("option -v and programs get every note at its place, -q what changes the mechanics") {
  for (const std::string place : {"r.urdf:2:2: note[E815]", "r.urdf:3:2: note[E815]",
                                  "r.urdf:4:13: note[E816]", "r.urdf:5:13: note[E816]"}) {
    CHECK(mentions(said("-v"), place));
  }
  CHECK(mentions(said("--format github"), "file=r.urdf,line=3"));
  CHECK_FALSE(mentions(said("-q"), "note["));
  CHECK(mentions(said("-q"), "warning[E817]"));
}

}  // namespace elgen::test
