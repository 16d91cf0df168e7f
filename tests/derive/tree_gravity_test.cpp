// Weights of subtrees against the oracle, which sees bodies in the world.
#include "derive/tree/tree_gravity.hpp"

#include <catch2/catch.hpp>

#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("weights of frames", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    Framed system(text);
    for (const char* output : {"gravity", "potential_energy", "total_energy"}) {
      INFO(name << " " << output);
      CHECK(system.agrees(output));
    }
  }
}
