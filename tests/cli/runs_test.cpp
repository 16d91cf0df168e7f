// elgen tradeoff --trajectory: runs by all methods; no time is looked at.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("runs have a row for each method and step, and shorter steps smaller errors") {
  const Workspace workspace;
  const Outcome outcome = shell(
      "elgen tradeoff --trajectory 2 --as json --max-error 1e-6 "
      "-o x.svg " +
          models + "/double_pendulum.toml",
      workspace.path());
  INFO(outcome.errors);
  REQUIRE(outcome.status == 0);
  const auto table = nlohmann::json::parse(outcome.output);
  const auto error = [&table](const std::string& method, const std::string& step) {
    for (const auto& design : table["designs"]) {
      const auto& values = design["design"];
      if (values["method"] == method && values["step"] == step) {
        return design["error"]["worst"].get<double>();
      }
    }
    return -1.0;
  };
  CHECK(error("rk4", "0.0002 s") > 0);
  CHECK(error("rk4", "0.002 s") > 100 * error("rk4", "0.0002 s"));
  CHECK(error("dopri5", "to 1e-10") < 1e-8);
  CHECK(error("verlet", "0.002 s") == -1);
  CHECK(table["sentences"].back() == "`verlet` is not for this system: M depends on `theta1`");
  CHECK(mentions(outcome.errors, "cheapest within 1e-06: "));
  CHECK(starts_with(read_text(workspace.path() / "x.svg"), "<svg "));
}

TEST_CASE("what is about an output is not about runs") {
  const Workspace workspace;
  for (const char* option : {"--of gravity", "--dimensions order", "--range q1=0..1",
                             "--max-error 1 --write-scene x.scene.toml"}) {
    INFO(option);
    CHECK(shell(std::string("elgen tradeoff --trajectory 2 ") + option + " " + models +
                    "/double_pendulum.toml",
                workspace.path())
              .status == 2);
  }
}

}  // namespace elgen::test
