// The adaptive controller of the arm as its user builds it: how far it is off at first and at last,
// and what it has learnt.
#include <catch2/catch.hpp>

#include "consumer/projects.hpp"

namespace elgen::test {

TEST_CASE("the arm of the example learns its masses and inertias", "[.all]") {
  const Example adapt("adapt");
  const Outcome run = adapt.run("build/adapt");
  INFO(run.output << run.errors);
  CHECK(run.status == 0);
  const double first = number_after(run.output, "off by at most ");
  const double last = number_after(run.output, "first 5 s, by ");
  CHECK(last <= 1e-3);
  CHECK(first > 10 * last);  // it knows half of what it carries
  CHECK(number_after(run.output, "within ") <= 2);
  CHECK(is_shown(run.output));
}

}  // namespace elgen::test
