// Equations are compared inside the declared ranges, at unit quaternions.
#include "readback/states.hpp"

#include <cln/integer.h>

#include <catch2/catch.hpp>

#include "changes.hpp"
#include "support/frame_systems.hpp"

namespace elgen::reading {

TEST_CASE("states differ, and lie in their ranges") {
  const Model& model = test::cpp().checked.model;
  const auto states = comparison_states(model, test::cpp().program.leaves, 5);
  REQUIRE(states.size() == 5);
  for (const Arguments<Real>& state : states) {
    CHECK(abs(state.q[0]).value() < cln::cl_R(2));
    CHECK(state.parameters.size() == test::cpp().program.leaves.parameters.size());
  }
  CHECK(states[0].q[0].value() != states[1].q[0].value());
}

TEST_CASE("rotations are unit quaternions") {
  const test::Written tumbler = test::written(test::tumbler_text());
  const Model& model = tumbler.checked.model;
  const std::uint32_t first = model.rotations.front().first_coordinate;
  for (const auto& state : comparison_states(model, tumbler.program.leaves, 4)) {
    Real norm;
    for (std::uint32_t i = 0; i < 4; ++i) norm = norm + state.q[first + i] * state.q[first + i];
    const Real error = abs(norm - Real(cln::cl_R(1)));
    CHECK(error.value() < cln::cl_RA(1) / cln::expt_pos(cln::cl_I(10), 50));
  }
}

}  // namespace elgen::reading
