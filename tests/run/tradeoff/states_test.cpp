// States of a trade-off, and exact values at these states.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "run/tradeoff/derived.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Result<TradeoffStates> states_in(const std::string& ranges, std::size_t count = 50) {
  const Products products = derived(read_model("pushed_pendulum"), "inverse_dynamics", {},
                                    {make_source("command line", ranges)});
  return sample_tradeoff_states(*products.checked, *products.program, {.count = count});
}

}  // namespace

TEST_CASE("states are inside the ranges, and exact values have more digits than double") {
  const Result<TradeoffStates> states = states_in("q=-0.1..0.1,dot(dot(q))=1..1,t=0..0");
  REQUIRE(states);
  CHECK(states->field_sizes == std::vector<std::size_t>{1});
  REQUIRE(states->states.size() == 50);
  bool differ = false;
  for (std::size_t i = 0; i < 50; ++i) {
    const double q = states->states[i].q[0];
    CHECK(std::abs(q) <= 0.1);
    CHECK(states->states[i].a[0] == 1);
    differ = differ || q != states->states[0].q[0];
    const long double expected =
        4 + 19.62L * std::sqrt(2.0L) * std::sin(static_cast<long double>(q));
    const auto& [high, low] = states->exact[i].front();
    CHECK(std::abs(static_cast<long double>(high) + static_cast<long double>(low) - expected) <
          1e-17L);
    CHECK(std::abs(low) <= 1e-15);
    CHECK(low != 0);
  }
  CHECK(differ);
}

TEST_CASE("the scene's ranges narrow the model's, and given ranges narrow the scene's") {
  const Products products = derived(read_model("pushed_pendulum"), "inverse_dynamics",
                                    "[numeric]\nranges = { q = [-0.2, 0.1], t = [2, 2] }\n",
                                    {make_source("command line", "q=-0.1..0.3")});
  const auto states = sample_tradeoff_states(*products.checked, *products.program, {.count = 5});
  REQUIRE(states);
  CHECK(states->low.q == std::vector<double>{-0.1});
  CHECK(states->high.q == std::vector<double>{0.3});
  CHECK(states->states[4].t == 2);
}

TEST_CASE("E521: an output without a value at most states") {
  const Products products = derived(model_text("root", R"toml([[coordinate]]
name = "x"
range = [-1, 1]
[energy]
T = "dot(x)^2"
V = "sqrt(x - 9/10)"
)toml"),
                                    "potential_energy");
  const auto states = sample_tradeoff_states(*products.checked, *products.program, {.count = 50});
  REQUIRE_FALSE(states);
  CHECK(states.diagnostics.front().code == Code::E521);
}
