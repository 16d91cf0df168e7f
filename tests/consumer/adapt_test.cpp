// The adaptive controller of the arm, built as a user would: its tracking error at the start and at
// the end, and the learnt parameters.
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
  CHECK(first > 10 * last);  // initially all parameters are half their true values
  CHECK(number_after(run.output, "within ") <= 2);
  CHECK(is_in_readme(run.output));
}

}  // namespace elgen::test
