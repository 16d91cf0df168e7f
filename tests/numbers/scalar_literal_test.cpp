// scalar_literal: binary values of exact numbers, known texts, and properties of random numbers.
#include "numbers/scalar_literal.hpp"

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational.h>
#include <rapidcheck.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "elgen/evaluate.hpp"
#include "numbers/exact_number.hpp"

using namespace elgen;
using cln::cl_RA;

namespace {

/// x as an exact rational.
template <class Scalar>
cln::cl_RA rational_of(Scalar x) {
  int exponent = 0;
  const Scalar fraction = std::frexp(x, &exponent);
  const auto integer = static_cast<std::int64_t>(std::ldexp(std::abs(fraction), 63));
  // The leading 63 of at most 64 bits, then the last bit.
  const Scalar rest = std::ldexp(std::abs(fraction), 63) - static_cast<Scalar>(integer);
  cln::cl_RA value = cln::cl_I(integer) + cln::cl_RA(static_cast<int>(rest * 2)) / 2;
  value = exponent >= 63 ? value * cln::ash(1, exponent - 63) : value / cln::ash(1, 63 - exponent);
  return x < 0 ? -value : value;
}

template <class Scalar>
Scalar from(const cln::cl_R& value) {
  return ScalarTraits<Scalar>::from_real(value);
}

template <class Scalar>
void check_limits() {
  using Limits = std::numeric_limits<Scalar>;
  const Scalar smallest = Limits::denorm_min();
  const cln::cl_RA eta = rational_of(smallest);
  CHECK(from<Scalar>(0) == 0);
  CHECK(from<Scalar>(rational_of(Limits::max())) == Limits::max());
  CHECK(from<Scalar>(rational_of(Limits::min())) == Limits::min());
  CHECK(from<Scalar>(eta) == smallest);
  CHECK(from<Scalar>(eta * 3 / 2) == 2 * smallest);  // a tie goes to the even neighbour
  CHECK(from<Scalar>(eta / 2) == 0);                 // a tie too
  CHECK(from<Scalar>(eta * 3 / 4) == smallest);
  CHECK(from<Scalar>(-eta * 5 / 4) == -smallest);
  CHECK(from<Scalar>(cln::expt(eta, 3)) == 0);
  const cln::cl_RA half_ulp =
      rational_of(Limits::max()) - rational_of(std::nextafter(Limits::max(), Scalar(0)));
  CHECK(from<Scalar>(rational_of(Limits::max()) + half_ulp / 3) == Limits::max());
  CHECK(from<Scalar>(rational_of(Limits::max()) + half_ulp / 2) == Limits::infinity());
  CHECK(from<Scalar>(-rational_of(Limits::max()) * 5) == -Limits::infinity());
  const cln::cl_F one = cln::cl_float(1, cln::float_format(60));
  CHECK(from<Scalar>(-cln::scale_float(one, 1L << 42)) == -Limits::infinity());
  CHECK(from<Scalar>(cln::scale_float(one, -(1L << 42))) == 0);
}

}  // namespace

TEST_CASE("zero, the largest and smallest numbers, and numbers beyond them") {
  check_limits<float>();
  check_limits<double>();
  check_limits<long double>();
}

TEST_CASE("decimal literals are rounded as the compiler rounds them") {
  CHECK(from<double>(cln::cl_RA("980665/100000")) == 9.80665);
  CHECK(from<float>(cln::cl_RA("1/10")) == 0.1F);
  CHECK(from<long double>(cln::cl_RA("-1/3")) == -1.0L / 3.0L);
  CHECK(from<double>(cln::cl_RA("-1/3")) == -1.0 / 3.0);
  CHECK(from<float>(cln::cl_RA("16777217/3")) == 5592405.5F);
  CHECK(from<double>(cln::cl_RA(3) / cln::ash(1, 1075)) == 2 * 0x1p-1074);
  CHECK(from<double>(cln::pi(cln::float_format(60))) == 3.14159265358979323846);
}

TEST_CASE(
    "every binary value is reproduced, and a value between two binary values goes to the nearer") {
  CHECK(rc::check("double", [](std::uint64_t bits, std::uint16_t weight) {
    double x = 0;
    std::memcpy(&x, &bits, sizeof x);
    RC_PRE(std::isfinite(x) && std::abs(x) < 1e308);
    RC_ASSERT(from<double>(rational_of(x)) == x);
    const double next = std::nextafter(x, std::numeric_limits<double>::infinity());
    const cln::cl_RA part = cln::cl_RA(static_cast<int>(weight)) / 65536;
    const cln::cl_RA between = rational_of(x) + (rational_of(next) - rational_of(x)) * part;
    if (part != cln::cl_RA("1/2")) {
      RC_ASSERT(from<double>(between) == (part < cln::cl_RA("1/2") ? x : next));
    }
    RC_ASSERT(from<double>(cln::cl_float(between, cln::float_format(60))) == from<double>(between));
  }));
}

TEST_CASE("fit finds overflow and lost digits") {
  CHECK(scalar_fit(power_of_ten(38), ScalarKind::single_precision) == ScalarFit::fits);
  CHECK(scalar_fit(power_of_ten(39), ScalarKind::single_precision) == ScalarFit::too_large);
  CHECK(scalar_fit(-power_of_ten(39), ScalarKind::single_precision) == ScalarFit::too_large);
  CHECK(scalar_fit(power_of_ten(-38), ScalarKind::single_precision) == ScalarFit::too_small);
  CHECK(scalar_fit(power_of_ten(-38), ScalarKind::double_precision) == ScalarFit::fits);
  CHECK(scalar_fit(power_of_ten(-400), ScalarKind::double_precision) == ScalarFit::too_small);
  CHECK(scalar_fit(power_of_ten(-400), ScalarKind::long_double) == ScalarFit::fits);
  CHECK(scalar_fit(0, ScalarKind::single_precision) == ScalarFit::fits);
}

TEST_CASE("only numbers with 24 significant bits are exact in float") {
  CHECK(exact_float_literal(cl_RA(-1) / 2) == "-0.5");
  CHECK(exact_float_literal(16777216) == "16777216.0");
  CHECK_FALSE(exact_float_literal(16777217));
  CHECK_FALSE(exact_float_literal(cl_RA(1) / 10));
  CHECK_FALSE(exact_float_literal(power_of_ten(300)));
}

TEST_CASE("decimals stay, other numbers get the shortest decimal with the same rounding") {
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
    const cl_RA value = cl_RA(numerator) / denominator * power_of_ten(exponent);
    const double nearest = to_double(value);
    RC_ASSERT(std::strtod(shortest_literal(value, ScalarKind::double_precision).c_str(), nullptr) ==
              nearest);
    RC_ASSERT(std::strtod(literal_text(rounded_decimal(value, 30)).c_str(), nullptr) == nearest);
  }));
}
