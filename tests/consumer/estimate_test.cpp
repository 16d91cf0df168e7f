// The Kalman filter of the arm, built as a user would: the error of the estimated angle, which has
// no sensor.
#include <catch2/catch.hpp>

#include "consumer/projects.hpp"

namespace elgen::test {

TEST_CASE("the filter of the example estimates the angle that has no sensor", "[.all]") {
  const Example estimate("estimate");
  const Outcome run = estimate.run("build/estimate");
  INFO(run.output << run.errors);
  CHECK(run.status == 0);
  CHECK(number_after(run.output, "off by ") > 0.5);
  CHECK(number_after(run.output, "by at most ") <= 5e-3);
  CHECK(is_in_readme(run.output));
}

}  // namespace elgen::test
