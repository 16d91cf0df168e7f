// PackTrigonometry: the errors of the table of polynomials, measured again in 40 digits; sines and
// cosines are off by at most what a scene asks for, on the whole domain.
#include "emit/interface/pack_trigonometry.hpp"

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational.h>
#include <cln/real.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "elgen/evaluate.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/random.hpp"

using namespace elgen;
using cln::cl_R;
using cln::cl_RA;

namespace {

const cln::float_format_t digits = cln::float_format(40);

cl_R angle(int step, int steps) { return cln::pi(digits) / 4 * step / steps; }

/// first + x^power (c_0 + c_1 x^2 + …)
cl_R value(const SinePolynomial& polynomial, const cl_R& first, int power, const cl_R& x) {
  cl_R sum = 0;
  for (std::size_t i = polynomial.coefficients.size(); i-- > 0;) {
    sum = sum * x * x + exact_value(polynomial.coefficients[i]);
  }
  return first + cln::expt(x, cln::cl_I(power)) * sum;
}

cl_R sine(const SinePolynomial& polynomial, const cl_R& x) { return value(polynomial, x, 3, x); }
cl_R cosine(const SinePolynomial& polynomial, const cl_R& x) {
  return value(polynomial, 1 - x * x / 2, 4, x);
}

/// The largest of |difference| over the angles.
template <class Difference>
double largest(const Difference& difference) {
  constexpr int steps = 2000;
  cl_R most = 0;
  for (int step = 0; step <= steps; ++step) {
    most = cln::max(most, cln::abs(difference(angle(step, steps))));
  }
  return cln::double_approx(most);
}

/// The largest error of sine and cosine over random angles of all magnitudes.
template <class Scalar>
double largest_error(const Numerics& numerics) {
  const PackTrigonometry<Scalar> packs(numerics);
  const double domain = angle_reduction(scalar_kind<Scalar>).domain;
  Random random(7);
  double most = 0;
  for (int i = 0; i < 4000; ++i) {
    const double magnitude = i % 2 == 0 ? 4 : domain;
    const auto angle = static_cast<Scalar>(random.uniform(-magnitude, magnitude));
    const Real exact{exact_value(static_cast<double>(angle))};
    const auto [sine, cosine] = packs.of(angle);
    for (const auto& [value, truth] :
         {std::pair(sine, sin(exact)), std::pair(cosine, cos(exact))}) {
      const Real error = Real(exact_value(static_cast<double>(value))) - truth;
      most = std::max(most, std::abs(ScalarTraits<double>::from_real(error.value())));
    }
  }
  return most;
}

}  // namespace

TEST_CASE("the errors of the table are those of its polynomials, rounded up") {
  for (const SinePolynomial& polynomial : sine_polynomials()) {
    const double error = largest([&](const cl_R& x) { return sine(polynomial, x) - cln::sin(x); });
    INFO("sine of degree " << polynomial.degree);
    CHECK(polynomial.coefficients.size() == static_cast<std::size_t>(polynomial.degree - 1) / 2);
    CHECK(error <= polynomial.error);
    CHECK(error >= 0.99 * polynomial.error);
  }
  for (const SinePolynomial& polynomial : cosine_polynomials()) {
    const double error =
        largest([&](const cl_R& x) { return cosine(polynomial, x) - cln::cos(x); });
    INFO("cosine of degree " << polynomial.degree);
    CHECK(polynomial.coefficients.size() == static_cast<std::size_t>(polynomial.degree - 2) / 2);
    CHECK(error <= polynomial.error);
    CHECK(error >= 0.99 * polynomial.error);
  }
}

TEST_CASE("the least degree that will do is taken") {
  const auto degrees = [](const cl_RA& error, ScalarKind scalar) {
    return std::pair(cheapest(sine_polynomials(), error, scalar).degree,
                     cheapest(cosine_polynomials(), error, scalar).degree);
  };
  constexpr ScalarKind in_float = ScalarKind::single_precision;
  constexpr ScalarKind in_double = ScalarKind::double_precision;
  CHECK(degrees(cln::expt(cl_RA(2), -52), in_double) == std::pair(13, 12));
  CHECK(degrees(cl_RA(1) / 10'000'000, in_double) == std::pair(7, 6));
  CHECK(degrees(cl_RA(1) / 100, in_double) == std::pair(5, 4));
  CHECK(degrees(cln::expt(cl_RA(2), -23), in_float) == std::pair(7, 8));
  CHECK(degrees(cl_RA(1) / 1'000'000, in_float) == std::pair(5, 6));
}

TEST_CASE("every accuracy a scalar can have is reached") {
  for (const ScalarKind scalar : {ScalarKind::single_precision, ScalarKind::double_precision}) {
    const cl_RA least = trigonometry_error({}, scalar);
    const cl_RA rounding = exact_value(angle_reduction(scalar).rounding);
    CHECK(exact_value(cheapest(sine_polynomials(), least, scalar).error) + rounding <= least);
    CHECK(exact_value(cheapest(cosine_polynomials(), least, scalar).error) + rounding <= least);
  }
}

TEST_CASE("multiples of pi/2 are exact for all angles of the domain") {
  for (const auto& [scalar, bits] :
       {std::pair(ScalarKind::single_precision, 24), std::pair(ScalarKind::double_precision, 53)}) {
    const AngleReduction& known = angle_reduction(scalar);
    const cl_RA high = exact_value(known.high);
    const cln::cl_I most = cln::ceiling1(exact_value(known.domain) / high);
    // high is an odd number of its last bits: with those of k they have to fit the significand.
    const cln::cl_I significand = cln::numerator(high);
    CHECK(cln::integer_length(significand) + cln::integer_length(most) <=
          static_cast<std::uintptr_t>(bits));
    const cl_R rest = cln::pi(digits) / 2 - high - exact_value(known.low);
    CHECK(cln::abs(rest) * most < known.rounding / 16);
    const cl_R inverse = 2 / cln::pi(digits) - exact_value(known.inverse);
    CHECK(cln::abs(inverse) < known.rounding);
  }
}

TEST_CASE("sines and cosines are off by at most what is asked for, and need not be by less") {
  Numerics numerics;
  CHECK(largest_error<double>(numerics) <= 0x1p-52);
  CHECK(largest_error<float>(numerics) <= 0x1p-23);
  numerics.trigonometry_error = cln::cl_RA(1) / 1'000'000;
  CHECK(largest_error<double>(numerics) <= 1e-6);
  CHECK(largest_error<double>(numerics) > 1e-8);
  CHECK(largest_error<float>(numerics) <= 1e-6);
}

TEST_CASE("angles beyond the domain have no value") {
  const PackTrigonometry<float> packs(Numerics{});
  CHECK(std::isnan(packs.of(1001.0F).sine));
  CHECK(std::isnan(packs.of(-1001.0F).cosine));
  CHECK(std::isnan(packs.of(std::nanf("")).sine));
  CHECK_FALSE(std::isnan(packs.of(1000.0F).sine));
}

TEST_CASE("quarter turns are exact") {
  const PackTrigonometry<double> packs(Numerics{});
  CHECK(packs.of(0).sine == 0);
  CHECK(packs.of(0).cosine == 1);
  CHECK(packs.of(std::acos(-1.0)).cosine == -1);
  CHECK(packs.of(std::acos(-1.0) / 2).sine == 1);
}
