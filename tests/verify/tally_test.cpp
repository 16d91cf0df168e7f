// Tallies keep the worst figure and its state, and never lose a NaN.
#include "verify/states/tally.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

State at(const System& system, int x) {
  State state = nominal_state(system.model, system.scene);
  state.q[0] = x;
  return state;
}

}  // namespace

TEST_CASE("the worst figure keeps its state") {
  const System system = cart_pole_system();
  Tally tally;
  tally.add(1, at(system, 1));
  tally.add(3, at(system, 2));
  tally.add(2, at(system, 3));
  CHECK(tally.samples() == 3);
  CHECK(tally.worst() == 3);
  CHECK(tally.where(system.subject()).find("q = (2, 0)") == 0);
  CHECK(tally.verdict(3) == Verdict::holds);
  CHECK(tally.verdict(2.9) == Verdict::fails);
}

TEST_CASE("a NaN fails, whatever comes before or after it") {
  const System system = cart_pole_system();
  Tally tally;
  tally.add(1, at(system, 1));
  tally.add(std::nan(""), at(system, 2));
  tally.add(2, at(system, 3));
  CHECK(tally.verdict(8) == Verdict::fails);
}

TEST_CASE("nothing sampled is skipped, not held") {
  Tally tally;
  tally.skip();
  CHECK(tally.verdict(8) == Verdict::skipped);
  CertificateRow row;
  tally.tell(row, cart_pole_system().subject(), 8, Obstacle::singular);
  CHECK(row.verdict == Verdict::skipped);
  CHECK(row.skipped == std::vector<SkippedStates>{{Obstacle::singular, 1}});
}
