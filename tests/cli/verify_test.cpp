// elgen verify: certificates and exit codes.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

const std::string models = std::string(ELGEN_SOURCE_DIR) + "/models";

}  // namespace

TEST_CASE("verify: all closed forms of the models hold, a wrong one exits with 1") {
  const Workspace workspace;
  const Outcome good = shell("elgen verify --quick " + models + "/*.toml", workspace.path());
  INFO(good.output + good.errors);
  CHECK(good.status == 0);
  prepare("sed 's/\"m\\*g\\*l\\*sin(theta)\"/\"m*g*l*cos(theta)\"/' " + models +
              "/simple_pendulum.toml > wrong.toml",
          workspace.path());
  const Outcome wrong = shell("elgen verify --quick wrong.toml", workspace.path());
  CHECK(wrong.status == 1);
  CHECK(mentions(wrong.errors, "[E510]"));
}

}  // namespace elgen::test
