// Plans: which designs there are.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tradeoff/derived.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using Texts = std::vector<std::string>;

TradeoffPlan planned(const std::string& text, const std::string& output, const Texts& more = {}) {
  const Products products = derived(text, output);
  const Result<TradeoffPlan> result = plan(*products.checked, *products.program, more);
  REQUIRE(result);
  return *result;
}

bool has(const TradeoffPlan& plan, const Texts& values) {
  return std::ranges::find(plan.designs, values, &PlannedDesign::values) != plan.designs.end();
}

/// One mass on an axis, whose momentum has no sine.
const std::string mass = model_text("mass", R"toml([[coordinate]]
name = "x"
[parameters]
m = 1e-60
[energy]
T = "m*dot(x)^2"
)toml");

}  // namespace

TEST_CASE("polynomials of 1e-7 are in packs of double, and nowhere else") {
  const TradeoffPlan plan = planned(pendulum_text(), "inverse_dynamics");
  CHECK(plan.dimensions == Texts{"scalar", "batch", "trigonometry", "parameters"});
  CHECK(plan.designs.size() == 10);
  CHECK(has(plan, {"double", "packs", "1e-7", "fixed"}));
  CHECK(has(plan, {"float", "packs", "full", "arguments"}));
  CHECK_FALSE(has(plan, {"float", "packs", "1e-7", "fixed"}));
  CHECK_FALSE(has(plan, {"double", "1", "1e-7", "fixed"}));
}

TEST_CASE("dimensions in which all designs are alike are left out") {
  const TradeoffPlan plan = planned(mass, "momentum");
  CHECK(plan.dimensions == Texts{"batch", "parameters"});
  CHECK(plan.designs.size() == 4);
}

TEST_CASE("a dimension that is asked for multiplies the designs") {
  const TradeoffPlan plan = planned(pendulum_text(), "gravity", {"order"});
  CHECK(plan.dimensions == Texts{"scalar", "batch", "trigonometry", "parameters", "order"});
  CHECK(plan.designs.size() == 10 * 3);
  CHECK(has(plan, {"float", "1", "full", "fixed", "3"}));
}

TEST_CASE("E631: a dimension that nobody knows") {
  const Products products = derived(mass, "momentum");
  const auto refused = plan(*products.checked, *products.program, {"ordr", "scalar"});
  REQUIRE_FALSE(refused);
  REQUIRE(refused.diagnostics.size() == 1);
  CHECK(refused.diagnostics.front().message == "unknown dimension `ordr`");
  CHECK(refused.diagnostics.front().hint == "did you mean `order`?");
}

TEST_CASE("designs that differ in the scalar, in packs or in their sines are derived alike") {
  const Design design{.scalar = ScalarKind::single_precision,
                      .in_packs = true,
                      .trigonometry = "1e-7",
                      .is_fixed = true,
                      .order = "3"};
  const Design derivation = derivation_of(design);
  CHECK(derivation.scalar == ScalarKind::double_precision);
  CHECK_FALSE(derivation.in_packs);
  CHECK(derivation.trigonometry.empty());
  CHECK(derivation.is_fixed);
  CHECK(derivation.order == "3");
}
