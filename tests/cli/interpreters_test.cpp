// Python interpreters that do not work, are too old, print messages, end early or hang: verify
// reports this and does not blame the generated module.
#include <catch2/catch.hpp>

#include "cli/modules.hpp"

namespace elgen::test {
namespace {

const std::string verify_command =
    " elgen verify --samples 2 --language python " ELGEN_SOURCE_DIR "/models/simple_pendulum.toml";

/// Verifies a model with `python`, lines of a shell script, in place of the interpreter.
Outcome verify_with_python(const std::string& python) {
  const Workspace workspace;
  write_text(workspace.path() / "mine", "#!/bin/sh\n" + python + "\n");
  return workspace.run("chmod +x mine; export PYTHON=$PWD/mine;" + verify_command);
}

}  // namespace

TEST_CASE("python: ten models agree with the program bit by bit") {
  if (is_installed("python3", "python3 --version")) check_interpreted_models("python");
}

TEST_CASE("python: a value too large for double is inf, as in C") {
  if (!is_installed("python3", "python3 --version")) return;
  const Workspace workspace;
  workspace.write("steep.toml",
                  "format = 1\n[model]\nname = \"steep\"\n[[coordinate]]\nname = \"x\"\n[energy]\n"
                  "T = \"1/2*dot(x)^2\"\nV = \"1/(1 + exp(x)) + 1/cosh(x)\"\n");
  const Outcome outcome = workspace.run("elgen verify --samples 4 --language python steep.toml");
  CHECK(failure_of(outcome) == "");
  CHECK(mentions(outcome.output, " 0 fail, 0 skipped"));
}

TEST_CASE("an interpreter that is missing, too old or fails to start is a skipped row") {
  const Outcome missing = run("export PYTHON=/nowhere/python3;" + verify_command);
  CHECK(missing.status == 0);
  CHECK(mentions(missing.output, "`/nowhere/python3` could not be run"));
  CHECK(mentions(missing.output, "1 skipped"));
  const Outcome older = verify_with_python("echo 'elgen: ! python 2.7 is older than 3.8'");
  CHECK(older.status == 0);
  CHECK(mentions(older.output, "python 2.7 is older than 3.8"));
  const Outcome dead = verify_with_python("echo 'no such site' >&2; exit 3");
  CHECK(dead.status == 0);
  CHECK(mentions(dead.output, "mine` exits 3:"));
  CHECK(mentions(dead.output, "no such site"));
}

TEST_CASE("an interpreter may print other lines, but not end before its last answer") {
  if (!is_installed("python3", "python3 --version")) return;
  const Outcome talking = verify_with_python("echo hello; exec python3 -W error \"$@\"");
  CHECK(talking.status == 0);
  CHECK(mentions(talking.output, " 0 fail, 0 skipped"));
  const Outcome ending = verify_with_python(
      "python3 \"$@\" > answers; head -n 5 answers; [ $(wc -l < answers) -lt 6 ] || exit 9");
  CHECK(ending.status == 1);
  CHECK(mentions(ending.output, "mine` exits 9, after 3 answers"));
}

TEST_CASE("an interpreter may be isolated, and a model may have the name of the driver") {
  if (!is_installed("python3", "python3 --version")) return;
  for (const std::string python : {"export PYTHON='python3 -I';", "export PYTHONSAFEPATH=1;"}) {
    INFO(python);
    const Outcome isolated = run(python + verify_command);
    INFO(isolated.output + isolated.errors);
    CHECK(isolated.status == 0);
    CHECK(mentions(isolated.output, " 0 fail, 0 skipped"));
  }
  const Workspace workspace;
  workspace.write("driver.toml",
                  "format = 1\n[model]\nname = \"elgen_driver\"\n[[coordinate]]\nname = \"q\"\n"
                  "[energy]\nT = \"1/2*dot(q)^2\"\nV = \"cos(q)\"\n");
  const Outcome named = workspace.run("elgen verify --samples 2 --language python driver.toml");
  INFO(named.output + named.errors);
  CHECK(named.status == 0);
  CHECK(mentions(named.output, " 0 fail, 0 skipped"));
}

}  // namespace elgen::test
