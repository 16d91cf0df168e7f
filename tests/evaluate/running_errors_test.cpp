// Running errors, rule by rule, in u.
#include "evaluate/running_errors.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "oracle/model_builder.hpp"

using namespace elgen;

namespace {

const RunningErrorRules running_rules{};

Running without_error(const char* text) { return {Real(test::exact(text)), Real()}; }
Running off(const char* text, const char* error) {
  return {Real(test::exact(text)), Real(test::exact(error))};
}
double error(const Running& x) { return ScalarTraits<double>::from_real(x.error.value()); }

}  // namespace

TEST_CASE("leaves are exact or rounded once") {
  Arguments<double> point;
  point.q = {-3};
  CHECK(error(running_leaves(point, Leaves::exact).q[0]) == 0);
  CHECK(error(running_leaves(point, Leaves::rounded).q[0]) == 3);
}

TEST_CASE("each operation rounds once, and passes errors on") {
  CHECK(error(running_rules.add(off("3", "2"), off("-1", "1"))) == 2 + 1 + 2);
  CHECK(error(running_rules.subtract(without_error("3"), without_error("5"))) == 2);
  CHECK(error(running_rules.multiply(off("3", "2"), off("5", "1"))) == 2 * 5 + 3 + 15);
  CHECK(error(running_rules.multiply(off("3", "2"), without_error("4"))) == 2 * 4);
  CHECK(error(running_rules.divide(off("6", "1"), off("3", "2"))) == Approx((1 + 2 * 2) / 3.0 + 2));
  CHECK(error(running_rules.square_root(off("9", "6"))) == Approx(1 + 3));
}

TEST_CASE("functions pass errors on by their slopes") {
  const Running x = off("0.5", "3");
  CHECK(error(running_rules.call(FunctionId::sin, x, x)) ==
        Approx(std::sin(0.5) + 3 * std::cos(0.5)));
  CHECK(error(running_rules.call(FunctionId::abs, x, x)) == 3);
  CHECK(error(running_rules.call(FunctionId::max, without_error("1"), off("2", "5"))) == 5);
}
