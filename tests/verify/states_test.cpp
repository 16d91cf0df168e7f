// SPDX-License-Identifier: GPL-3.0-or-later
// States: on which sides of kinks they lie, and at which of them a figure is worst.
#include <catch2/catch.hpp>
#include <cmath>

#include "verify/states/kinks.hpp"
#include "verify/states/tally.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

State at(const Model& model, const char* x) {
  State state = nominal_state(model, {});
  state.q[0] = exact(x);
  return state;
}

State at(const System& system, int x) {
  State state = nominal_state(system.model, system.scene);
  state.q[0] = x;
  return state;
}

}  // namespace

TEST_CASE("a model without kinks has seen them all") { CHECK(Kinks(cart_pole().model).are_seen()); }

TEST_CASE("a kink is seen once states lie on both sides of it") {
  ModelBuilder builder = cart_pole();
  builder.force_on(0, "max(x - 2, 0) + abs(x)");
  Kinks kinks(builder.model);
  CHECK(kinks.add(at(builder.model, "1")));
  CHECK_FALSE(kinks.add(at(builder.model, "3/2")));
  CHECK_FALSE(kinks.are_seen());
  CHECK(kinks.add(at(builder.model, "3")));
  CHECK_FALSE(kinks.unseen().empty());
  CHECK(kinks.add(at(builder.model, "-1")));
  CHECK(kinks.are_seen());
  CHECK(kinks.unseen().empty());
}

TEST_CASE("on the kink itself a state is on no side") {
  ModelBuilder builder = cart_pole();
  builder.force_on(0, "sign(x - 2)");
  Kinks kinks(builder.model);
  CHECK_FALSE(kinks.add(at(builder.model, "2")));
}

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
