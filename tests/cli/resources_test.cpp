// Limits on time and memory, and interrupts: the process ends in order, and nothing is left behind.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

/// A chain that takes several seconds to derive.
const std::string long_job = "elgen generate --limit derived_nodes=1000000000 --size n=400 " +
                             std::string(ELGEN_SOURCE_DIR) + "/models/chain.toml ";

}  // namespace

TEST_CASE("processor time that is used up ends with E909 and 3") {
  const Workspace workspace;
  const Outcome outcome = workspace.run(long_job + "--limit seconds=1");
  CHECK(outcome.status == 3);
  CHECK(mentions(outcome.errors, "[E909]"));
  CHECK(workspace.run("ls").output.empty());
}

TEST_CASE("memory that is used up ends with E910 and 3") {
  const Workspace workspace;
  const Outcome outcome = workspace.run(long_job + "--limit memory_mib=64");
  CHECK(outcome.status == 3);
  CHECK(mentions(outcome.errors, "[E910]"));
  CHECK(workspace.run("ls").output.empty());
}

TEST_CASE("an interrupt ends with 130") {
  const Workspace workspace;
  const Outcome outcome = workspace.run("timeout --preserve-status -s INT 0.5 " + long_job);
  CHECK(outcome.status == 130);
  CHECK(workspace.run("ls").output.empty());
}

TEST_CASE("SIGTERM and SIGHUP end like an interrupt, unless they are ignored") {
  const Workspace workspace;
  const std::string end = "timeout --preserve-status -s ";
  CHECK(workspace.run(end + "TERM 0.5 " + long_job).status == 130);
  CHECK(workspace.run(end + "HUP 0.5 " + long_job).status == 130);
  const std::string ignoring = "trap '' HUP; elgen show " ELGEN_SOURCE_DIR
                               "/models/panda7.toml & sleep 0.1; kill -HUP $!; wait $!";
  CHECK(workspace.run(ignoring).status == 0);
}

TEST_CASE(
    "a compiler that sleeps is ended by the limit and by interrupts, and its folder removed") {
  const Workspace workspace;
  workspace.write("slow", "#!/bin/sh\ntest \"$1\" = --version && exit 0\nsleep 7713\n");
  workspace.prepare("chmod +x slow && mkdir tmp");
  const std::string verify =
      "TMPDIR=$PWD/tmp CXX=./slow elgen verify -q --samples 2 " ELGEN_SOURCE_DIR
      "/models/simple_pendulum.toml";
  const Outcome late = workspace.run(verify + " --limit seconds=2");
  CHECK(late.status == 3);
  CHECK(mentions(late.errors, "error[E909]: `./slow` has not ended within 2 s\n"));
  for (const std::string signal : {"INT", "TERM", "HUP"}) {
    INFO(signal);
    // A shell starts what runs beside it without SIGINT; timeout brings it back.
    const Outcome outcome =
        workspace.run("export TMPDIR=$PWD/tmp CXX=./slow; timeout --preserve-status -s " + signal +
                      " 3 elgen verify "
                      "-q --samples 2 " ELGEN_SOURCE_DIR "/models/simple_pendulum.toml");
    CHECK(outcome.status == 130);
  }
  CHECK(workspace.run("ls tmp").output.empty());
  CHECK(workspace.run("pgrep -f 'sleep 7713'").status == 1);
}

TEST_CASE("a limit that is reached while the process ends is told whole, or not at all") {
  const Workspace workspace;
  for (int i = 0; i < 30; ++i) {
    const Outcome outcome = workspace.run("elgen generate -q -o out --limit seconds=0 " +
                                          std::string(ELGEN_SOURCE_DIR) + "/models/cart_pole.toml");
    INFO(outcome.errors);
    CHECK((outcome.status == 0 || outcome.status == 3));
    CHECK((outcome.errors.empty() ||
           starts_with(outcome.errors, "elgen: error[E909]: 0 s of processor time are over\n")));
  }
}

}  // namespace elgen::test
