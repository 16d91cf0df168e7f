// Sentences about a scene: what it fixes, locks and leaves out, and about what it expands.
#include <catch2/catch.hpp>

#include "elgen/render.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::vector<std::string> notes(const std::string& scene) {
  const CheckedModel checked = checked_scene(cart_pole_text(), scene);
  return scene_notes(checked.model, checked.scene);
}

}  // namespace

TEST_CASE("what a model leaves out, and whether it can be had") {
  Scene scene;
  scene.left_out = {{LeftOutReason::too_many_entries, {"mass_matrix", "linearization"}},
                    {LeftOutReason::kinked_force, {"forward_dynamics_derivatives"}}};
  CHECK(scene_notes(Model{}, scene) ==
        std::vector<std::string>{
            "Left out, with more than 4096 entries: mass_matrix, linearization. A scene or "
            "--outputs that names an output gets it.",
            "Left out, as forces with abs, sign, min or max have no derivatives: "
            "forward_dynamics_derivatives."});
}

TEST_CASE("what a scene fixes and locks") {
  CHECK(notes("") == std::vector<std::string>{});
  CHECK(notes("doc = \"Upright.\"\n[parameters]\nfixed = { l = \"1/2\", g = 9.81 }\n"
              "[lock]\nx = { value = \"sin(2*t)\" }\n") ==
        std::vector<std::string>{"Upright.", "Fixed: l = 0.5, g = 9.81.", "Locked: x = sin(2*t)."});
}

TEST_CASE("exact equations say nothing") {
  CHECK(expansion_text(checked_model(cart_pole_text()).model).empty());
}

TEST_CASE("the point and the order are named, inputs where they are small") {
  const CheckedModel all =
      approximated(cart_pole_text(), "order = 1\nabout = { x = 0, theta = \"pi/2\" }");
  CHECK(scene_notes(all.model, all.scene) == std::vector<std::string>{expansion_text(all.model)});
  CHECK(expansion_text(all.model) ==
        "Expanded about x = 0, theta = pi/2, u = 0: right to order 1 in the deviations from "
        "there, the rates and the accelerations together.");
  const CheckedModel some = approximated(cart_pole_text(), "order = 2\nabout = { theta = 0 }");
  CHECK(expansion_text(some.model) ==
        "Expanded about theta = 0: right in the equations of theta to order 2 (in others to order "
        "3) in the deviations from there, their rates and their accelerations together; exact in "
        "all else.");
}
