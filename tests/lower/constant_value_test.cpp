#include "lower/constants/constant_value.hpp"

#include <cln/float.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "elgen/evaluate.hpp"
#include "lower/graph/graph.hpp"
#include "support/constant_reader.hpp"

using namespace elgen;

namespace {

double value(const std::string& text) {
  const auto constant = test::read_constant(text);
  REQUIRE(constant);
  return ScalarTraits<double>::from_real(constant->value);
}

ConstantForm call(FunctionId function, const char* argument) {
  return {.kind = ConstantKind::call,
          .function = function,
          .parts = {{rational_form(cln::cl_RA(argument)), 1}}};
}

}  // namespace

TEST_CASE("calls have the values of the C library") {
  // libm is not correctly rounded.
  const auto close = [](double x) {
    return Approx(x).epsilon(4 * std::numeric_limits<double>::epsilon());
  };
  const double x = 0.3;
  CHECK(value("sin(3/10)") == close(std::sin(x)));
  CHECK(value("cos(3/10)") == close(std::cos(x)));
  CHECK(value("tan(3/10)") == close(std::tan(x)));
  CHECK(value("asin(3/10)") == close(std::asin(x)));
  CHECK(value("acos(3/10)") == close(std::acos(x)));
  CHECK(value("acos(-1)") == close(std::acos(-1.0)));
  CHECK(value("atan(3/10)") == close(std::atan(x)));
  CHECK(value("sinh(3/10)") == close(std::sinh(x)));
  CHECK(value("cosh(3/10)") == close(std::cosh(x)));
  CHECK(value("tanh(3/10)") == close(std::tanh(x)));
  CHECK(value("exp(3/10)") == close(std::exp(x)));
  CHECK(value("log(3/10)") == close(std::log(x)));
  CHECK(value("atan2(1,-2)") == close(std::atan2(1.0, -2.0)));
  CHECK(value("sqrt(2)*pi^(-1)") == close(std::sqrt(2.0) / std::acos(-1.0)));
}

TEST_CASE("the error is bounded: 1000 digits more agree within it") {
  // sin(10^30) needs thirty digits for its angle alone, 1 - cos(1e-60) loses a hundred and twenty.
  for (const char* text : {"sin(1000000000000000000000000000000)",
                           "1-cos(1/1000000000000000000000000000000000000000000000000000000000000)",
                           "exp(1)*pi-tan(7/5)"}) {
    const auto constant = test::read_constant(text);
    REQUIRE(constant);
    const auto enclosure = enclosure_of(constant->form);
    REQUIRE(enclosure);
    CHECK(enclosure->error <= cln::abs(enclosure->value) * cln::expt(cln::cl_RA(10), -200));
    CHECK(sign_of(*enclosure).has_value());
  }
}

TEST_CASE("what cancels is not told from 0, and what is exact is") {
  const auto noise = test::read_constant("sqrt(2)*sqrt(3)-sqrt(6)");
  REQUIRE(noise);
  CHECK(cln::zerop(noise->value));
  CHECK_FALSE(sign_of(*enclosure_of(noise->form)));
  CHECK(noise->form.kind == ConstantKind::sum);
  CHECK(sign_of(*enclosure_of(rational_form(0))) == 0);
}

TEST_CASE("what has no real value has none") {
  CHECK_FALSE(enclosure_of(call(FunctionId::log, "0")));
  CHECK_FALSE(enclosure_of(call(FunctionId::log, "-1")));
  CHECK_FALSE(enclosure_of(call(FunctionId::asin, "2")));
  CHECK_FALSE(enclosure_of(call(FunctionId::acos, "-2")));
  CHECK_FALSE(enclosure_of(call(FunctionId::exp, "1000000")));
  CHECK_FALSE(test::read_constant("sqrt(-2)"));
  CHECK_FALSE(test::read_constant("(sqrt(2)*sqrt(3)-sqrt(6))^(-1)"));
}
