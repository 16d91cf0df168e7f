// Identifies the base parameters of an arm from noisy torques, with the commands in
// examples/README.md.
#include <catch2/catch.hpp>

#include "consumer/projects.hpp"
#include "support/installed.hpp"

namespace elgen::test {

TEST_CASE("the example identifies base parameters from noisy torques") {
  if (!is_installed("numpy", "/usr/bin/python3 -c 'import numpy'")) return;
  const Workspace folder;
  folder.prepare("cp '" ELGEN_SOURCE_DIR
                 "/examples/identify/'* . && elgen generate -q -o . identify.scene.toml && "
                 "elgen show -q panda7.toml --what base_parameters --as json > base.json");
  const Outcome run =
      folder.run("PYTHONPATH=panda7_identify /usr/bin/python3 identify.py base.json");
  INFO(run.output << run.errors);
  CHECK(run.status == 0);
  CHECK(mentions(run.output, "43 of 70 parameters"));
  CHECK(number_after(run.output, "differ by ") <= 1e-12);
  CHECK(number_after(run.output, "200 states to ") <= 4);
}

}  // namespace elgen::test
