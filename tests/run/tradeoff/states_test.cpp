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

TEST_CASE("varied parameters are drawn for 16 states each, a quarter of them at each end") {
  const Products products =
      derived(read_model("pushed_pendulum"), "gravity", {}, {},
              {make_source("command line", "m=0.01:100"), make_source("command line", "k=-1..1")});
  const auto states =
      sample_tradeoff_states(*products.checked, *products.program, {.count = 16 * 400});
  REQUIRE(states);
  const auto value = [&states](const std::string& name, std::size_t draw) {
    const std::size_t parameter = name == "m" ? 0 : 3;
    return states->states[states_of_draw * draw].parameters[parameter];
  };
  const auto share = [&value](const std::string& name, double low, double high) {
    double count = 0;
    for (std::size_t draw = 0; draw < 400; ++draw) {
      const double x = value(name, draw);
      if (low <= x && x <= high) ++count;
    }
    return count / 400;
  };
  // Four standard deviations of a share of 1/4 in 400 draws are 0.087.
  CHECK(share("m", 0.01, 0.01 * (1 + 1e-12)) == Approx(0.25).margin(0.09));
  CHECK(share("m", 100 * (1 - 1e-12), 100) == Approx(0.25).margin(0.09));
  CHECK(share("m", 0.011, 1) == Approx(0.25).margin(0.09));
  CHECK(share("k", -1, -1) == Approx(0.25).margin(0.09));
  CHECK(share("k", -0.999, 0) == Approx(0.25).margin(0.09));
  CHECK(share("m", 0.01, 100) == 1);
  for (std::size_t i = 0; i < 160; ++i) {
    const Arguments<double>& state = states->states[i];
    CHECK(state.parameters == states->states[i - i % states_of_draw].parameters);
    const double m = state.parameters[0];
    // Parameters without a range are exact: l is sqrt(2) to more digits than double.
    const long double expected = static_cast<long double>(m) * 9.81L * std::sqrt(2.0L) *
                                 std::sin(static_cast<long double>(state.q[0]));
    const auto& [high, low] = states->exact[i].front();
    CHECK(std::abs(static_cast<long double>(high) + static_cast<long double>(low) - expected) <=
          1e-17L * static_cast<long double>(m));
  }
}

TEST_CASE("the range of an array is the range of each of its elements") {
  const Products products = derived(model_text("springs", R"toml([[coordinate]]
name = "x"
[parameters]
c = { size = "2", value = 1 }
[energy]
T = "1/2*dot(x)^2"
V = "1/2*c[1]*x^2 + 1/4*c[2]*x^4"
)toml"),
                                    "gravity", {}, {}, {make_source("command line", "c=2:3")});
  const auto states =
      sample_tradeoff_states(*products.checked, *products.program, {.count = 16 * 20});
  REQUIRE(states);
  bool differ = false;
  for (const Arguments<double>& state : states->states) {
    REQUIRE(state.parameters.size() == 2);
    for (const double c : state.parameters) CHECK((c >= 2 && c <= 3));
    differ = differ || state.parameters[0] != state.parameters[1];
  }
  CHECK(differ);
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
