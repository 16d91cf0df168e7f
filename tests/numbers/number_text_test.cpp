// Text of numbers: exact for rationals, thirty digits for floats, in any locale.

#include <cln/cln.h>
#include <cln/rational.h>
#include <cln/rational_io.h>

#include <catch2/catch.hpp>
#include <clocale>
#include <limits>

#include "numbers/exact_number.hpp"

namespace elgen::test {

using cln::cl_R;
using cln::cl_RA;

namespace {

cl_RA ratio(long numerator, long denominator) {
  return cl_RA(cln::cl_I(numerator)) / cl_RA(cln::cl_I(denominator));
}

}  // namespace

TEST_CASE("rationals are printed exactly") {
  CHECK(number_text(0) == "0");
  CHECK(number_text(-7) == "-7");
  CHECK(number_text(cln::cl_RA(-1) / 3) == "-1/3");
  CHECK(number_text(cln::expt(cln::cl_RA(10), 25)) == "10000000000000000000000000");
}

TEST_CASE("floats are printed with thirty digits and their exponent") {
  const cln::float_format_t format = cln::float_format(100);
  CHECK(number_text(cln::pi(format)) == "3.14159265358979323846264338328e0");
  CHECK(number_text(-cln::pi(format) / 1000) == "-3.14159265358979323846264338328e-3");
  CHECK(number_text(cln::sqrt(cln::cl_float(2, format)) * 1000000) ==
        "1.41421356237309504880168872421e6");
  CHECK(number_text(cln::cl_float(1, format)) == "1.00000000000000000000000000000e0");
}

TEST_CASE("a number that rounds up to a power of ten has its exponent") {
  const cln::float_format_t format = cln::float_format(100);
  const cln::cl_R below_ten = cln::cl_float(10 - cln::expt(cln::cl_RA(10), -60), format);
  REQUIRE(below_ten < 10);
  CHECK(number_text(below_ten) == "1.00000000000000000000000000000e1");
  CHECK(number_text(-below_ten / 1000) == "-1.00000000000000000000000000000e-2");
  const cln::cl_RA nines = 10 - cln::expt(cln::cl_RA(10), -29);
  CHECK(number_text(cln::cl_float(nines, format)) == "9.99999999999999999999999999999e0");
}

TEST_CASE("exact decimals are printed as literals") {
  const auto text = [](const cl_R& value) { return literal_text(*exact_decimal(value)); };
  CHECK(text(0) == "0.0");
  CHECK(text(2) == "2.0");
  CHECK(text(-1500) == "-1500.0");
  CHECK(text(ratio(981, 100)) == "9.81");
  CHECK(text(ratio(1, 2000)) == "0.0005");
  CHECK(text(ratio(1, 20000)) == "5e-5");
  CHECK(text(power_of_ten(-300)) == "1e-300");
  CHECK(text(ratio(602, 100) * power_of_ten(23)) == "6.02e23");
  CHECK_FALSE(exact_decimal(ratio(1, 3)));
  CHECK_FALSE(exact_decimal(cln::pi(cln::float_format(100))));
}

TEST_CASE("numbers for readers: short decimals, fractions, fifty digits") {
  CHECK(exact_text(1) == "1");
  CHECK(exact_text(ratio(1, 2)) == "0.5");
  CHECK(exact_text(ratio(-2, 3)) == "-2/3");
  CHECK(exact_text(cln::pi(cln::float_format(100))) ==
        "3.1415926535897932384626433832795028841971693993751");
}

TEST_CASE("decimals are rounded to significant digits") {
  CHECK(literal_text(rounded_decimal(ratio(2, 3), 5)) == "0.66667");
  CHECK(literal_text(rounded_decimal(ratio(999999, 1000), 3)) == "1000.0");
  CHECK(literal_text(rounded_decimal(0, 3)) == "0.0");
}

TEST_CASE("the text does not depend on the locale") {
  const char* previous = std::setlocale(LC_ALL, nullptr);
  const std::string saved = previous == nullptr ? "C" : previous;
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  CHECK(number_text(cln::cl_RA(123456789) / 10) == "123456789/10");
  std::setlocale(LC_ALL, saved.c_str());
}

TEST_CASE("binary numbers are converted exactly, denormals too") {
  CHECK(exact_value(0.1) == cln::cl_R("3602879701896397/36028797018963968"));
  CHECK(exact_value(-6.5) == cln::cl_R("-13/2"));
  CHECK(exact_value(0) == 0);
  const cln::cl_RA smallest = 1 / cln::expt(cln::cl_RA(2), 1074);
  CHECK(exact_value(std::numeric_limits<double>::denorm_min()) == smallest);
}

TEST_CASE("the largest number is the largest magnitude") {
  CHECK(max_magnitude({}) == 0);
  CHECK(max_magnitude({1, -3, 2}) == 3);
}

TEST_CASE("powers of ten are exact in both directions") {
  CHECK(power_of_ten(0) == 1);
  CHECK(power_of_ten(3) == 1000);
  CHECK(power_of_ten(-400) * power_of_ten(400) == 1);
}

TEST_CASE("decimal exponents are right for numbers of any size") {
  CHECK(decimal_exponent(0) == 0);
  CHECK(decimal_exponent(power_of_ten(5000)) == Approx(5000).margin(1));
  CHECK(decimal_exponent(cln::pi()) == Approx(0).margin(1));
}

TEST_CASE("a simple fraction is the first convergent within the tolerance") {
  const cl_RA close = power_of_ten(-9);
  const auto within = [&](const cln::cl_R& x, int most) { return simple_fraction(x, most, close); };
  CHECK(within(0, 1) == cl_RA(0));
  CHECK(within(-3, 1) == cl_RA(-3));
  CHECK(within(ratio(22, 7), 999) == ratio(22, 7));
  CHECK(within(ratio(-22, 7), 7) == ratio(-22, 7));
  CHECK_FALSE(within(ratio(22, 7), 6));
  const cln::cl_R third = cln::cl_float(ratio(1, 3), cln::float_format(60));
  CHECK(within(third, 3) == ratio(1, 3));
  CHECK(within(third + power_of_ten(-12), 3) == ratio(1, 3));
  CHECK_FALSE(within(third + power_of_ten(-6), 999));
  CHECK_FALSE(within(cln::sqrt(cln::cl_float(2, cln::float_format(60))), 999));
  CHECK(simple_fraction(third, 3, power_of_ten(-50)) == ratio(1, 3));
  CHECK_FALSE(simple_fraction(third + power_of_ten(-40), 999, power_of_ten(-50)));
}

}  // namespace elgen::test
