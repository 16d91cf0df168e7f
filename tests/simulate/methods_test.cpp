// The table of methods, and the orders that its rows have.
#include "simulate/steps/methods.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "simulate/compiled_model.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("every method has the order that it is known for") {
  const std::map<std::string_view, double> orders{
      {"rk4", 4}, {"dopri5", 5}, {"verlet", 2}, {"midpoint", 2}};
  REQUIRE(orders.size() == method_table().size());
  const CompiledSystem pendulum(pendulum_text());
  for (const MethodRow& method : method_table()) {
    INFO(method.name);
    const auto error = [&](double step) {
      const auto last =
          pendulum.trajectory(steps_of(std::string(method.name), step, pendulum_period)).last;
      return std::hypot(last[1] - 1, last[2]);
    };
    // Steps for which neither rounding nor the next order is felt.
    const double length = pendulum_period / 100;
    const double order = std::log2(error(length) / error(length / 2));
    CHECK(order > orders.at(method.name) - 0.3);
    CHECK(order < orders.at(method.name) + 1.3);
  }
}

TEST_CASE("a reference is by none of them") {
  for (const MethodRow& method : method_table()) CHECK(method.name != reference_method().name);
  CHECK(reference_method().step == StepKind::adapted);
}
