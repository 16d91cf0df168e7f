// Momenta and kinetic energies by twists against the oracle, which sees bodies in the world.
#include "derive/tree_twists.hpp"

#include <catch2/catch.hpp>

#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("momenta and kinetic energies of frames", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    Framed system(text);
    for (const char* output : {"momentum", "kinetic_energy", "energy_function"}) {
      INFO(name << " " << output);
      CHECK(system.agrees(output));
    }
  }
}
