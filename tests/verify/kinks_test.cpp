// Kinks: sides of abs, sign, min and max, by the oracle.
#include "verify/states/kinks.hpp"

#include <catch2/catch.hpp>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

State at(const Model& model, const char* x) {
  State state = nominal_state(model, {});
  state.q[0] = exact(x);
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
