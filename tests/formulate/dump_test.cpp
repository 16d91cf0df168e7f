// The dump of a Lagrangian names every part it has.
#include <catch2/catch.hpp>

#include "elgen/lagrangian.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("a dump shows masses, energies, forces and outputs") {
  const std::string text = dump(*formulate(checked_model(everything_text()).model));
  for (const char* part : {"; bead_x\n", "mass m at (", "gravity (0, ", "T = ", "V = ", "D = ",
                           "force on r = w", "force on theta = ", "tip = "}) {
    INFO(part);
    CHECK(text.find(part) != std::string::npos);
  }
}

TEST_CASE("a dump shows an L given whole") {
  CHECK(dump(*formulate(checked_model(relativistic_text()).model)).find("L = ") !=
        std::string::npos);
}
