// elgen import: the model on stdout or in a file, which is not overwritten without --force; notes
// grouped by kind.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {
namespace {

const std::string golden = std::string(ELGEN_SOURCE_DIR) + "/tests/urdf/golden/gripper.toml";

const std::string mass =
    "<inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" "
    "iyz=\"0\"/></inertial>";

std::string turning(const std::string& parent, const std::string& child) {
  return "<joint name=\"" + parent + child + "\" type=\"revolute\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/></joint>\n";
}

/// The messages of an import of a robot. a is the world; a and d have masses, b and c have none.
std::string import_messages(const std::string& options) {
  const Workspace workspace;
  workspace.write("r.urdf",
                  "<robot name=\"r\"><link name=\"a\">" + mass +
                      "</link>\n<gazebo/>\n<gazebo/>\n<link name=\"b\"/>\n<link name=\"c\"/>\n"
                      "<link name=\"d\">" +
                      mass + "</link>\n<sensor/>\n" + turning("a", "b") + turning("b", "c") +
                      turning("c", "d") + "</robot>\n");
  return workspace.run("elgen import -o r.toml " + options + " r.urdf").errors;
}

}  // namespace

TEST_CASE("the model goes to stdout, notes to stderr") {
  const Workspace workspace;
  const Outcome outcome = workspace.run("elgen import " + robot);
  CHECK(outcome.status == 0);
  CHECK(outcome.output == read_text(golden));
  CHECK(mentions(outcome.errors, "note[E815]: `<gazebo>` in `<robot>` is not imported"));
  CHECK(workspace.files().empty());
}

TEST_CASE("option -o writes a file and names the model, --force writes it again") {
  const Workspace workspace;
  const std::string command = "elgen import " + robot + " -o new/arm.toml";
  const std::string named_arm =
      replaced(read_text(golden), "name        = \"gripper_1\"", "name        = \"arm\"");
  const Outcome first = workspace.run(command);
  CHECK(first.status == 0);
  CHECK(first.output.empty());
  CHECK(mentions(first.errors, "wrote new/arm.toml"));
  CHECK(workspace.read("new/arm.toml") == named_arm);

  workspace.write("new/arm.toml", "mine\n");
  const Outcome second = workspace.run(command);
  CHECK(second.status == 4);
  CHECK(mentions(second.errors, "error[E703]: `new/arm.toml` exists\n      --force overwrites it"));
  CHECK(workspace.read("new/arm.toml") == "mine\n");
  CHECK(workspace.run(command + " --force").status == 0);
  CHECK(workspace.read("new/arm.toml") == named_arm);
  CHECK(workspace.files() == "./new/arm.toml\n");
}

TEST_CASE("option --check compares a model with the current import of the robot") {
  const Workspace workspace;
  workspace.prepare("cp " + robot + " hand.urdf && elgen import -q -o hand.toml hand.urdf");
  const Outcome same = workspace.run("elgen import --check hand.toml hand.urdf");
  CHECK(same.status == 0);
  CHECK(same.output.empty());
  CHECK(mentions(same.errors, "hand.toml is current\n"));
  CHECK(workspace.run("elgen import -q --floating-base --check hand.toml hand.urdf").status == 1);
  workspace.prepare("sed -i 's/mass value=\"/&1/' hand.urdf");
  const Outcome other = workspace.run("elgen import -q --check hand.toml hand.urdf");
  CHECK(other.status == 1);
  CHECK(mentions(other.errors,
                 "error[E715]: `hand.toml` differs from the import of `hand.urdf`\n"
                 "      import it with `-o OTHER.toml`; `elgen diff` then shows the changes\n"));
  CHECK(workspace.run("elgen import --check none.toml hand.urdf").status == 2);
  CHECK(workspace.run("elgen import --check hand.toml -o x.toml hand.urdf").status == 2);
}

TEST_CASE("option --check ignores the names of files") {
  const Workspace workspace;
  workspace.prepare(
      "cp " + robot +
      " hand.urdf && elgen import -q -o hand.toml hand.urdf && cp hand.toml "
      "kept.toml && mv hand.urdf other.urdf && elgen import -q other.urdf > out.toml");
  CHECK(workspace.run("elgen import -q --check hand.toml other.urdf").status == 0);
  CHECK(workspace.run("elgen import -q --check kept.toml other.urdf").status == 0);
  CHECK(workspace.run("elgen import -q --check kept.toml - < other.urdf").status == 0);
  CHECK(workspace.run("elgen import -q --check out.toml other.urdf").status == 0);
  CHECK(workspace.run("elgen import -q --floating-base --check kept.toml other.urdf").status == 1);
  workspace.prepare("sed -i 's/Gripper/Grasper/' kept.toml");
  CHECK(workspace.run("elgen import -q --check kept.toml other.urdf").status == 1);
}

TEST_CASE("an error in the robot writes nothing and exits with 2") {
  const Workspace workspace;
  workspace.write("bad.urdf", "<robot name=\"r\"></robot>\n");
  const Outcome outcome = workspace.run("elgen import bad.urdf -o bad.toml");
  CHECK(outcome.status == 2);
  CHECK(outcome.output.empty());
  CHECK(workspace.files() == "./bad.urdf\n");
}

TEST_CASE("a robot whose name cannot name a model is not imported") {
  const Workspace workspace;
  const Outcome outcome = workspace.run("elgen import " + robot + " -o write.toml");
  CHECK(outcome.status == 2);
  CHECK(outcome.errors ==
        "elgen: error[E701]: `write` cannot name a model: C or POSIX declares it\n"
        "      choose another name with `-o NAME.toml`\n");
  CHECK(workspace.files().empty());
  workspace.write("r.urdf", "<robot name=\"Pause\"><link name=\"a\">" + mass + "</link></robot>");
  CHECK(mentions(workspace.run("elgen import r.urdf").errors, "`pause` cannot name a model"));
  CHECK(workspace.run("elgen import -o kept.toml r.urdf").status == 0);
}

TEST_CASE("a file beyond the limit is not read") {
  const Outcome outcome = run("elgen --limit file_bytes=100 import " + robot);
  CHECK(outcome.status == 2);
  CHECK(mentions(outcome.errors, "[E901]"));
}

TEST_CASE("notes of one kind are counted and printed once") {
  const std::string text = import_messages("");
  CHECK(mentions(text,
                 "elgen: note[E815]: `<gazebo>` in `<robot>` is not imported, 2 times, from "
                 "line 2 on\n"));
  CHECK(mentions(
      text,
      "elgen: note[E816]: `b` moves but has no mass, and the same for 1 other, from line 4 on\n"));
  CHECK(mentions(text, "r.urdf:7:2: note[E815]: `<sensor>` in `<robot>` is not imported\n"));
  CHECK(mentions(text, "r.urdf:1:29: warning[E817]"));
  CHECK(mentions(text, "-v prints every note with its place\n"));
}

TEST_CASE(
    "with -v or machine-readable formats every note has its position, with -q there are no notes") {
  for (const std::string place : {"r.urdf:2:2: note[E815]", "r.urdf:3:2: note[E815]",
                                  "r.urdf:4:13: note[E816]", "r.urdf:5:13: note[E816]"}) {
    CHECK(mentions(import_messages("-v"), place));
  }
  CHECK(mentions(import_messages("--format github"), "file=r.urdf,line=3"));
  CHECK_FALSE(mentions(import_messages("-q"), "note["));
  CHECK(mentions(import_messages("-q"), "warning[E817]"));
}

}  // namespace elgen::test
