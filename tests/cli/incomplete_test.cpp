// elgen verify --only expect.
#include <catch2/catch.hpp>
#include <string>

#include "cli/stated_testing.hpp"

namespace elgen::test {

TEST_CASE("verify --only expect: the verdict comes first, then every claim") {
  const Outcome right =
      run_with("simple_pendulum", "equations = \"l*dot(dot(theta)) = -g*sin(theta)\"\n",
               "verify --only expect");
  INFO(right.output << right.errors);
  CHECK(right.status == 0);
  CHECK(right.output.rfind("simple_pendulum: 2 checks hold, 0 fail, 0 skipped\n\n[[expect]]\n",
                           0) == 0);
  CHECK(mentions(right.output, "  holds    equations      equal\n"));
  CHECK_FALSE(mentions(right.output, "program vs oracle"));
}

TEST_CASE("verify --only expect: a model must state something") {
  const Workspace workspace;
  workspace.prepare("sed '/^\\[\\[expect\\]\\]/,$d' " + models + "/cart_pole.toml > model.toml");
  const Outcome none = workspace.run("elgen verify --only expect model.toml");
  CHECK(none.status == 2);
  CHECK(mentions(none.errors, "error[E913]: `model.toml` has no `[[expect]]` to check"));
  CHECK(workspace.run("elgen verify --only expect --quick model.toml").status == 2);
}

}  // namespace elgen::test
