// decimal: known texts, and properties over random rationals.
#include "evaluate/decimal.hpp"

#include <cln/rational.h>
#include <rapidcheck.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "elgen/evaluate.hpp"

using namespace elgen;
using cln::cl_R;
using cln::cl_RA;

namespace {

cl_RA ratio(long numerator, long denominator) {
  return cl_RA(cln::cl_I(numerator)) / cl_RA(cln::cl_I(denominator));
}

cl_RA ten_to(long exponent) { return cln::expt(cl_RA(10), cln::cl_I(exponent)); }

}  // namespace

TEST_CASE("exact decimals") {
  const auto text = [](const cl_R& value) { return literal_text(*exact_decimal(value)); };
  CHECK(text(0) == "0.0");
  CHECK(text(2) == "2.0");
  CHECK(text(-1500) == "-1500.0");
  CHECK(text(ratio(981, 100)) == "9.81");
  CHECK(text(ratio(1, 2000)) == "0.0005");
  CHECK(text(ratio(1, 20000)) == "5e-5");
  CHECK(text(ten_to(-300)) == "1e-300");
  CHECK(text(ratio(602, 100) * ten_to(23)) == "6.02e23");
  CHECK_FALSE(exact_decimal(ratio(1, 3)));
  CHECK_FALSE(exact_decimal(cln::pi(cln::float_format(100))));
}

TEST_CASE("texts to read") {
  CHECK(exact_text(1) == "1");
  CHECK(exact_text(ratio(1, 2)) == "0.5");
  CHECK(exact_text(ratio(-2, 3)) == "-2/3");
  CHECK(exact_text(cln::pi(cln::float_format(100))) ==
        "3.1415926535897932384626433832795028841971693993751");
}

TEST_CASE("rounding to significant digits") {
  CHECK(literal_text(rounded_decimal(ratio(2, 3), 5)) == "0.66667");
  CHECK(literal_text(rounded_decimal(ratio(999999, 1000), 3)) == "1000.0");
  CHECK(literal_text(rounded_decimal(0, 3)) == "0.0");
}

TEST_CASE("fit finds overflow and lost digits") {
  CHECK(fit(ten_to(38), ScalarKind::single_precision) == Fit::fits);
  CHECK(fit(ten_to(39), ScalarKind::single_precision) == Fit::too_large);
  CHECK(fit(-ten_to(39), ScalarKind::single_precision) == Fit::too_large);
  CHECK(fit(ten_to(-38), ScalarKind::single_precision) == Fit::too_small);
  CHECK(fit(ten_to(-38), ScalarKind::double_precision) == Fit::fits);
  CHECK(fit(ten_to(-400), ScalarKind::double_precision) == Fit::too_small);
  CHECK(fit(ten_to(-400), ScalarKind::long_double) == Fit::fits);
  CHECK(fit(0, ScalarKind::single_precision) == Fit::fits);
}

TEST_CASE("only what a float holds is exact in it") {
  CHECK(exact_in_float(ratio(-1, 2)) == "-0.5");
  CHECK(exact_in_float(16777216) == "16777216.0");
  CHECK_FALSE(exact_in_float(16777217));
  CHECK_FALSE(exact_in_float(ratio(1, 10)));
  CHECK_FALSE(exact_in_float(ten_to(300)));
}

TEST_CASE("literals of double are read back as the nearest double") {
  CHECK(rc::check("shortest and exact literals", [] {
    const auto numerator = *rc::gen::inRange<long>(-1000000000, 1000000000);
    const auto denominator = *rc::gen::inRange<long>(1, 1000000000);
    const auto exponent = *rc::gen::inRange<long>(-250, 250);
    const cl_RA value = ratio(numerator, denominator) * ten_to(exponent);
    const double nearest = ScalarTraits<double>::from_real(value);
    RC_ASSERT(std::strtod(shortest_literal(value, ScalarKind::double_precision).c_str(), nullptr) ==
              nearest);
    RC_ASSERT(std::strtod(literal_text(rounded_decimal(value, 30)).c_str(), nullptr) == nearest);
  }));
}
