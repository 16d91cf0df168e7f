#include "support/real.hpp"

#include <cln/float.h>
#include <cln/rational.h>

#include <catch2/catch.hpp>

#include "numbers/more_digits.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// True if |x - y| < 1e-62 max(|y|, 1).
bool near(const Real& x, const Real& y) {
  const cln::cl_F scale = cln::max(cln::abs(y.value()), cln::cl_float(1, Real::format()));
  return x.is_defined() &&
         cln::abs(x.value() - y.value()) <
             scale * cln::cl_float(cln::expt(cln::cl_RA(10), -62), Real::format());
}

}  // namespace

TEST_CASE("inverse functions undo their functions") {
  const Real x = real("3/10");
  CHECK(near(asin(sin(x)), x));
  CHECK(near(acos(cos(x)), x));
  CHECK(near(atan(tan(x)), x));
  CHECK(near(log(exp(x)), x));
  CHECK(near(sqrt(x) * sqrt(x), x));
  CHECK(near(tanh(x) * cosh(x), sinh(x)));
  CHECK(near(sin(x) * sin(x) + cos(x) * cos(x), Real(1)));
}

TEST_CASE("for large arguments tanh and expm1 have their limits, other exponentials no value") {
  CHECK(near(expm1(real("-1e10")), Real(-1)));
  CHECK(near(tanh(real("1e10")), Real(1)));
  CHECK(near(tanh(real("-1e10")), Real(-1)));
  CHECK_FALSE(expm1(real("1e10")).is_defined());
  CHECK_FALSE(exp(real("-1e10")).is_defined());
}

TEST_CASE("atan2 takes the ordinate first and respects the quadrant") {
  CHECK(near(atan2(real("1"), real("-1")), Real(cln::pi(Real::format()) * 3 / 4)));
  CHECK(near(atan2(real("-1"), real("1")), Real(-cln::pi(Real::format()) / 4)));
  CHECK(near(atan2(real("0"), real("0")), real("0")));
  CHECK(near(acos(real("-1")), Real(cln::pi(Real::format()))));
}

TEST_CASE("an angle without correct digits after the point requests more digits") {
  const auto sine = [] { return sin(Real(cln::expt(cln::cl_RA(10), 100)) * (Real(1) / Real(3))); };
  // The reference computes the angle 10^100/3 exactly, and the sine in 180 digits.
  const Real truth = [] {
    const cln::cl_RA angle = cln::expt(cln::cl_RA(10), 100) / 3;
    return Real(cln::sin(cln::cl_float(angle, cln::float_format(180))));
  }();
  CHECK_FALSE(near(sine(), truth));
  int computations = 0;
  const auto counted = [&](const auto& computation) {
    computations = 0;
    return with_enough_digits([&] {
      ++computations;
      return computation();
    });
  };
  CHECK(near(counted(sine), truth));
  CHECK(computations == 2);
  CHECK(near(counted([] { return sin(real("1000")); }), sin(Real(1000))));
  CHECK(computations == 1);
}

TEST_CASE("large angles keep all digits") {
  const cln::cl_RA two_pi = cln::rational(cln::pi(cln::float_format(140))) * 2;
  const cln::cl_R angle = two_pi * cln::expt(cln::cl_RA(10), 40) + cln::cl_RA("1/2");
  // The angle 2 pi 10^40 + 1/2 has 41 of its 64 digits before the point, 23 digits after the point.
  const Real difference = sin(Real(angle)) - sin(real("1/2"));
  CHECK(cln::abs(difference.value()) <
        cln::cl_float(cln::expt(cln::cl_RA(10), -22), Real::format()));
  const Real exact_angle(cln::expt(cln::cl_RA(10), 40));
  CHECK(near(sin(exact_angle) * sin(exact_angle), Real(1) - cos(exact_angle) * cos(exact_angle)));
}

TEST_CASE("outside the domain a value is undefined, and so are results computed from it") {
  const Real zero;
  CHECK_FALSE((real("1") / zero).is_defined());
  CHECK_FALSE(sqrt(real("-1")).is_defined());
  CHECK_FALSE(log(zero).is_defined());
  CHECK_FALSE(asin(real("2")).is_defined());
  CHECK_FALSE(acos(real("-11/10")).is_defined());
  const Real undefined = Real::undefined();
  CHECK_FALSE((undefined + zero).is_defined());
  CHECK_FALSE((zero * undefined).is_defined());
  CHECK_FALSE((-undefined).is_defined());
  CHECK_FALSE(max(zero, undefined).is_defined());
  CHECK_FALSE(sin(undefined).is_defined());
}

TEST_CASE("kinked functions have their exact values") {
  CHECK(near(sign(Real()), real("0")));
  CHECK(near(sign(real("-7")), real("-1")));
  CHECK(near(abs(real("-7/2")), real("7/2")));
  CHECK(near(min(real("1"), real("2")), real("1")));
  CHECK(near(max(real("1"), real("2")), real("2")));
}

TEST_CASE("numbers are ordered, undefined numbers are not") {
  CHECK(real("1") < real("2"));
  CHECK_FALSE(real("2") < real("2"));
  CHECK(real("2") <= real("2"));
  CHECK(real("-1/3") > real("-1/2"));
  const Real undefined = Real::undefined();
  CHECK_FALSE(undefined < real("1"));
  CHECK_FALSE(real("1") < undefined);
  CHECK_FALSE(undefined <= undefined);
}

TEST_CASE("near numbers differ by less than 1e-40 or a given tolerance") {
  const Real x = real("1/3");
  const Real apart(cln::expt(cln::cl_RA(10), -30));
  CHECK(is_near(x, x + Real(cln::expt(cln::cl_RA(10), -41))));
  CHECK_FALSE(is_near(x, x + apart));
  CHECK(is_near(x - apart, x, 25));
  CHECK_FALSE(is_near(x, Real::undefined()));
}

TEST_CASE("a number beyond the range of exponents is undefined, and nothing is thrown") {
  Real x(10);
  for (int i = 0; i < 80; ++i) x = x * x;
  CHECK_FALSE(x.is_defined());
  CHECK_FALSE(exp(Real(cln::expt(cln::cl_RA(10), 300))).is_defined());
  CHECK_FALSE((x + Real(1)).is_defined());
}

TEST_CASE("1 + 1e-120 - 1 is 0 in 64 digits, and 1e-120 in 128") {
  const cln::cl_RA tiny = cln::expt(cln::cl_RA(10), -120);
  const auto rest = [&] { return (Real(1) + Real(tiny)) - Real(1); };
  CHECK(cln::zerop(rest().value()));
  CHECK_FALSE(cln::zerop(with_digits(64, rest).value()));
}
