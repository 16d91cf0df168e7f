// The controller of the arm as its user builds it: how far from its circle it lets the joints go.
#include <catch2/catch.hpp>

#include "consumer/projects.hpp"

namespace elgen::test {

TEST_CASE("the arm of the example stays on its circle, with the right masses and with wrong ones",
          "[.all]") {
  const Example track("track");
  const Outcome run = track.run("build/track");
  INFO(run.output << run.errors);
  CHECK(run.status == 0);
  const double right = number_after(run.output, "off by at most ");
  const double wrong = number_after(run.output, "and by ");
  CHECK(right <= 1e-4);
  CHECK(wrong <= 1e-2);
  CHECK(wrong > 10 * right);  // the controller knows nothing of the heavier link
  CHECK(is_shown(run.output));
}

}  // namespace elgen::test
