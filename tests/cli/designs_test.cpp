// Designs on the bench: what they share, and what becomes of one that fails.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

namespace {

/// A compiler that tells of every library it makes, and refuses those whose source has a word.
void write_compiler(const Workspace& workspace, const std::string& refused) {
  write_text(workspace.path() / "compiler.sh",
             "for word; do case $word in */timing_driver.cpp)\n"
             "  echo made >> " +
                 (workspace.path() / "made").string() + "\n" + "  grep -q '" + refused +
                 "' \"$word\" && exit 1 ;; esac; done\nexec c++ \"$@\"\n");
}

}  // namespace

TEST_CASE("ten designs are made in four libraries") {
  const Workspace workspace;
  write_compiler(workspace, "no such word");
  const Outcome outcome = shell("CXX=\"sh $PWD/compiler.sh\" elgen tradeoff -q --format json " +
                                    models + "/simple_pendulum.toml",
                                workspace.path());
  INFO(outcome.errors);
  REQUIRE(outcome.status == 0);
  CHECK(nlohmann::json::parse(outcome.output)["designs"].size() == 10);
  CHECK(read_text(workspace.path() / "made") == "made\nmade\nmade\nmade\n");
}

TEST_CASE("designs that are not compiled say so, the others are measured, and it exits with 4") {
  const Workspace workspace;
  write_compiler(workspace, "fixed");
  const Outcome outcome = shell("CXX=\"sh $PWD/compiler.sh\" elgen tradeoff -q --format json " +
                                    models + "/simple_pendulum.toml",
                                workspace.path());
  CHECK(outcome.status == 4);
  CHECK(mentions(outcome.errors, "E705"));
  const auto table = nlohmann::json::parse(outcome.output);
  const auto& designs = table["designs"];
  CHECK(std::count_if(designs.begin(), designs.end(), [](const auto& design) {
          return design.contains("failure") && design["design"]["parameters"] == "fixed";
        }) == 5);
  CHECK(std::count_if(designs.begin(), designs.end(),
                      [](const auto& design) { return design.contains("cost"); }) == 5);
}

}  // namespace elgen::test
