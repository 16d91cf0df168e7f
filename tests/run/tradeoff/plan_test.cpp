// Plans: the designs to compare.
#include <algorithm>
#include <catch2/catch.hpp>

#include "run/tradeoff/derived.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using Texts = std::vector<std::string>;

TradeoffPlan planned(const std::string& text, const std::string& output,
                     const DesignChoices& choices = {}) {
  const Products products = derived(text, output);
  const Result<TradeoffPlan> result = plan_designs(*products.checked, *products.program, choices);
  REQUIRE(result);
  return *result;
}

/// True if the plan has a design with these values, in the chosen form.
bool has(const TradeoffPlan& plan, Texts values) {
  values.emplace_back("chosen");
  return std::ranges::find(plan.designs, values, &PlannedDesign::values) != plan.designs.end();
}

/// The refusal as "message; hint".
std::string refusal(const std::string& text, const DesignChoices& choices) {
  const Products products = derived(text, "momentum");
  const auto refused = plan_designs(*products.checked, *products.program, choices);
  if (refused || refused.diagnostics.size() != 1) return "";
  return refused.diagnostics.front().message + "; " + refused.diagnostics.front().hint;
}

/// One mass on an axis; its momentum has no sine.
const std::string mass = model_text("mass", R"toml([[coordinate]]
name = "x"
[parameters]
m = 1e-60
[energy]
T = "m*dot(x)^2"
)toml");

}  // namespace

TEST_CASE("designs differ in scalar, batch and parameters") {
  const TradeoffPlan plan = planned(read_model("pushed_pendulum"), "inverse_dynamics");
  CHECK(plan.dimensions == Texts{"scalar", "batch", "parameters", "form"});
  CHECK(plan.designs.size() == 8 + 1);
  CHECK(has(plan, {"float", "packs", "arguments"}));
}

TEST_CASE("polynomials of 1e-7 are planned on request, only for packs of double") {
  const TradeoffPlan plan =
      planned(read_model("pushed_pendulum"), "inverse_dynamics", {.more = {"trigonometry"}});
  CHECK(plan.dimensions == Texts{"scalar", "batch", "trigonometry", "parameters", "form"});
  CHECK(plan.designs.size() == 8 + 2 + 2 + 4 + 1);
  CHECK(has(plan, {"double", "packs", "1e-7", "fixed"}));
  CHECK(has(plan, {"float", "packs", "full", "arguments"}));
  CHECK_FALSE(has(plan, {"float", "packs", "1e-7", "fixed"}));
  CHECK_FALSE(has(plan, {"double", "one", "1e-7", "fixed"}));
}

TEST_CASE("dimensions without a choice are omitted") {
  const TradeoffPlan plan = planned(mass, "momentum");
  CHECK(plan.dimensions == Texts{"batch", "parameters", "form"});
  CHECK(plan.designs.size() == 5);
}

TEST_CASE("a requested dimension multiplies the designs") {
  const TradeoffPlan plan = planned(read_model("pushed_pendulum"), "gravity", {.more = {"order"}});
  CHECK(plan.dimensions == Texts{"scalar", "batch", "parameters", "order", "form"});
  CHECK(plan.designs.size() == 8 * 3 + 1);
  CHECK(has(plan, {"float", "one", "fixed", "3"}));
}

TEST_CASE("wider scalars are planned on request, for single states in double") {
  const TradeoffPlan plan = planned(read_model("pushed_pendulum"), "gravity", {.more = {"inner"}});
  CHECK(plan.dimensions == Texts{"scalar", "batch", "parameters", "inner", "form"});
  CHECK(plan.designs.size() == 8 + 4 + 1);
  CHECK(has(plan, {"double", "one", "arguments", "double-double"}));
  CHECK(has(plan, {"double", "one", "fixed", "long double"}));
  CHECK_FALSE(has(plan, {"float", "one", "fixed", "double-double"}));
  CHECK_FALSE(has(plan, {"double", "packs", "fixed", "long double"}));
  CHECK(refusal(mass, {.pinned = {{"batch", "packs"}, {"inner", "long double"}}}) ==
        "no design fits `--batch packs`, `--inner long double`; a wider scalar needs functions of "
        "one state in double");
}

TEST_CASE("library calls are planned on request, for single states") {
  const TradeoffPlan plan =
      planned(read_model("pushed_pendulum"), "gravity", {.more = {"trigonometry"}});
  CHECK(plan.designs.size() == 8 + 2 + 2 + 4 + 1);
  CHECK(has(plan, {"double", "one", "4e-16", "arguments"}));
  CHECK_FALSE(has(plan, {"double", "packs", "4e-16", "arguments"}));
  CHECK_FALSE(has(plan, {"double", "one", "1e-7", "arguments"}));
  CHECK(has(plan, {"double", "one", "library", "arguments"}));
  CHECK(has(plan, {"float", "one", "library", "fixed"}));
  CHECK_FALSE(has(plan, {"double", "packs", "library", "fixed"}));
  const TradeoffPlan pinned =
      planned(read_model("pushed_pendulum"), "gravity", {.pinned = {{"trigonometry", "library"}}});
  CHECK(pinned.dimensions == Texts{"scalar", "trigonometry", "parameters", "form"});
  CHECK(pinned.designs.size() == 5);
  const TradeoffPlan wide =
      planned(read_model("pushed_pendulum"), "gravity", {.more = {"trigonometry", "inner"}});
  CHECK_FALSE(has(wide, {"double", "one", "library", "fixed", "long double"}));
  CHECK(refusal(mass, {.pinned = {{"trigonometry", "library"}}}) ==
        "no design fits `--trigonometry library`; the output has no sine and no cosine");
}

TEST_CASE("a pinned dimension has one value, and keeps its column") {
  const TradeoffPlan plan = planned(read_model("pushed_pendulum"), "gravity",
                                    {.pinned = {{"batch", "one"}, {"order", "3"}}});
  CHECK(plan.dimensions == Texts{"scalar", "batch", "parameters", "order", "form"});
  CHECK(plan.designs.size() == 5);
  CHECK(has(plan, {"float", "one", "fixed", "3"}));
}

TEST_CASE("the first design is also planned as typed, every design if `form` is named") {
  const std::string text = read_model("pushed_pendulum");
  const auto typed_designs = [&text](const DesignChoices& choices) {
    std::vector<Texts> typed;
    const TradeoffPlan plan = planned(text, "gravity", choices);
    for (const PlannedDesign& design : plan.designs) {
      CHECK(design.design.is_typed == (design.values.back() == "typed"));
      if (design.design.is_typed) typed.push_back(design.values);
    }
    return typed;
  };
  CHECK(typed_designs({}) == std::vector<Texts>{{"double", "one", "arguments", "typed"}});
  CHECK(typed_designs({.pinned = {{"scalar", "float"}, {"batch", "packs"}}}) ==
        std::vector<Texts>{{"float", "packs", "arguments", "typed"}});
  CHECK(typed_designs({.more = {"form"}}).size() == 8);
  CHECK(typed_designs({.pinned = {{"form", "typed"}}}).size() == 8);
  CHECK(typed_designs({.pinned = {{"form", "chosen"}}}).empty());
}

TEST_CASE("E645: no design has all pinned values") {
  CHECK(refusal(mass, {.pinned = {{"scalar", "float"}}}) ==
        "no design fits `--scalar float`; a number of the output does not fit float");
  CHECK(refusal(mass, {.pinned = {{"batch", "packs"}, {"trigonometry", "1e-7"}}}) ==
        "no design fits `--batch packs`, `--trigonometry 1e-7`; the output has no sine and no "
        "cosine");
}

TEST_CASE("no parameter is fixed in designs whose parameters vary") {
  const Products products = derived(read_model("pushed_pendulum"), "gravity", {}, {},
                                    {make_source("command line", "m=1:2")});
  const auto plan = plan_designs(*products.checked, *products.program, {});
  REQUIRE(plan);
  CHECK(plan->dimensions == Texts{"scalar", "batch", "form"});
  CHECK(plan->designs.size() == 4 + 1);
  const auto refused =
      plan_designs(*products.checked, *products.program, {.pinned = {{"parameters", "fixed"}}});
  REQUIRE_FALSE(refused);
  CHECK(refused.diagnostics.front().message == "no design fits `--parameters fixed`");
  CHECK(refused.diagnostics.front().hint == "`--over` varies parameters");
}

TEST_CASE("E631: an unknown dimension") {
  CHECK(refusal(mass, {.more = {"ordr", "scalar"}}) ==
        "unknown dimension `ordr`; did you mean `order`?");
}

TEST_CASE("designs that differ only in scalar, packs or sines share a derivation") {
  const Design design{.scalar = ScalarKind::single_precision,
                      .in_packs = true,
                      .trigonometry = "1e-7",
                      .is_fixed = true,
                      .is_typed = true,
                      .order = "3"};
  const Design derivation = derivation_key(design);
  CHECK(derivation.scalar == ScalarKind::double_precision);
  CHECK_FALSE(derivation.in_packs);
  CHECK(derivation.trigonometry.empty());
  CHECK(derivation.is_fixed);
  CHECK(derivation.is_typed);
  CHECK(derivation.order == "3");
}
