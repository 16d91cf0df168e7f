// Inertial forces of bodies in frames against the oracle, which sees them in the world.
#include "derive/tree/tree_dynamics.hpp"

#include <catch2/catch.hpp>

#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("forces of frames", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    Framed system(text);
    for (const char* output :
         {"velocity_force", "drift", "dissipation", "applied_force", "bias", "inverse_dynamics"}) {
      INFO(name << " " << output);
      CHECK(system.agrees(output));
    }
  }
}
