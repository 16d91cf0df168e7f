// Sines: errors of the tabulated polynomials, measured again in 40 digits. Sines of packs have at
// most the error that a scene permits, sines of single numbers an error of at most 1.5 ulp.
#include "program/evaluate/sines.hpp"

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational.h>
#include <cln/real.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "elgen/evaluate.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/random.hpp"

using namespace elgen;
using cln::cl_R;
using cln::cl_RA;

namespace {

const cln::float_format_t digits = cln::float_format(40);

cl_R angle(int step, int steps) { return cln::pi(digits) / 4 * step / steps; }

/// first + x^power (c_0 + c_1 x^2 + ...)
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

/// max |difference| over the angles in [0, pi/4].
template <class Difference>
double largest(const Difference& difference) {
  constexpr int steps = 2000;
  cl_R most = 0;
  for (int step = 0; step <= steps; ++step) {
    most = cln::max(most, cln::abs(difference(angle(step, steps))));
  }
  return cln::double_approx(most);
}

Scene scene_of(const Numerics& numerics) {
  Scene scene;
  scene.numerics = numerics;
  return scene;
}

/// A scene with this scalar type only.
template <class Scalar>
Scene scene_for() {
  Numerics numerics;
  numerics.scalars = {scalar_kind<Scalar>};
  return scene_of(numerics);
}

/// The error of a value, in ulps of the exact value.
template <class Scalar>
double in_ulps(Scalar value, const Real& truth) {
  constexpr int digits_of_scalar = std::numeric_limits<Scalar>::digits;
  const double magnitude = to_double(truth.value());
  const double ulp = std::ldexp(1.0, std::ilogb(magnitude) + 1 - digits_of_scalar);
  const Real error = Real(exact_value(static_cast<double>(value))) - truth;
  return std::abs(to_double(error.value())) / ulp;
}

/// The larger error of the sine and the cosine of `angle`, in ulps.
template <class Scalar>
double worst_ulps(const SineEvaluator<Scalar>& numbers, Scalar angle) {
  const Real exact{exact_value(static_cast<double>(angle))};
  const auto [sine, cosine] = numbers.evaluate(angle);
  return std::max(in_ulps(sine, sin(exact)), in_ulps(cosine, cos(exact)));
}

/// The largest error in ulps next to k pi/4 in the domain, k = first, first + stride, ...
template <class Scalar>
double worst_beside(std::size_t first, std::size_t stride) {
  const SineEvaluator<Scalar> numbers(scene_for<Scalar>(), SineArithmetic::numbers);
  const double domain = angle_reduction(scalar_kind<Scalar>).domain;
  const double eighth = std::acos(-1.0) / 4;
  double worst = 0;
  for (std::size_t i = first; static_cast<double>(i) * eighth < domain; i += stride) {
    const auto middle = static_cast<Scalar>(static_cast<double>(i) * eighth);
    for (const Scalar to : {Scalar(0), Scalar(1e9)}) {
      worst = std::max(worst, worst_ulps(numbers, std::nextafter(middle, to)));
    }
    worst = std::max(worst, worst_ulps(numbers, Scalar(-middle)));
  }
  return worst;
}

/// The largest error of sine and cosine of packs, over random angles.
template <class Scalar>
double largest_error(const Numerics& numerics) {
  const SineEvaluator<Scalar> packs(scene_of(numerics), SineArithmetic::packs);
  const double domain = angle_reduction(scalar_kind<Scalar>).domain;
  Random random(7);
  double most = 0;
  for (int i = 0; i < 4000; ++i) {
    const double magnitude = i % 2 == 0 ? 4 : domain;
    const auto angle = static_cast<Scalar>(random.uniform(-magnitude, magnitude));
    const Real exact{exact_value(static_cast<double>(angle))};
    const auto [sine, cosine] = packs.evaluate(angle);
    for (const auto& [value, truth] :
         {std::pair(sine, sin(exact)), std::pair(cosine, cos(exact))}) {
      const Real error = Real(exact_value(static_cast<double>(value))) - truth;
      most = std::max(most, std::abs(to_double(error.value())));
    }
  }
  return most;
}

/// A scene that permits the error of lone sines.
template <class Scalar>
Scene lone_scene() {
  Scene scene = scene_for<Scalar>();
  scene.numerics.trigonometry_error = least_lone_sine_error(scalar_kind<Scalar>);
  return scene;
}

struct LargestErrors {
  double ulps = 0;
  double absolute = 0;
};

/// The largest errors of lone sines and cosines at random angles of all sizes, and next to k pi/4.
template <class Scalar>
LargestErrors lone_errors() {
  const SineEvaluator<Scalar> sines(lone_scene<Scalar>(), SineArithmetic::numbers);
  const double domain = angle_reduction(scalar_kind<Scalar>).domain;
  Random random(11);
  LargestErrors most;
  for (int i = 0; i < 6000; ++i) {
    double x = random.uniform(-1, 1) * (i % 2 == 0 ? 4 : domain);
    if (i % 3 == 0) x = std::round(x) * std::acos(0.0) / 2;
    if (i % 5 == 0) x = random.uniform(-1, 1) * std::pow(10, random.uniform(-20, 0));
    const auto angle = static_cast<Scalar>(x);
    const Real exact{exact_value(static_cast<double>(angle))};
    for (const auto& [function, truth] :
         {std::pair(FunctionId::sin, sin(exact)), std::pair(FunctionId::cos, cos(exact))}) {
      const Scalar value = sines.evaluate_lone(function, angle);
      const Real error = Real(exact_value(static_cast<double>(value))) - truth;
      most.ulps = std::max(most.ulps, in_ulps(value, truth));
      most.absolute = std::max(most.absolute, std::abs(to_double(error.value())));
    }
  }
  return most;
}

}  // namespace

TEST_CASE("the table has the errors of its polynomials, rounded up") {
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

TEST_CASE("the polynomials of lone sines have their errors up to pi/2") {
  for (const SinePolynomial& polynomial : lone_sine_polynomials()) {
    const double error =
        largest([&](const cl_R& x) { return sine(polynomial, 2 * x) - cln::sin(2 * x); });
    INFO("sine of degree " << polynomial.degree);
    CHECK(polynomial.coefficients.size() == static_cast<std::size_t>(polynomial.degree - 1) / 2);
    CHECK(error <= polynomial.error);
    CHECK(error >= 0.99 * polynomial.error);
  }
}

TEST_CASE("the lowest sufficient degree is selected") {
  const auto degrees = [](const cl_RA& error, ScalarKind scalar) {
    return std::pair(lowest_degree_polynomial(sine_polynomials(), error, scalar).degree,
                     lowest_degree_polynomial(cosine_polynomials(), error, scalar).degree);
  };
  constexpr ScalarKind in_float = ScalarKind::single_precision;
  constexpr ScalarKind in_double = ScalarKind::double_precision;
  CHECK(degrees(cln::expt(cl_RA(2), -52), in_double) == std::pair(13, 12));
  CHECK(degrees(cl_RA(1) / 10'000'000, in_double) == std::pair(7, 6));
  CHECK(degrees(cl_RA(1) / 100, in_double) == std::pair(5, 4));
  CHECK(degrees(cln::expt(cl_RA(2), -23), in_float) == std::pair(7, 8));
  CHECK(degrees(cl_RA(1) / 1'000'000, in_float) == std::pair(5, 6));
}

TEST_CASE("the polynomials reach the best accuracy of each scalar type") {
  for (const ScalarKind scalar : {ScalarKind::single_precision, ScalarKind::double_precision}) {
    const cl_RA least = trigonometry_error({}, scalar);
    const cl_RA rounding = exact_value(angle_reduction(scalar).rounding);
    CHECK(exact_value(lowest_degree_polynomial(sine_polynomials(), least, scalar).error) +
              rounding <=
          least);
    CHECK(exact_value(lowest_degree_polynomial(cosine_polynomials(), least, scalar).error) +
              rounding <=
          least);
  }
}

TEST_CASE("multiples of all but the last part of pi/2 are exact on the domain") {
  for (const auto& [scalar, bits] :
       {std::pair(ScalarKind::single_precision, 24), std::pair(ScalarKind::double_precision, 53)}) {
    const AngleReduction& known = angle_reduction(scalar);
    const cln::cl_I most = cln::ceiling1(exact_value(known.domain) / exact_value(known.parts[0]));
    cl_R rest = cln::pi(digits) / 2 - exact_value(known.parts.back());
    for (std::size_t i = 0; i + 1 < known.parts.size(); ++i) {
      const cl_RA part = exact_value(known.parts[i]);
      rest = rest - part;
      // k times a part is exact if k and the part together have no more bits than the significand.
      // Trailing zeros of the part do not count.
      cln::cl_I significand = cln::numerator(part);
      while (cln::evenp(significand)) significand = cln::exquo(significand, 2);
      CHECK(cln::integer_length(significand) + cln::integer_length(most) <=
            static_cast<std::uintptr_t>(bits));
    }
    // No double is closer than 2^-61 to a multiple k pi/2, no float closer than 2^-28. The closest
    // number has k < 256.
    const double nearest = std::ldexp(1.0, (bits == 53 ? -61 : -28) - bits);
    CHECK(cln::abs(rest) * 256 < exact_value(nearest));
    const cl_R inverse = 2 / cln::pi(digits) - exact_value(known.inverse);
    CHECK(cln::abs(inverse) < known.rounding);
  }
}

TEST_CASE("sines and cosines have at most the permitted error, and not much less") {
  Numerics numerics;
  CHECK(largest_error<double>(numerics) <= 0x1p-52);
  CHECK(largest_error<float>(numerics) <= 0x1p-23);
  numerics.trigonometry_error = cln::cl_RA(1) / 1'000'000;
  CHECK(largest_error<double>(numerics) <= 1e-6);
  CHECK(largest_error<double>(numerics) > 1e-8);
  CHECK(largest_error<float>(numerics) <= 1e-6);
}

TEST_CASE("packs have no value for angles outside the domain") {
  const SineEvaluator<float> packs(Scene{}, SineArithmetic::packs);
  CHECK(std::isnan(packs.evaluate(1001.0F).sine));
  CHECK(std::isnan(packs.evaluate(-1001.0F).cosine));
  CHECK(std::isnan(packs.evaluate(std::nanf("")).sine));
  CHECK_FALSE(std::isnan(packs.evaluate(1000.0F).sine));
}

TEST_CASE("quarter turns are exact") {
  const SineEvaluator<double> packs(Scene{}, SineArithmetic::packs);
  CHECK(packs.evaluate(0).sine == 0);
  CHECK(packs.evaluate(0).cosine == 1);
  CHECK(packs.evaluate(std::acos(-1.0)).cosine == -1);
  CHECK(packs.evaluate(std::acos(-1.0) / 2).sine == 1);
}

TEST_CASE("sines of single numbers have errors of 1.5 ulp, float 0.9 ulp, and 0.5 ulp near zeros") {
  CHECK(worst_beside<double>(2, 62) <= 0.5001);  // multiples of pi/2
  CHECK(worst_beside<float>(2, 2) <= 0.5001);
  CHECK(worst_beside<double>(1, 62) <= 1.5);  // odd multiples of pi/4, where polynomials are worst
  CHECK(worst_beside<float>(1, 2) <= 0.9);
  Random random(3);
  const SineEvaluator<double> numbers(Scene{}, SineArithmetic::numbers);
  double worst = 0;
  for (int i = 0; i < 4000; ++i) {
    const double angle = random.uniform(-1, 1) * std::pow(10, random.uniform(-20, 5));
    worst = std::max(worst, worst_ulps(numbers, angle));
  }
  CHECK(worst <= 1.5);
}

TEST_CASE("the numbers nearest to multiples of pi/2 keep their digits") {
  const SineEvaluator<double> in_double(scene_for<double>(), SineArithmetic::numbers);
  CHECK(worst_ulps(in_double, 0x1.6c6cbc45dc8dep+5) <= 0.5001);  // 29 pi/2
  const SineEvaluator<float> in_float(scene_for<float>(), SineArithmetic::numbers);
  CHECK(worst_ulps(in_float, 0x1.f9cbe2p+7F) <= 0.5001);  // 161 pi/2
}

TEST_CASE("single numbers outside the domain use the library's sines") {
  const SineEvaluator<double> numbers(Scene{}, SineArithmetic::numbers);
  CHECK(numbers.evaluate(1.1e5).sine == std::sin(1.1e5));
  CHECK(numbers.evaluate(-1e300).cosine == std::cos(-1e300));
  CHECK(std::isnan(numbers.evaluate(std::numeric_limits<double>::infinity()).sine));
  const SineEvaluator<float> floats(Scene{}, SineArithmetic::numbers);
  CHECK(floats.evaluate(1.1e3F).sine == std::sin(1.1e3F));
}

TEST_CASE("a scene may select the library's sines for single numbers") {
  Scene scene;
  scene.numerics.has_library_sines = true;
  const SineEvaluator<double> numbers(scene, SineArithmetic::numbers);
  const SineEvaluator<double> packs(scene, SineArithmetic::packs);
  const SineEvaluator<double> in_line(Scene{}, SineArithmetic::packs);
  for (int i = 0; i < 100; ++i) {
    const double angle = 0.7 * i;
    CHECK(numbers.evaluate(angle).cosine == std::cos(angle));
    CHECK(packs.evaluate(angle).cosine == in_line.evaluate(angle).cosine);
  }
}

TEST_CASE("lone sines have errors of 3 ulp, less than the error that a scene must permit") {
  CHECK(lone_errors<double>().ulps <= 3);
  CHECK(lone_errors<float>().ulps <= 3);
  const auto least = [](ScalarKind scalar) {
    return cln::double_approx(least_lone_sine_error(scalar));
  };
  CHECK(lone_errors<double>().absolute <= 0.8 * least(ScalarKind::double_precision));
  CHECK(lone_errors<float>().absolute <= 0.8 * least(ScalarKind::single_precision));
}

TEST_CASE("lone sines keep the digits next to their zeros, and the sign of zero") {
  const SineEvaluator<double> sines(lone_scene<double>(), SineArithmetic::numbers);
  const auto sine = [&](double x) { return sines.evaluate_lone(FunctionId::sin, x); };
  const auto cosine = [&](double x) { return sines.evaluate_lone(FunctionId::cos, x); };
  CHECK(in_ulps(cosine(0x1.6c6cbc45dc8dep+5), cos(Real(exact_value(0x1.6c6cbc45dc8dep+5)))) <= 1.5);
  CHECK(in_ulps(sine(0x1.921fb54442d18p+1), sin(Real(exact_value(0x1.921fb54442d18p+1)))) <= 1.5);
  CHECK(std::signbit(sine(-0.0)));
  CHECK_FALSE(std::signbit(sine(0.0)));
  CHECK(sine(5e-324) == 5e-324);
  CHECK(sine(-5e-324) == -5e-324);
  CHECK(cosine(0) == 1);
  CHECK(cosine(std::acos(-1.0)) == -1);
  CHECK(sine(1.1e5) == std::sin(1.1e5));
  CHECK(cosine(-1e300) == std::cos(-1e300));
  CHECK(std::isnan(sine(std::numeric_limits<double>::infinity())));
  CHECK(std::isnan(cosine(std::numeric_limits<double>::quiet_NaN())));
}

TEST_CASE("only a scene that permits their error has lone sines") {
  Scene scene = lone_scene<double>();
  CHECK(lone_sine_polynomial(scene, ScalarKind::double_precision)->degree == 17);
  CHECK(lone_sine_polynomial(scene, ScalarKind::single_precision) == nullptr);
  CHECK(lone_sine_polynomial(lone_scene<float>(), ScalarKind::single_precision)->degree == 9);
  scene.numerics.has_library_sines = true;
  CHECK(lone_sine_polynomial(scene, ScalarKind::double_precision) == nullptr);
  CHECK(lone_sine_polynomial(Scene{}, ScalarKind::double_precision) == nullptr);
}

TEST_CASE("the sine of a signed zero keeps the sign") {
  for (const SineArithmetic arithmetic : {SineArithmetic::packs, SineArithmetic::numbers}) {
    const SineEvaluator<double> sines(Scene{}, arithmetic);
    CHECK(std::signbit(sines.evaluate(-0.0).sine));
    CHECK_FALSE(std::signbit(sines.evaluate(0.0).sine));
    CHECK(sines.evaluate(-0.0).cosine == 1);
    CHECK(sines.evaluate(5e-324).sine == 5e-324);
  }
}
