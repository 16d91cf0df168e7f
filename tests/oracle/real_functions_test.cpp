#include "oracle/real_functions.hpp"

#include <catch2/catch.hpp>

#include "numbers/exact_number.hpp"
#include "numbers/more_digits.hpp"
#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::oracle;
using namespace elgen::test;
using cln::cl_R;

namespace {

cl_R value(FunctionId function, const cl_R& x, const cl_R& y = 0) {
  RealFunctions functions;
  return functions.value(function, x, y);
}

}  // namespace

TEST_CASE("exact arguments with exact results stay exact") {
  CHECK(is_rational(value(FunctionId::sin, 0)));
  CHECK(value(FunctionId::cos, 0) == 1);
  CHECK(value(FunctionId::exp, 0) == 1);
  CHECK(value(FunctionId::log, 1) == 0);
  CHECK(value(FunctionId::atan2, 0, 2) == 0);
  CHECK(real_power(exact("9/4"), exact("1/2")) == exact("3/2"));
  CHECK(real_power(exact("9/4"), exact("-3/2")) == exact("8/27"));
}

TEST_CASE("sines of huge exact angles are correct, such as sin(1e22)") {
  CHECK(agree(value(FunctionId::sin, exact("1e22")), exact("-0.8522008497671888017727058937530294"),
              30));
  const cl_R huge = exact("1e300");
  const cl_R sine = value(FunctionId::sin, huge);
  const cl_R cosine = value(FunctionId::cos, huge);
  CHECK(agree(sine * sine + cosine * cosine, 1, 90));
  // 2*huge is reduced with other digits of pi, so this check is independent.
  CHECK(agree(value(FunctionId::sin, 2 * huge), 2 * sine * cosine, 90));
}

TEST_CASE("large irrational angles request the digits they have lost") {
  const auto sine_of_power = [] {
    return value(FunctionId::sin, value(FunctionId::exp, 1000) * exact("1e-100"));
  };
  const cl_R truth = [] {
    const auto format = cln::float_format(700);
    const cl_R power = cln::exp(cln::cl_float(1000, format)) / cln::expt(cln::cl_RA(10), 100);
    return cl_R(cln::sin(cln::the<cln::cl_F>(power)));
  }();
  CHECK_FALSE(agree(sine_of_power(), truth, 60));
  int computations = 0;
  const cl_R sine = with_enough_digits([&] {
    ++computations;
    return sine_of_power();
  });
  CHECK(agree(sine, truth, 60));
  CHECK(computations == 2);
  CHECK_THROWS_AS(value(FunctionId::sin, as_float(cln::expt(cl_R(10), 7000))), OutsideDomain);
}

TEST_CASE("inverse functions undo their functions to almost all digits") {
  const cl_R x = exact("0.37");
  CHECK(agree(value(FunctionId::asin, value(FunctionId::sin, x)), x, 90));
  CHECK(agree(value(FunctionId::acos, value(FunctionId::cos, x)), x, 90));
  CHECK(agree(value(FunctionId::atan, value(FunctionId::tan, x)), x, 90));
  CHECK(agree(value(FunctionId::log, value(FunctionId::exp, x)), x, 90));
  CHECK(agree(value(FunctionId::atan2, -1, -1), -real_pi() * 3 / 4, 90));
  CHECK(agree(value(FunctionId::asin, 1), real_pi() / 2, 90));
  CHECK(agree(value(FunctionId::acos, 0), real_pi() / 2, 90));
  CHECK(agree(value(FunctionId::tanh, 300), 1, 90));
  CHECK(agree(value(FunctionId::expm1, -exact("1e10")), -1, 90));
}

TEST_CASE("kinked functions select the right branch") {
  CHECK(value(FunctionId::abs, -3) == 3);
  CHECK(value(FunctionId::sign, -3) == -1);
  CHECK(value(FunctionId::sign, 0) == 0);
  CHECK(value(FunctionId::min, 0, -1) == -1);
  CHECK(value(FunctionId::max, 0, -1) == 0);
}

TEST_CASE("arguments outside the domain throw") {
  CHECK_THROWS_AS(value(FunctionId::log, 0), OutsideDomain);
  CHECK_THROWS_AS(value(FunctionId::log, -1), OutsideDomain);
  CHECK_THROWS_AS(value(FunctionId::asin, exact("1.1")), OutsideDomain);
  CHECK_THROWS_AS(value(FunctionId::atan2, 0, 0), OutsideDomain);
  CHECK_THROWS_AS(value(FunctionId::exp, exact("1e9")), NumberTooLarge);
  CHECK_THROWS_AS(quotient(1, 0), OutsideDomain);
  CHECK_THROWS_AS(real_power(-1, exact("1/2")), OutsideDomain);
}

TEST_CASE("long rationals become floats, short rationals stay") {
  CHECK(is_rational(shorten_rationals(exact("1/3"))));
  const cl_R lengthy = cln::expt(exact("1/3"), cln::cl_I(5000));
  CHECK_FALSE(is_rational(shorten_rationals(lengthy)));
  CHECK(agree(shorten_rationals(lengthy), lengthy, 90));
}

TEST_CASE("pi has as many digits as requested") {
  const auto digits = [] { return cln::float_digits(cln::the<cln::cl_F>(real_pi())); };
  const auto few = digits();
  CHECK(with_digits(64, digits) > few + 200);  // binary digits
}
