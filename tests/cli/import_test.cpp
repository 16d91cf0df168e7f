// elgen import: the model on stdout or in a file, which is not overwritten unasked.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

namespace {

const std::string golden = std::string(ELGEN_SOURCE_DIR) + "/tests/urdf/golden/gripper.toml";

}  // namespace

TEST_CASE("the model goes to stdout, notes to stderr") {
  const Workspace workspace;
  const Outcome outcome = shell("elgen import " + robot, workspace.path());
  CHECK(outcome.status == 0);
  CHECK(outcome.output == read_text(golden));
  CHECK(mentions(outcome.errors, "note[E815]: `<gazebo>` in `<robot>` is not imported"));
  CHECK(files_below(workspace.path()).empty());
}

TEST_CASE("option -o writes a file and names the model, --force writes it again") {
  const Workspace workspace;
  const std::string command = "elgen import " + robot + " -o new/arm.toml";
  std::string named_arm = read_text(golden);
  const std::string name = "name        = \"gripper_1\"";
  named_arm.replace(named_arm.find(name), name.size(), "name        = \"arm\"");
  const Outcome first = shell(command, workspace.path());
  CHECK(first.status == 0);
  CHECK(first.output.empty());
  CHECK(mentions(first.errors, "wrote new/arm.toml"));
  CHECK(read_text(workspace.path() / "new/arm.toml") == named_arm);

  write_text(workspace.path() / "new/arm.toml", "mine\n");
  const Outcome second = shell(command, workspace.path());
  CHECK(second.status == 4);
  CHECK(mentions(second.errors, "error[E703]: `new/arm.toml` exists\n      --force overwrites it"));
  CHECK(read_text(workspace.path() / "new/arm.toml") == "mine\n");
  CHECK(shell(command + " --force", workspace.path()).status == 0);
  CHECK(read_text(workspace.path() / "new/arm.toml") == named_arm);
  CHECK(files_below(workspace.path()) == "./new/arm.toml\n");
}

TEST_CASE("a mistake in the robot writes nothing and exits with 2") {
  const Workspace workspace;
  write_text(workspace.path() / "bad.urdf", "<robot name=\"r\"></robot>\n");
  const Outcome outcome = shell("elgen import bad.urdf -o bad.toml", workspace.path());
  CHECK(outcome.status == 2);
  CHECK(outcome.output.empty());
  CHECK(files_below(workspace.path()) == "./bad.urdf\n");
}

TEST_CASE("a file beyond the limit is not read") {
  const Workspace workspace;
  const Outcome outcome = shell("elgen --limit file_bytes=100 import " + robot, workspace.path());
  CHECK(outcome.status == 2);
  CHECK(mentions(outcome.errors, "[E901]"));
}

}  // namespace elgen::test
