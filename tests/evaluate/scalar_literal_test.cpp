// scalar_literal: known texts, and properties over random rationals.
#include "evaluate/scalar_literal.hpp"

#include <cln/rational.h>
#include <rapidcheck.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "base/number_text.hpp"
#include "elgen/evaluate.hpp"

using namespace elgen;
using cln::cl_RA;

namespace {

cl_RA ratio(long numerator, long denominator) {
  return cl_RA(cln::cl_I(numerator)) / cl_RA(cln::cl_I(denominator));
}

cl_RA ten_to(long exponent) { return cln::expt(cl_RA(10), cln::cl_I(exponent)); }

}  // namespace

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

TEST_CASE("decimals stay, other numbers are the shortest that round to the same") {
  CHECK(scalar_literal(cl_RA(981) / 100, ScalarKind::single_precision) == "9.81");
  CHECK(scalar_literal(1000, ScalarKind::double_precision) == "1000.0");
  CHECK(scalar_literal(cl_RA(1) / 3, ScalarKind::single_precision) == "0.33333334");
  CHECK(scalar_literal(cl_RA(1) / 3, ScalarKind::double_precision) == "0.3333333333333333");
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
