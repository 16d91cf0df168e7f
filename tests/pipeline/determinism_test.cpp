// Every process writes the same bytes, whatever its addresses, locale and working directory.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

const std::string models = std::string(ELGEN_SOURCE_DIR) + "/models";
const std::string all_inputs = models + "/*.toml " + models + "/scenes/*.scene.toml";

std::string differences(const std::string& left, const std::string& right,
                        const std::filesystem::path& folder) {
  return shell("diff -r " + left + " " + right, folder).output;
}

/// The arms need more than a second each.
const std::string arms = "$(ls " + all_inputs + " | grep -e panda7 -e ur5)";
const std::string others = "$(ls " + all_inputs + " | grep -v -e panda7 -e ur5)";

void repeat(int processes, const std::string& inputs) {
  const Workspace workspace;
  for (int process = 1; process <= processes; ++process) {
    const std::string folder = "out" + std::to_string(process);
    REQUIRE(failure_of(workspace.run("elgen generate -q -o " + folder + " " + inputs)) == "");
    CHECK(differences("out1", folder, workspace.path()).empty());
  }
}

}  // namespace

TEST_CASE("different processes write the same bytes") {
  repeat(3, others);
  repeat(2, arms);
}

TEST_CASE("a locale with decimal commas and another working directory change nothing") {
  const Workspace workspace;
  const std::string german = "LOCPATH=$PWD/locales LC_ALL=de_DE.UTF-8 ";
  REQUIRE(workspace
              .run("mkdir -p locales elsewhere/below && "
                   "localedef -i de_DE -f UTF-8 ./locales/de_DE.UTF-8 && " +
                   german + "/usr/bin/printf %.1f 2,5")
              .output == "2,5");

  // Two models suffice, because the same few functions write all models.
  workspace.prepare("mkdir models && cp " + models + "/cart_pole.toml " + models +
                    "/simple_pendulum.toml models && elgen generate -q -o plain models/*.toml");
  REQUIRE(
      failure_of(workspace.run(
          "LOCPATH=$PWD/locales; LC_ALL=de_DE.UTF-8; export LOCPATH LC_ALL; cd elsewhere/below && "
          "elgen generate -q -o ../../german ../../models/cart_pole.toml "
          "$PWD/../../models/s*.toml")) == "");
  CHECK(differences("plain", "german", workspace.path()).empty());
}

}  // namespace elgen::test
