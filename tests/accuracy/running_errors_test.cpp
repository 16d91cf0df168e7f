// Running error analysis: the rules in Real and in double. Errors are in units of u = 2^-53.
#include "accuracy/running_errors.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "oracle/model_builder.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using Value = RunningValue<Real>;

const RunningErrorRules<Real> rules{};
const RunningErrorRules<double> rules_in_double{};

// The operators of Value apply `rules`, so that tests can write formulas.
Value operator-(const Value& x) { return rules.negate(x); }
Value operator+(const Value& x, const Value& y) { return rules.add(x, y); }
Value operator-(const Value& x, const Value& y) { return rules.subtract(x, y); }
Value operator*(const Value& x, const Value& y) { return rules.multiply(x, y); }
Value operator/(const Value& x, const Value& y) { return rules.divide(x, y); }
Value sqrt(const Value& x) { return rules.square_root(x); }
Value call(FunctionId function, const Value& x) { return rules.call(function, x, x); }

Value leaf(const char* text) { return running_leaf(exact(text), rounding_constants<double>()); }
Value value_with_error(const char* text, const char* error) {
  return {Real(exact(text)), Real(exact(error))};
}
double number(const Real& x) { return to_double(x.value()); }
double error(const Value& x) { return number(x.error); }

}  // namespace

TEST_CASE("leaves: numbers of the scalar are exact, others are rounded") {
  CHECK(error(leaf("-3/4")) == 0);
  CHECK(error(leaf("1/10")) == Approx(0.1));
  CHECK(error(leaf("16777217")) == 0);
  CHECK(number(running_leaf(cln::cl_R("16777217"), rounding_constants<float>()).error) == 16777217);
  Arguments<double> point;
  point.q = {-3};
  CHECK(error(running_leaves<Real>(point, LeafRounding::exact).q[0]) == 0);
  CHECK(error(running_leaves<Real>(point, LeafRounding::rounded).q[0]) == 3);
}

TEST_CASE("each operation rounds once, and passes errors on") {
  CHECK(error(value_with_error("3", "2") + value_with_error("-1", "1")) == 2 + 1 + 2);
  CHECK(error(leaf("3") - leaf("7")) == 4);
  CHECK(error(leaf("3") - leaf("5")) == 0);  // exact: the larger is at most twice the smaller
  CHECK(error(leaf("3") - value_with_error("5", "1")) == 1 + 2);
  CHECK(error(value_with_error("3", "2") * value_with_error("5", "1")) == 2 * 5 + 3 + 15);
  CHECK(error(value_with_error("6", "1") / value_with_error("3", "2")) ==
        Approx((1 + 2 * 2) / 3.0 + 2));
  CHECK(error(sqrt(value_with_error("9", "6"))) == Approx(1 + 3));
}

TEST_CASE(
    "a product with a literal power of two is exact, one with a computed power of two rounds") {
  CHECK(error(value_with_error("3", "2") * leaf("4")) == 2 * 4);
  CHECK(error(leaf("3") * leaf("-1/2")) == 0);
  CHECK(error(leaf("3") * value_with_error("4", "1")) == 3 + 12);
}

TEST_CASE("functions multiply errors by their slopes") {
  const Value x = value_with_error("0.5", "3");
  CHECK(error(call(FunctionId::sin, x)) == Approx(std::sin(0.5) + 3 * std::cos(0.5)));
  CHECK(error(call(FunctionId::abs, x)) == 3);
  CHECK(error(rules.call(FunctionId::max, leaf("1"), value_with_error("2", "5"))) == 5);
  CHECK(error(rules.call(FunctionId::atan2, leaf("1") + leaf("2"), leaf("4"))) ==
        Approx(std::atan2(3, 4) + 3.0 * 4 / 25));
}

TEST_CASE("a product of factors with value 0 keeps the product of their errors") {
  CHECK(error(value_with_error("0", "1024") * value_with_error("0", "4096")) ==
        Approx(0x1p-53 * 1024 * 4096));
  CHECK(rules_in_double.multiply({0, 1024}, {0, 4096}).error == Approx(0x1p-53 * 1024 * 4096));
}

TEST_CASE("sign is lost if the error exceeds the argument, and sign of an exact 0 is kept") {
  CHECK_FALSE(call(FunctionId::sign, value_with_error("1", "1000")).is_lost);
  CHECK_FALSE(call(FunctionId::sign, leaf("0")).is_lost);
  CHECK(call(FunctionId::sign, value_with_error("1", "10000000000000000")).is_lost);
  CHECK(rules_in_double.call(FunctionId::sign, {0, 1}, {0, 1}).is_lost);
}

TEST_CASE("at a stationary point of a sine the error is of second order") {
  const double a = 3e15;
  const Value angle = value_with_error("0", "3000000000000000");
  CHECK(error(call(FunctionId::cos, angle)) == Approx(1 + 0.5 * 0x1p-53 * a * a));
}

TEST_CASE("functions of one argument ignore the second argument") {
  const Value x = leaf("3/4") * leaf("3");
  const Value other = leaf("1/10") * leaf("1000");
  for (const FunctionRow& row : function_table()) {
    if (row.arity != 1 || row.id == FunctionId::asin || row.id == FunctionId::acos) continue;
    INFO(row.name);
    CHECK(error(rules.call(row.id, x, other)) == error(rules.call(row.id, x, x)));
  }
}

TEST_CASE("functions have the values in their rows of the table") {
  for (const FunctionRow& row : function_table()) {
    INFO(row.name);
    if (row.arity == 1)
      CHECK(interpreter::call<double>(row.id, row.exact_argument, 0) == row.exact_value);
    if (!row.limits_at_infinity) continue;
    CHECK(interpreter::call<double>(row.id, -1e6, 0) == row.limits_at_infinity->left);
    CHECK(interpreter::call<double>(row.id, 1e6, 0) == row.limits_at_infinity->right);
  }
}

TEST_CASE("exponentials of huge arguments take their limits") {
  const Value far = leaf("1e300");
  CHECK(number(call(FunctionId::tanh, -far).value) == -1);
  CHECK(number(call(FunctionId::exp, -far).value) == 0);
  for (const Value& infinite : {call(FunctionId::exp, far), call(FunctionId::cosh, far),
                                call(FunctionId::sinh, far), -call(FunctionId::sinh, -far)}) {
    CHECK(infinite.value > rounding_constants<double>().largest);
  }
}

TEST_CASE("a product that underflows has the error of the smallest denormal") {
  const Value tiny = leaf("1e-300") * leaf("1e-300");
  CHECK(tiny.underflows);
  CHECK(error(tiny) >= 0x1p-1074 / 0x1p-53);
  CHECK(error(tiny / leaf("1e-300")) > 1e-9);
  CHECK((tiny / leaf("1e-300")).underflows);
  CHECK_FALSE((leaf("1e-100") * leaf("1e-100")).underflows);
}

TEST_CASE(
    "a divisor with an error as large as itself loses the error of the quotient and of its uses") {
  const Value difference = leaf("3000000000000001") * leaf("3") - leaf("9000000000000000");
  CHECK_FALSE(difference.is_lost);
  CHECK((leaf("1") / difference).is_lost);
  CHECK((leaf("2") + leaf("1") / difference).is_lost);
  CHECK(sqrt(difference).is_lost);
  CHECK(call(FunctionId::log, difference).is_lost);
  CHECK_FALSE((leaf("1") / leaf("3")).is_lost);
  CHECK_FALSE(call(FunctionId::tanh, value_with_error("0", "3")).is_lost);
}

TEST_CASE("the error of a square root at 0 is lost") {
  const Value root = sqrt(value_with_error("0", "1"));
  CHECK(number(root.value) == 0);
  CHECK(root.is_lost);
}

TEST_CASE("errors do not grow in an iteration that contracts") {
  Value x = leaf("21") - leaf("20");
  for (int i = 0; i < 20; ++i) x = leaf("1") + x * x / leaf("8");
  CHECK(error(x) < 10);
}

TEST_CASE("errors in double agree with errors in 64 digits") {
  const auto both = [](double x, double e) {
    return std::pair(Value{Real(exact_value(x)), Real(exact_value(e))}, RunningValue<double>{x, e});
  };
  const auto [x, x_rough] = both(0.75, 3);
  const auto [y, y_rough] = both(-2.5, 1);
  CHECK(rules_in_double.add(x_rough, y_rough).error == Approx(error(x + y)));
  CHECK(rules_in_double.multiply(x_rough, y_rough).error == Approx(error(x * y)));
  CHECK(rules_in_double.divide(x_rough, y_rough).error == Approx(error(x / y)));
  CHECK(rules_in_double.square_root(x_rough).error == Approx(error(sqrt(x))));
  for (const FunctionRow& row : function_table()) {
    INFO(row.name);
    CHECK(rules_in_double.call(row.id, x_rough, {2, 1}).error ==
          Approx(error(rules.call(row.id, x, value_with_error("2", "1")))));
  }
  CHECK(rules_in_double.divide(x_rough, {1e-18, 1}).is_lost);
}
