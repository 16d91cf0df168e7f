#include "inspect/samples.hpp"

#include <catch2/catch.hpp>

#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("samples are the same every time, differ by seed, and lie inside the ranges") {
  ModelBuilder b = cart_pole();
  b.model.coordinates[0].range = Interval{3, 4};
  const Inspected subject{b.model, {}};
  CHECK(sampled_state(subject, 5).q == sampled_state(subject, 5).q);
  CHECK(sampled_state(subject, 5).q != sampled_state(subject, 6).q);
  for (unsigned seed = 0; seed < 20; ++seed) {
    const State state = sampled_state(subject, seed);
    CHECK((state.q[0] > 3 && state.q[0] <= 4));
  }
}

TEST_CASE("a run-time parameter of value 0 is sampled, a fixed one is not") {
  ModelBuilder b;
  b.coordinate("x").parameter("m", "0").T("m*x_d^2/2");
  CHECK(sampled_state({b.model, {}}, 1).parameters[0] > 0);
  Scene scene;
  scene.specialisation.fixed[0] = {0};
  CHECK(sampled_state({b.model, scene}, 1).parameters[0] == 0);
}

TEST_CASE("a mass matrix is sampled where it has a value") {
  ModelBuilder b;
  b.coordinate("x").T("sqrt(x)*x_d^2/2");
  const auto sample = sampled_mass_matrix({b.model, {}}, 3);
  REQUIRE(sample);
  CHECK(sample->state.q[0] > 0);
  ModelBuilder nowhere;
  nowhere.coordinate("x").T("sqrt(-1 - x^2)*x_d^2/2");
  CHECK_FALSE(sampled_mass_matrix({nowhere.model, {}}, 3));
}
