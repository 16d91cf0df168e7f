// Scripts that need optional Python packages; the tests of pages run all other scripts.
#include <catch2/catch.hpp>

#include "support/installed.hpp"
#include "support/shell.hpp"

namespace elgen::test {

TEST_CASE("torch fits a mass to measured accelerations") {
  const std::string python = "/usr/bin/python3 ";
  if (!is_installed("python3-torch", python + "-c 'import torch'")) return;
  const Workspace workspace;
  workspace.prepare("elgen generate -q --language python -o . " ELGEN_SOURCE_DIR
                    "/models/cart_pole.toml");
  const Outcome outcome = workspace.run("PYTHONPATH=cart_pole " + python +
                                        ELGEN_SOURCE_DIR "/recipes/python/fit_mass.py");
  INFO(outcome.errors);
  CHECK(outcome.output == "m = 0.230 kg\n");
}

}  // namespace elgen::test
