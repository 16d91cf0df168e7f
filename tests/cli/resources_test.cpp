// After a limit or an interrupt the process exits with the documented code and leaves no files.
#include <catch2/catch.hpp>
#include <regex>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

/// A chain whose derivation takes several seconds.
const std::string long_job = "elgen generate --limit derived_nodes=1000000000 --size n=400 " +
                             std::string(ELGEN_SOURCE_DIR) + "/models/chain.toml ";

}  // namespace

TEST_CASE("limits of time and memory and interrupts end the process in order") {
  const std::string interrupted = "timeout --preserve-status -s ";
  const Workspace workspace;
  for (const auto& [command, status, code] :
       {std::tuple{long_job + "--limit seconds=1", 3, "[E909]"},
        std::tuple{long_job + "--limit memory_mib=64", 3, "[E910]"},
        std::tuple{interrupted + "INT 0.5 " + long_job, 130, ""},
        std::tuple{interrupted + "TERM 0.5 " + long_job, 130, ""},
        std::tuple{interrupted + "HUP 0.5 " + long_job, 130, ""}}) {
    INFO(command);
    const Outcome outcome = workspace.run(command);
    CHECK(outcome.status == status);
    CHECK(mentions(outcome.errors, code));
    CHECK(workspace.run("ls").output.empty());
  }
}

TEST_CASE("an ignored signal ends nothing") {
  CHECK(Workspace()
            .run("trap '' HUP; elgen show " ELGEN_SOURCE_DIR
                 "/models/panda7.toml & sleep 0.1; kill -HUP $!; wait $!")
            .status == 0);
}

TEST_CASE("the limit and interrupts end a sleeping compiler and remove its folder") {
  const Workspace workspace;
  workspace.write("slow", "#!/bin/sh\ntest \"$1\" = --version && exit 0\nsleep 7713\n");
  workspace.prepare("chmod +x slow && mkdir tmp");
  const std::string verify =
      "TMPDIR=$PWD/tmp CXX=./slow elgen verify -q --samples 2 " ELGEN_SOURCE_DIR
      "/models/simple_pendulum.toml";
  const Outcome late = workspace.run(verify + " --limit seconds=2");
  CHECK(late.status == 0);
  CHECK(mentions(late.output, "1 skipped"));
  for (const std::string signal : {"INT", "TERM", "HUP"}) {
    INFO(signal);
    // A shell starts background processes with SIGINT ignored; timeout restores SIGINT.
    const Outcome outcome =
        workspace.run("export TMPDIR=$PWD/tmp CXX=./slow; timeout --preserve-status -s " + signal +
                      " 3 elgen verify "
                      "-q --samples 2 " ELGEN_SOURCE_DIR "/models/simple_pendulum.toml");
    CHECK(outcome.status == 130);
  }
  CHECK(workspace.run("ls tmp").output.empty());
  CHECK(workspace.run("pgrep -f 'sleep 7713'").status == 1);
}

TEST_CASE("a limit on the size of files leaves no temporary folder") {
  const Workspace workspace;
  workspace.prepare("mkdir tmp");
  const std::string model = ELGEN_SOURCE_DIR "/models/double_pendulum.toml";
  const std::string limited = "ulimit -f 4; TMPDIR=$PWD/tmp elgen ";
  const Outcome run = workspace.run(limited + "verify -q --samples 1 " + model);
  CHECK(run.status == 4);
  CHECK(mentions(run.errors, "error[E706]"));
  CHECK(workspace.run("ls -A tmp").output.empty());
  const Outcome generated = workspace.run(limited + "generate -q " + model);
  CHECK(generated.status == 4);
  CHECK(mentions(generated.errors, "could not be written: File too large"));
  CHECK(workspace.files().empty());
}

TEST_CASE("a limit exceeded while the process ends is reported completely or not at all") {
  const Workspace workspace;
  for (int i = 0; i < 30; ++i) {
    const Outcome outcome = workspace.run("elgen generate -q -o out --limit seconds=0 " +
                                          std::string(ELGEN_SOURCE_DIR) + "/models/cart_pole.toml");
    INFO(outcome.errors);
    CHECK((outcome.status == 0 || outcome.status == 3));
    CHECK((outcome.errors.empty() ||
           starts_with(outcome.errors, "elgen: error[E909]: 0 s of processor time are used up")));
  }
}

TEST_CASE("the limit of processor time names the stage that it ended") {
  const Workspace workspace;
  const Outcome outcome = workspace.run(long_job + "-q -o out --limit seconds=1");
  CHECK(outcome.status == 3);
  const std::regex named(
      "elgen: error\\[E909\\]: 1 s of processor time are used up, in `[a-z-]+`\n"
      "      `--limit seconds=N` raises the limit\n");
  INFO(outcome.errors);
  CHECK(std::regex_match(outcome.errors, named));
}

}  // namespace elgen::test
