// What runs call is derived, whatever a scene asks for.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

TEST_CASE("commands that run a system take scenes of C and of float, and with a step of their own") {
  const Workspace workspace;
  write_text(workspace.path() / "c.scene.toml",
             "format = 1\nmodel = \"" ELGEN_SOURCE_DIR
             "/models/simple_pendulum.toml\"\n"
             "name = \"c\"\n[outputs]\ngravity = true\nstep = { method = \"rk4\" }\n"
             "[numeric]\nscalar = [\"float\"]\n[emit]\nlanguage = \"c99\"\n");
  for (const char* method : {"dopri5", "verlet --step 0.01"}) {
    const Outcome outcome =
        shell(std::string("elgen simulate -q --time 0.1 c.scene.toml --method ") + method,
              workspace.path());
    INFO(outcome.errors);
    CHECK(outcome.status == 0);
  }
}

}  // namespace elgen::test
