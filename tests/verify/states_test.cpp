// States: the sides of kinks on which they lie, their distance to zeros of typed sums, and the
// state with the worst figure.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "verify/states/kinks.hpp"
#include "verify/states/near_zeros.hpp"
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

/// A system in x, y and z with this V.
System ranged(const std::string& V, const Interval& range = {-3, 4}) {
  ModelBuilder builder;
  builder.coordinate("x").coordinate("y").coordinate("z").T("(x_d^2 + y_d^2 + z_d^2)/2").V(V);
  for (Coordinate& coordinate : builder.model.coordinates) coordinate.range = range;
  return system_of(builder.model, "");
}

/// The states at which |V| is at most `most`.
template <class Scalar = double>
std::vector<SampledState<Scalar>> states_below(const System& system, double most) {
  auto states = states_near_zeros<Scalar>(system.subject(), {16, 1, true});
  std::erase_if(states, [&](const SampledState<Scalar>& state) {
    const auto value = oracle_expression_value(system.model, *system.model.energies.V,
                                               exact_state(system.subject(), state.values));
    return !value || std::abs(to_double(*value)) > most;
  });
  return states;
}

bool is_at_rest(const SampledState<double>& state) {
  return std::ranges::all_of(state.values.v, [](double v) { return v == 0; });
}

}  // namespace

TEST_CASE("typed sums vanish together at states with and without motion") {
  for (const std::string V :
       {"(x - 1)^2 + (y - 0.3)^2", "(x - y)^2 + (y - z)^2", "1 - cos(x - 2*y)", "x*y - 1 + z/2",
        "2.25 + 2.25 - 2*1.5*1.5*cos(z)",
        "4.5*(sqrt((x - 0.5)^2 + y^2) - 0.3)^2 + 2*(1 - cos(y)) + 2*(cosh(x - 0.8) - 1)"}) {
    INFO(V);
    const System system = ranged(V);
    CHECK(states_below(system, 1e-3).size() >= 2);
    const auto nearest = states_below(system, 1e-11);
    CHECK(nearest.size() >= 2);
    CHECK(std::ranges::any_of(nearest, is_at_rest));
    CHECK_FALSE(std::ranges::all_of(nearest, is_at_rest));
    CHECK(states_below<float>(system, 1e-3).size() >= 2);
  }
}

TEST_CASE("states approach a zero of two coordinates, also along each axis") {
  const System system = ranged("sqrt((x - 1)^2 + y^2) + 2*z");
  const auto states = states_near_zeros<double>(system.subject(), {64, 1, true});
  const auto count_near = [&](bool is_on_axis) {
    return std::ranges::count_if(states, [&](const SampledState<double>& state) {
      const double x = std::abs(state.values.q[0] - 1);
      const double y = std::abs(state.values.q[1]);
      return x + y < 1e-3 && (x == 0 || y == 0) == is_on_axis;
    });
  };
  CHECK(count_near(false) >= 2);
  CHECK(count_near(true) >= 4);
}

TEST_CASE("states approach a place at which V is not 0 but all forces vanish") {
  // The potential of a mass on a spring: it rests at x = 1 + 9.81/40.
  const System system = ranged("20*(sqrt(x^2 + y^2) - 1)^2 - 9.81*x + (z - 2)^2");
  const auto states = states_near_zeros<double>(system.subject(), {16, 1, true});
  const auto is_near = [](const SampledState<double>& state) {
    const std::vector<double>& q = state.values.q;
    return std::abs(q[0] - 1.24525) < 1e-7 && std::abs(q[1]) < 1e-7 && std::abs(q[2] - 2) < 1e-7;
  };
  CHECK(std::ranges::count_if(states, is_near) >= 4);
  const auto others = states_near_zeros<double>(system.subject(), {16, 2, true});
  CHECK(std::ranges::count_if(others, is_near) >= 4);
  CHECK(states.front().values.q != others.front().values.q);
}

TEST_CASE("a constrained model is approached at rest on its constraints") {
  ModelBuilder builder;
  builder.coordinate("x").coordinate("y").T("(x_d^2 + y_d^2)/2").V("9.81*y + 1 - cos(x)");
  builder.constraint("x^2 + y^2 - 1");
  const System system = system_of(builder.model, "");
  const auto states = states_near_zeros<double>(system.subject(), {16, 1, true});
  CHECK(std::ranges::count_if(states, [](const SampledState<double>& state) {
          return std::abs(state.values.q[0]) < 1e-3 && std::abs(state.values.q[1] + 1) < 1e-3;
        }) >= 6);
}

TEST_CASE("states near zeros are inside the ranges and at most as many as random ones") {
  const Interval range{exact("1/2"), 4};
  const System system = ranged("(x - 1/2)*(y - 4)*(z - 2)", range);
  const auto states = states_near_zeros<double>(system.subject(), {8, 1, true});
  CHECK(states.size() == 8);
  for (const SampledState<double>& state : states) {
    CHECK(state.region == Region::near_zero);
    for (const double q : state.values.q) CHECK((q >= 0.5 && q <= 4));
  }
  CHECK(states_near_zeros<double>(system.subject(), {0, 1, true}).empty());
}

TEST_CASE("a sum that does not vanish inside the ranges gives no state") {
  CHECK(states_near_zeros<double>(ranged("(x - 5)^2").subject(), {16, 1, true}).empty());
  CHECK(states_near_zeros<double>(ranged("x*y*z").subject(), {16, 1, true}).empty());
  CHECK(states_near_zeros<double>(ranged("1 + x^2 + y^4").subject(), {16, 1, true}).empty());
}

TEST_CASE("a model without kinks has no unseen ones") {
  CHECK(KinkCoverage(cart_pole().model).is_complete());
}

TEST_CASE("a kink is seen when states lie on both sides of it") {
  ModelBuilder builder = cart_pole();
  builder.force_on(0, "max(x - 2, 0) + abs(x)");
  KinkCoverage kinks(builder.model);
  CHECK(kinks.add_state(at(builder.model, "1")));
  CHECK_FALSE(kinks.add_state(at(builder.model, "3/2")));
  CHECK_FALSE(kinks.is_complete());
  CHECK(kinks.add_state(at(builder.model, "3")));
  CHECK_FALSE(kinks.one_sided_kinks_text().empty());
  CHECK(kinks.add_state(at(builder.model, "-1")));
  CHECK(kinks.is_complete());
  CHECK(kinks.one_sided_kinks_text().empty());
}

TEST_CASE("a state on the kink itself is on neither side") {
  ModelBuilder builder = cart_pole();
  builder.force_on(0, "sign(x - 2)");
  KinkCoverage kinks(builder.model);
  CHECK_FALSE(kinks.add_state(at(builder.model, "2")));
}

TEST_CASE("the worst figure keeps its state") {
  const System system = cart_pole_system();
  Tally tally;
  tally.add(1, at(system, 1));
  tally.add(3, at(system, 2));
  tally.add(2, at(system, 3));
  CHECK(tally.samples() == 3);
  CHECK(tally.worst() == 3);
  CHECK(tally.worst_state_text(system.subject()).find("q = (2, 0)") == 0);
  CHECK(tally.verdict(3) == Verdict::holds);
  CHECK(tally.verdict(2.9) == Verdict::fails);
}

TEST_CASE("NaN fails, whatever comes before or after it") {
  const System system = cart_pole_system();
  Tally tally;
  tally.add(1, at(system, 1));
  tally.add(std::nan(""), at(system, 2));
  tally.add(2, at(system, 3));
  CHECK(tally.verdict(8) == Verdict::fails);
}

TEST_CASE("a row without states is skipped and does not pass") {
  Tally tally;
  tally.count_skipped();
  CHECK(tally.verdict(8) == Verdict::skipped);
  CertificateRow row;
  tally.write_result(row, cart_pole_system().subject(), 8, SkipReason::singular);
  CHECK(row.verdict == Verdict::skipped);
  CHECK(row.skipped == std::vector<SkippedStates>{{SkipReason::singular, 1}});
}
