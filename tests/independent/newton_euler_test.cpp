// Tests the values and the cost of the handwritten Newton-Euler recursion of the Panda, which is
// the baseline of the benchmarks.
#include <algorithm>
#include <catch2/catch.hpp>

#include "bench/panda_by_hand.hpp"
#include "independent/agreement.hpp"
#include "support/counted.hpp"

namespace elgen::test {

namespace {

const std::filesystem::path description =
    std::filesystem::path(ELGEN_SOURCE_DIR) / "tests/reference/panda7.json";

std::array<double, 7> array(const std::vector<double>& numbers) {
  std::array<double, 7> result{};
  std::copy_n(numbers.begin(), 7, result.begin());
  return result;
}

}  // namespace

TEST_CASE("handwritten Newton-Euler gives the reference values") {
  const Robot robot = read_robot(description);
  REQUIRE(robot.reference);
  const State& state = robot.reference->state;
  const std::array<double, 7> torque = bench::inverse_dynamics(
      bench::panda_of(robot), array(state.q), array(state.v), array(state.a));
  CHECK(relative_difference({torque.begin(), torque.end()}, robot.reference->torque) < 1e-11);
}

TEST_CASE("handwritten Newton-Euler costs 378 additions and 383 multiplications") {
  compiled::counts = {};
  const std::array<compiled::Counted, 7> some{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7};
  (void)bench::inverse_dynamics(bench::Panda<compiled::Counted>{}, some, some, some);
  CHECK(compiled::counts.add == 378);
  CHECK(compiled::counts.mul == 383);
}

}  // namespace elgen::test
