// The controller of the arm, built as a user would: the tracking error of the joints on a circle.
#include <catch2/catch.hpp>

#include "consumer/projects.hpp"

namespace elgen::test {

TEST_CASE("the arm of the example follows its circle with correct and with wrong masses",
          "[.all]") {
  const Example track("track");
  const Outcome run = track.run("build/track");
  INFO(run.output << run.errors);
  CHECK(run.status == 0);
  const double right = number_after(run.output, "off by at most ");
  const double wrong = number_after(run.output, "and by ");
  CHECK(right <= 1e-4);
  CHECK(wrong <= 1e-2);
  CHECK(wrong > 10 * right);  // the controller assumes the lighter link
  CHECK(is_in_readme(run.output));
}

}  // namespace elgen::test
