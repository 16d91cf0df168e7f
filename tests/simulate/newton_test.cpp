// Systems of equations whose solutions are known.
#include "simulate/steps/newton.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace elgen;

TEST_CASE("two equations are solved to rounding, again from nearby with the same Jacobian") {
  Newton newton;
  double a = 2;
  int calls = 0;
  const auto residual = [&](const Numbers& x, Numbers& r) {
    ++calls;
    r = {x[0] * x[0] + x[1] - a, x[1] - std::sin(x[0])};
    return std::abs(a) + 1;
  };
  Numbers x{1, 1};
  REQUIRE(newton.solve(x, residual));
  CHECK(std::abs(x[0] * x[0] + std::sin(x[0]) - 2) < 1e-15);
  const int first = calls;
  a = 2.001;
  REQUIRE(newton.solve(x, residual));
  CHECK(std::abs(x[0] * x[0] + std::sin(x[0]) - 2.001) < 1e-15);
  CHECK(calls - first < first);
}

TEST_CASE("a Jacobian that no longer serves is made anew") {
  Newton newton;
  double slope = 1;
  const auto residual = [&](const Numbers& x, Numbers& r) {
    r = {slope * x[0] - 3};
    return 3 + std::abs(slope * x[0]);
  };
  Numbers x{0};
  REQUIRE(newton.solve(x, residual));
  CHECK(x[0] == 3);
  slope = -5;
  REQUIRE(newton.solve(x, residual));
  CHECK(x[0] == Approx(-0.6));
}

TEST_CASE("what has no solution, or no value, is not solved") {
  Newton newton;
  const auto none = [](const Numbers& x, Numbers& r) {
    r = {x[0] * x[0] + 1};
    return x[0] * x[0] + 1;
  };
  Numbers x{0.7};
  CHECK_FALSE(newton.solve(x, none));
  const auto undefined = [](const Numbers&, Numbers& r) {
    r = {NAN};
    return 1.0;
  };
  x = {1};
  CHECK_FALSE(newton.solve(x, undefined));
}
