// Sampled states: deterministic, inside the ranges, and with extremes.
#include "sample/states.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <tuple>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

template <class Scalar>
std::size_t count(const std::vector<SampledState<Scalar>>& states, Region region) {
  return static_cast<std::size_t>(std::count_if(
      states.begin(), states.end(), [region](const auto& s) { return s.region == region; }));
}

template <class Scalar>
const SampledState<Scalar>& named(const std::vector<SampledState<Scalar>>& states,
                                  const std::string& name) {
  const auto found =
      std::find_if(states.begin(), states.end(), [&](const auto& s) { return s.name == name; });
  REQUIRE(found != states.end());
  return *found;
}

}  // namespace

TEST_CASE("half of the states are nominal, a quarter small, a quarter large") {
  const System system = cart_pole_system();
  const auto states = sample_states<double>(system.subject(), {64, 1, false});
  CHECK(states.size() == 64);
  CHECK(count(states, Region::nominal) == 32);
  CHECK(count(states, Region::small) == 16);
  CHECK(count(states, Region::large) == 16);
}

TEST_CASE("a seed determines the states") {
  const System system = cart_pole_system();
  const auto first = sample_states<double>(system.subject(), {8, 5, true});
  const auto again = sample_states<double>(system.subject(), {8, 5, true});
  const auto other = sample_states<double>(system.subject(), {8, 6, true});
  REQUIRE(first.size() == again.size());
  for (std::size_t i = 0; i < first.size(); ++i) CHECK(first[i].values.q == again[i].values.q);
  CHECK(first[0].values.q != other[0].values.q);
}

TEST_CASE("states are finite, however large a range is") {
  System system = cart_pole_system();
  const cln::cl_R far = cln::expt(cln::cl_RA(10), 400);
  system.model.coordinates[0].range = Interval{-far, far};
  system.model.velocities[0].rate_range = Interval{0, far};
  system.model.inputs[0].limits = Interval{far / 10, far};
  const auto all_finite = [](const auto& states) {
    return std::all_of(states.begin(), states.end(), [](const auto& state) {
      const auto& [q, v, u] = std::tie(state.values.q, state.values.v, state.values.u);
      const auto finite = [](auto x) { return std::isfinite(x); };
      return std::all_of(q.begin(), q.end(), finite) && std::all_of(v.begin(), v.end(), finite) &&
             std::all_of(u.begin(), u.end(), finite);
    });
  };
  CHECK(all_finite(sample_states<double>(system.subject(), {32, 1, true})));
  CHECK(all_finite(sample_states<float>(system.subject(), {32, 1, true})));
}

TEST_CASE("the step size is drawn if a function takes it") {
  System system = cart_pole_system();
  for (const auto& state : sample_states<double>(system.subject(), {16, 1, true})) {
    if (state.region != Region::extreme) CHECK(state.values.h == 0);
  }
  system.program.leaves.h = "h";
  for (const auto& state : sample_states<double>(system.subject(), {16, 1, false})) {
    CHECK(state.values.h != 0);
    if (state.region == Region::nominal) CHECK((state.values.h > 0 && state.values.h <= 0.1));
  }
}

TEST_CASE("momenta are drawn if a function takes them") {
  System system = cart_pole_system();
  for (const auto& state : sample_states<double>(system.subject(), {16, 1, true})) {
    if (state.region != Region::extreme) CHECK(state.values.momenta == std::vector<double>(2));
  }
  system.program.leaves.momenta = system.program.leaves.v;
  for (const auto& state : sample_states<double>(system.subject(), {16, 1, false})) {
    for (const double p : state.values.momenta) {
      CHECK(p != 0);
      if (state.region == Region::nominal) CHECK(std::abs(p) <= 10);
    }
  }
}

TEST_CASE("nominal states are in the declared ranges, or in default ranges") {
  System system = cart_pole_system();
  system.model.coordinates[0].range = Interval{cln::cl_R(2), cln::cl_R(3)};
  system.model.inputs[0].limits = Interval{cln::cl_R(-1), cln::cl_R(0)};
  double widest_angle = 0;
  for (const auto& state : sample_states<double>(system.subject(), {200, 1, false})) {
    if (state.region != Region::nominal) continue;
    REQUIRE((state.values.q[0] >= 2 && state.values.q[0] < 3));
    REQUIRE(std::abs(state.values.q[1]) <= 3.1416);
    REQUIRE((state.values.u[0] >= -1 && state.values.u[0] < 0));
    REQUIRE(std::abs(state.values.v[0]) <= 10);
    REQUIRE(state.values.parameters[1] == 0.1);
    widest_angle = std::fmax(widest_angle, std::abs(state.values.q[1]));
  }
  CHECK(widest_angle > 3);
}

TEST_CASE("parameters keep their values at nominal states, whatever their range") {
  System system = cart_pole_system();
  const double value = cln::double_approx(system.model.parameters[1].value);
  system.model.parameter_arrays[1].range = Interval{cln::cl_R(2), cln::cl_R(3)};
  for (const auto& state : sample_states<double>(system.subject(), {16, 1, false})) {
    CHECK(state.values.parameters[1] == value);
  }
}

TEST_CASE("small and large states have the promised magnitudes") {
  const System system = cart_pole_system();
  for (const auto& state : sample_states<double>(system.subject(), {100, 1, false})) {
    const double v = std::abs(state.values.v[1]);
    if (state.region == Region::small) REQUIRE((v > 0.9e-12 && v < 1e-3));
    if (state.region == Region::large) REQUIRE((v > 0.7e-8 && v < 1.4e8));
  }
}

TEST_CASE("each extreme state is extreme in one quantity") {
  System system = cart_pole_system();
  system.model.coordinates[0].range = Interval{cln::cl_R(-2), cln::cl_R(3)};
  const auto states = sample_states<double>(system.subject(), {0, 1, true});
  CHECK(named(states, "origin").values.q == std::vector<double>{0, 0});
  CHECK(named(states, "low ends of ranges").values.q[0] == -2);
  CHECK(named(states, "high ends of ranges").values.v[0] == 10);
  CHECK(std::abs(named(states, "angles 1e+15").values.q[1]) == 1e15);
  CHECK(std::abs(named(states, "angles 1e+15").values.q[0]) <= 3);
  CHECK(std::abs(named(states, "rates 1e+300").values.v[0]) == 1e300);
  const auto& ratios = named(states, "parameter ratios 1e+12").values.parameters;
  CHECK(ratios[0] == 1e12);
  CHECK(ratios[1] == 0.1);
  const double distance = named(states, "angles 1e-15 from 1.57").values.q[1] - 1.5707963267948966;
  CHECK((distance != 0 && std::abs(distance) < 1e-14));
}

TEST_CASE("extremes of float fit float") {
  const System system = cart_pole_system();
  const auto states = sample_states<float>(system.subject(), {0, 1, true});
  for (const auto& state : states) {
    for (const float v : state.values.v) REQUIRE(std::isfinite(v));
  }
  const float denormal = std::numeric_limits<float>::denorm_min();
  const bool reached = std::any_of(states.begin(), states.end(), [&](const auto& s) {
    return std::abs(s.values.q[1]) == denormal;
  });
  CHECK(reached);
}

TEST_CASE("where sums of angles cancel, each parameter is far from its value") {
  const System system = cart_pole_system();
  const auto states = sample_states<double>(system.subject(), {128, 1, true});
  const auto& tiny = named(states, "l times 1e+12, angles tiny");
  CHECK((std::abs(tiny.values.q[1]) >= 5e-9 && std::abs(tiny.values.q[1]) < 1e-8));
  CHECK(tiny.values.parameters[2] / named(states, "origin").values.parameters[2] == Approx(1e12));
  CHECK(tiny.values.parameters[1] == named(states, "origin").values.parameters[1]);
  const double right = named(states, "M times 1e-06, angles near right ones").values.q[1];
  const double turns = std::round(right / 1.5707963267948966);
  CHECK(std::fmod(std::abs(turns), 2) == 1);
  CHECK(std::abs(right - turns * 1.5707963267948966) == Approx(7.5e-9).margin(2.6e-9));
  const auto is_combined = [](const auto& s) { return s.name.find(", angles") != s.name.npos; };
  CHECK(std::count_if(states.begin(), states.end(), is_combined) == 5 * 6 * 4);
  const auto few = sample_states<double>(system.subject(), {16, 1, true});
  CHECK(std::count_if(few.begin(), few.end(), is_combined) == 16);
}

TEST_CASE("a sequence gives the same states as sample_states") {
  const System system = cart_pole_system();
  const SamplingOptions sampling{32, 3, true};
  const auto states = sample_states<float>(system.subject(), sampling);
  StateSequence<float> sequence(system.subject(), sampling);
  for (const auto& expected : states) {
    const auto state = sequence.next();
    REQUIRE(state);
    CHECK(state->name == expected.name);
    CHECK(state->values.q == expected.values.q);
    CHECK(state->values.parameters == expected.values.parameters);
  }
  CHECK_FALSE(sequence.next());
}

TEST_CASE("quaternions are normalised in every scalar type, and zero becomes the identity") {
  Model model;
  model.rotations.resize(2);
  model.rotations[1].first_coordinate = 4;
  Arguments<double> rounded;
  rounded.q = {1, 1, 1, 1, 0, 0, 0, 0};
  Arguments<Real> exact = map_leaves([](double x) { return Real(exact_value(x)); }, rounded);
  normalize_quaternions(model, rounded);
  normalize_quaternions(model, exact);
  CHECK(rounded.q == std::vector<double>{0.5, 0.5, 0.5, 0.5, 1, 0, 0, 0});
  for (std::size_t i = 0; i < exact.q.size(); ++i) {
    CHECK(is_near(exact.q[i], Real(exact_value(rounded.q[i]))));
  }
}
