// Outputs that a model omits by default: every command and every file reports the omission. A scene
// that names an omitted output gets this output.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

/// A model of `count` independent masses: a large system that is derived quickly.
std::string masses(int count, const std::string& more = {}) {
  std::string text = "format = 1\n[model]\nname = \"row\"\n[energy]\nT = \"";
  for (int i = 1; i <= count; ++i) {
    text += (i == 1 ? "" : " + ") + ("dot(x" + std::to_string(i)) + ")^2";
  }
  text += "\"\n";
  for (int i = 1; i <= count; ++i) {
    text += "[[coordinate]]\nname = \"x" + std::to_string(i) + "\"\n";
  }
  return text + more;
}

const std::string friction = "[[force]]\non = \"x1\"\nvalue = \"-sign(dot(x1))\"\n";

const std::string kinked_note =
    "row.toml:10:11: note[E619]: not emitted because a force with a kink has no derivatives: "
    "`linearization`, `inverse_dynamics_derivatives`, `forward_dynamics_derivatives`\n"
    "   10 | value = \"-sign(dot(x1))\"\n"
    "      |           ^~~~~~~~~~~~~ use a smooth approximation: `tanh(x/width)` for `sign(x)`\n";

Outcome run_on(const std::string& command, const std::string& model, const Workspace& workspace) {
  workspace.write("row.toml", model);
  return workspace.run("elgen " + command);
}

}  // namespace

TEST_CASE(
    "generate, show and verify report derivatives omitted because of a kink, and its position") {
  for (const char* command : {"generate row.toml", "show row.toml", "verify --quick row.toml"}) {
    const Workspace workspace;
    const Outcome outcome = run_on(command, masses(1, friction), workspace);
    INFO(command);
    CHECK(outcome.status == 0);
    CHECK(mentions(outcome.errors, kinked_note));
  }
}

TEST_CASE("with -q, chosen outputs or derivation steps no omitted outputs are reported") {
  for (const char* command : {"generate -q row.toml", "generate --outputs bias row.toml",
                              "show --what bias row.toml", "show --what steps row.toml"}) {
    const Workspace workspace;
    const Outcome outcome = run_on(command, masses(1, friction), workspace);
    INFO(command);
    CHECK(outcome.status == 0);
    CHECK_FALSE(mentions(outcome.errors, "E619"));
  }
}

TEST_CASE("every file lists its omitted outputs") {
  const Workspace workspace;
  const Outcome outcome = run_on("generate row.toml", masses(33), workspace);
  REQUIRE(outcome.status == 0);
  CHECK(starts_with(
      outcome.errors,
      "row.toml:3:9: note[E619]: not emitted because of more than 4096 entries: `linearization`\n"
      "    3 | name = \"row\"\n"
      "      |         ^~~ name the output in a scene or in `--outputs`\n"));
  const std::string stem = "generated/row/row";
  CHECK(mentions(
      workspace.read(stem + ".hpp"),
      "\n// Left out, with more than 4096 entries: linearization. To emit one, name it in a "
      "scene or with\n// --outputs.\n"));
  CHECK(mentions(workspace.read(stem + ".md"),
                 "\nLeft out, with more than 4096 entries: linearization. "));
  CHECK(mentions(workspace.read(stem + ".equations.json"),
                 "\n  \"left_out\": {\"linearization\": \"too many entries\"},\n"));
}

TEST_CASE("headers in C list omitted outputs, and a scene without [outputs] omits them, too") {
  const Workspace workspace;
  workspace.write("c.scene.toml",
                  "format = 1\nmodel = \"row.toml\"\nname = \"c\"\n[emit]\nlanguage = \"c99\"\n");
  const Outcome outcome = run_on("generate --stdout c.scene.toml", masses(1, friction), workspace);
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.errors, "[E619]"));
  CHECK(mentions(outcome.output, "Left out, because forces with abs, sign, min or max have no"));
}

TEST_CASE("a scene gets the large outputs that it names") {
  const Workspace workspace;
  workspace.write("large.scene.toml",
                  "format = 1\nmodel = \"row.toml\"\nname = \"large\"\n"
                  "[outputs]\nlinearization = true\n");
  const Outcome outcome = run_on("generate large.scene.toml", masses(33), workspace);
  CHECK(outcome.status == 0);
  CHECK_FALSE(mentions(outcome.errors, "E619"));
  const std::string header = workspace.read("generated/row_large/row_large.hpp");
  CHECK(mentions(header, "linearization("));
  CHECK_FALSE(mentions(header, "Left out"));
}

}  // namespace elgen::test
