// Matrices of frames against the oracle, and the laws they obey.
#include "derive/tree_matrices.hpp"

#include <catch2/catch.hpp>

#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("mass and Coriolis matrices of frames", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    INFO(name);
    Framed system(text);
    CHECK(system.agrees("mass_matrix"));
    CHECK(system.agrees("coriolis_matrix"));
    CHECK(system.agrees("forward_dynamics"));
    if (!system.checked.model.inputs.empty()) CHECK(system.agrees("input_matrix"));
  }
}

TEST_CASE("outputs of frames: pose, Jacobian of the twist, and its bias", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    Framed system(text);
    for (const OutputRequest& request : system.checked.scene.outputs) {
      if (request.kind != OutputKind::user_value && request.kind != OutputKind::user_jacobian &&
          request.kind != OutputKind::user_bias) {
        continue;
      }
      INFO(name << " " << request.name);
      CHECK(system.agrees(request.name));
    }
  }
}
