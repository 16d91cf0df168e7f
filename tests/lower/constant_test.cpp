#include "lower/constant.hpp"

#include <cln/float.h>

#include <catch2/catch.hpp>

#include "elgen/evaluate.hpp"

using namespace elgen;

namespace {

SignedConstant number(const char* text) { return make_constant(cln::cl_RA(text)); }

std::string text(const SignedConstant& x) { return (x.negative ? "-" : "") + x.constant.text; }

double value(const SignedConstant& x) {
  const double magnitude = ScalarTraits<double>::from_real(x.constant.value);
  return x.negative ? -magnitude : magnitude;
}

}  // namespace

TEST_CASE("rationals stay rational") {
  CHECK(text(sum_of({number("1/2"), number("-2/3")})) == "-1/6");
  CHECK(text(product_of({number("-1/2"), number("2/3")})) == "-1/3");
  CHECK(text(power_of(number("-2/3"), -3)) == "-27/8");
  CHECK(text(square_root_of(number("9/4").constant)) == "3/2");
  CHECK(is_rational(square_root_of(number("9/4").constant).constant));
  CHECK_FALSE(is_rational(pi_constant().constant));
}

TEST_CASE("what is not rational keeps a text of its own, whatever the order of operands") {
  const SignedConstant pi = pi_constant();
  const SignedConstant root = square_root_of(number("2").constant);
  CHECK(text(root) == "sqrt(2)");
  CHECK(text(product_of({pi, number("-1/2"), root})) == "-1/2*pi*sqrt(2)");
  CHECK(text(product_of({root, pi, number("-1/2")})) == "-1/2*pi*sqrt(2)");
  CHECK(text(sum_of({pi, number("-1/2")})) == "-1/2 + pi");
  CHECK(text(power_of(sum_of({pi, number("1")}), 2)) == "(1 + pi)^2");
  CHECK(text(call_of(FunctionId::atan2, {number("-1"), pi})) == "-(-atan2(-1, pi))");
}

TEST_CASE("a sum that is negative turns its text") {
  const SignedConstant sum = sum_of({pi_constant(), number("-4")});
  CHECK(sum.negative);
  CHECK(sum.constant.text == "4 - pi");
  CHECK(value(sum) == Approx(3.14159265358979 - 4).epsilon(1e-13));  // digits typed here
}

TEST_CASE("calls have the values of the C library") {
  const double x = 0.3;
  const auto call = [](FunctionId f) { return value(call_of(f, {number("3/10")})); };
  const double ulps = 4 * std::numeric_limits<double>::epsilon();  // libm is not correctly rounded
  CHECK(call(FunctionId::sin) == Approx(std::sin(x)).epsilon(ulps));
  CHECK(call(FunctionId::cos) == Approx(std::cos(x)).epsilon(ulps));
  CHECK(call(FunctionId::tan) == Approx(std::tan(x)).epsilon(ulps));
  CHECK(call(FunctionId::asin) == Approx(std::asin(x)).epsilon(ulps));
  CHECK(call(FunctionId::acos) == Approx(std::acos(x)).epsilon(ulps));
  CHECK(call(FunctionId::atan) == Approx(std::atan(x)).epsilon(ulps));
  CHECK(call(FunctionId::sinh) == Approx(std::sinh(x)).epsilon(ulps));
  CHECK(call(FunctionId::cosh) == Approx(std::cosh(x)).epsilon(ulps));
  CHECK(call(FunctionId::tanh) == Approx(std::tanh(x)).epsilon(ulps));
  CHECK(call(FunctionId::exp) == Approx(std::exp(x)).epsilon(ulps));
  CHECK(call(FunctionId::log) == Approx(std::log(x)).epsilon(ulps));
  const SignedConstant angle = call_of(FunctionId::atan2, {number("1"), number("-2")});
  CHECK(value(angle) == Approx(std::atan2(1.0, -2.0)).epsilon(ulps));
}

TEST_CASE("exact calls stay exact") {
  CHECK(text(call_of(FunctionId::abs, {number("-3/2")})) == "3/2");
  CHECK(text(call_of(FunctionId::sign, {number("-3/2")})) == "-1");
  CHECK(text(call_of(FunctionId::min, {number("1"), number("-2")})) == "-2");
  CHECK(text(call_of(FunctionId::max, {number("1"), number("-2")})) == "1");
  CHECK(text(call_of(FunctionId::sin, {number("0")})) == "0");
  CHECK(text(call_of(FunctionId::cos, {number("0")})) == "1");
  CHECK(text(call_of(FunctionId::acos, {number("0")})) == "acos(0)");
  CHECK(text(call_of(FunctionId::atan2, {number("0"), number("1")})) == "0");
  CHECK(text(call_of(FunctionId::log, {number("1")})) == "0");
}

TEST_CASE("exact calls of what is not rational are one of their arguments") {
  const SignedConstant pi = pi_constant();
  const SignedConstant minus_pi{pi.constant, true};
  const auto row = [](FunctionId function, const std::vector<SignedConstant>& arguments) {
    const SignedConstant result = call_of(function, arguments);
    return std::pair(text(result), value(result));
  };
  const double pi_value = value(pi);
  CHECK(row(FunctionId::max, {number("3"), pi}) == std::pair<std::string, double>("pi", pi_value));
  CHECK(row(FunctionId::max, {pi, number("3")}) == std::pair<std::string, double>("pi", pi_value));
  CHECK(row(FunctionId::min, {number("3"), pi}) == std::pair<std::string, double>("3", 3));
  CHECK(row(FunctionId::min, {number("3"), minus_pi}) ==
        std::pair<std::string, double>("-pi", -pi_value));
  CHECK(row(FunctionId::max, {minus_pi, number("-4")}) ==
        std::pair<std::string, double>("-pi", -pi_value));
  CHECK(row(FunctionId::abs, {minus_pi}) == std::pair<std::string, double>("pi", pi_value));
  CHECK(row(FunctionId::sign, {minus_pi}) == std::pair<std::string, double>("-1", -1));
  CHECK(row(FunctionId::sign, {number("0")}) == std::pair<std::string, double>("0", 0));
}

TEST_CASE("calls without a real value fold to nothing") {
  CHECK(call_of(FunctionId::log, {number("0")}).constant.text.empty());
  CHECK(call_of(FunctionId::asin, {number("2")}).constant.text.empty());
  CHECK(call_of(FunctionId::acos, {number("-2")}).constant.text.empty());
}
