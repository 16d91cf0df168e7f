// A trajectory in a few lines.
#include <catch2/catch.hpp>

#include "elgen/simulate.hpp"

using namespace elgen;

TEST_CASE("last state, drifts, and the cost of a step") {
  Trajectory trajectory;
  trajectory.model = "top";
  trajectory.method = "rk4";
  trajectory.columns = {{"t", "s", ""}, {"phi", "rad", "phi"}, {"dot(phi)", "", ""}};
  trajectory.last = {2, 0.5, -3};
  trajectory.energy = {"E - E0", "|T| + |V|", 1.036e-3, 2.2e-10, 0.46};
  trajectory.momenta = {{"phi", "sum |M v|", 0, 0, 3}};
  trajectory.steps = 200;
  trajectory.nanoseconds = 41.7;
  CHECK(to_text(trajectory) == R"(top by rk4: 200 steps to t = 2
  phi      = 0.5 rad
  dot(phi) = -3
  E - E0: worst 1.036e-03, secular +2.2e-10, relative to |T| + |V| = 0.46
  momentum of phi: worst 0.000e+00, secular +0.0e+00, relative to sum |M v| = 3
  42 ns per step
)");
}
