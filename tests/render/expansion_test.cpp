// What a page says of an expansion.
#include <catch2/catch.hpp>

#include "elgen/render.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("exact equations say nothing") {
  CHECK(expansion_text(checked_model(cart_pole_text()).model).empty());
}

TEST_CASE("the point and the order are named, inputs where they are small") {
  const CheckedModel all =
      approximated(cart_pole_text(), "order = 1\nabout = { x = 0, theta = \"pi/2\" }");
  CHECK(expansion_text(all.model) ==
        "Expanded about x = 0, theta = pi/2, u = 0: right to order 1 in the deviations from "
        "there, the rates and the accelerations together.");
  const CheckedModel some = approximated(cart_pole_text(), "order = 2\nabout = { theta = 0 }");
  CHECK(expansion_text(some.model) ==
        "Expanded about theta = 0: right in the equations of theta to order 2 (in others to order "
        "3) in the deviations from there, their rates and their accelerations together; exact in "
        "all else.");
}
