// The worst deviation and the secular one, of numbers that are known.
#include "simulate/drift_meter.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("the worst magnitude, and the mean of the last tenth less that of the first") {
  DriftMeter meter;
  for (int i = 0; i <= 100; ++i) meter.add(i / 100.0, 1, -i, 50 + i);
  const Drift drift = meter.drift("E", "size");
  CHECK(drift.name == "E");
  CHECK(drift.measure == "size");
  CHECK(drift.scale == 150);
  CHECK(drift.worst == Approx(100.0 / 150));
  CHECK(drift.secular == Approx((-95.0 + 5) / 150));
}

TEST_CASE("long steps count for the time they take") {
  DriftMeter meter;
  meter.add(0, 0, 7, 1);
  meter.add(0.01, 3, 1, 1);
  meter.add(0.05, 1, 5, 1);
  meter.add(1, 2, 4, 1);
  CHECK(meter.drift("", "").secular == 4 - 2);
}

TEST_CASE("of nothing but zeros the drift is absolute") {
  DriftMeter meter;
  meter.add(0, 0, 0, 0);
  meter.add(1, 1, 0, 0);
  CHECK(meter.drift("", "").scale == 1);
  CHECK(meter.drift("", "").worst == 0);
}
