// log1p, expm1, hypot, Stumpff's functions and the derivatives of sinc and cosc keep their digits
// near 0, in every arithmetic.
#include <cln/integer.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <string>

#include "numbers/dual.hpp"
#include "numbers/enclosure.hpp"
#include "numbers/exact_number.hpp"
#include "support/real.hpp"

using namespace elgen;
using cln::cl_RA;

namespace {

/// |x - y|/|y| as a double; |x| if y is 0.
double relative(const Real& x, const Real& y) {
  const Real scale = cln::zerop(y.value()) ? Real(1) : abs(y);
  return to_double((abs(x - y) / scale).value());
}

template <class Scalar>
Real exactly(Scalar x) {
  return Real(exact_value(static_cast<double>(x)));
}
Real exactly(const Real& x) { return x; }

/// The derivative of order `order` of Stumpff's c_k at x, summed term by term. For k < 0 the
/// definition is c_k(x) = c_-k(i x).
Real derivative_of_series(unsigned order, int k, const cl_RA& x) {
  constexpr unsigned last_power = 240;
  const auto first = static_cast<unsigned>(std::abs(k));
  cl_RA sum = 0;
  for (unsigned power = order + order % 2; power <= last_power; power += 2) {
    const cl_RA factor = cl_RA(cln::factorial(power)) / cln::factorial(power - order);
    const cl_RA term =
        factor * cln::expt(x, static_cast<int>(power - order)) / cln::factorial(power + first);
    sum = k < 0 || power % 4 == 0 ? sum + term : sum - term;
  }
  return Real(sum);
}

template <class Scalar, unsigned order>
struct Nested {
  using type = Dual<typename Nested<Scalar, order - 1>::type>;
};
template <class Scalar>
struct Nested<Scalar, 0> {
  using type = Scalar;
};

/// x as a dual number with slope 1 at every level of nesting.
template <class Scalar>
struct Variable {
  static Scalar at(const cl_RA& x) { return ScalarTraits<Scalar>::from_real(x); }
  static Scalar slope(const Scalar& f) { return f; }
};
template <class Base>
struct Variable<Dual<Base>> {
  static Dual<Base> at(const cl_RA& x) {
    return {Variable<Base>::at(x), ScalarTraits<Base>::from_real(1)};
  }
  static auto slope(const Dual<Base>& f) { return Variable<Base>::slope(f.slope); }
};

template <class Scalar, unsigned order>
void check_derivative(double tolerance) {
  using Number = typename Nested<Scalar, order>::type;
  for (const int k : {1, 2, 5, -1, -2, -5}) {
    for (const char* text : {"0", "1/134217728", "1/2", "1", "3", "30"}) {
      const cl_RA x(text);
      const Number f = interpreter::call(FunctionId::stumpff, Variable<Number>::at(x),
                                         ScalarTraits<Number>::from_real(cln::cl_I(k)));
      INFO("derivative " << order << " of c_" << k << " at " << text);
      // For |x| > 1 each differentiation may multiply the relative error by |x|.
      const double lost = std::pow(std::max(1.0, cln::double_approx(x)), order);
      const Real exact = derivative_of_series(order, k, x);
      CHECK(relative(exactly(Variable<Number>::slope(f)), exact) < tolerance * lost);
    }
  }
}

}  // namespace

TEST_CASE("c_k and its derivatives equal their series, in double and in 60 digits") {
  check_derivative<double, 0>(4e-15);
  check_derivative<double, 1>(4e-15);
  check_derivative<double, 2>(4e-15);
  check_derivative<double, 3>(4e-15);
  check_derivative<double, 4>(4e-13);
  check_derivative<Real, 0>(1e-60);
  check_derivative<Real, 1>(1e-60);
  check_derivative<Real, 2>(1e-60);
  check_derivative<Real, 3>(1e-59);
  check_derivative<Real, 4>(1e-59);
}

TEST_CASE("c_k of built-in floats is correct to 8 ulp for every k") {
  for (int k = 1; k <= 46; ++k) {
    for (const double x : {1e-9, 0.3, 0.99, 1.01, 1.6, 2.5, 3.7, 5.9, 12.4, 29.0, 47.0}) {
      INFO("c_" << k << "(" << x << ")");
      const Real exact = stumpff(exactly(x), Real(k));
      CHECK(relative(exactly(interpreter::stumpff(x, static_cast<double>(k))), exact) < 0x1p-50);
      const Real grown = stumpff(exactly(x), Real(-k));
      CHECK(relative(exactly(interpreter::stumpff(x, static_cast<double>(-k))), grown) < 0x1p-49);
    }
  }
  for (const float x : {1e-4F, 0.3F, 1.6F, 5.9F}) {
    const Real exact = stumpff(exactly(x), Real(7));
    CHECK(relative(exactly(interpreter::stumpff(x, 7.0F)), exact) < 0x1p-21);
    const Real grown = stumpff(exactly(x), Real(-7));
    CHECK(relative(exactly(interpreter::stumpff(x, -7.0F)), grown) < 0x1p-21);
  }
}

TEST_CASE("c_k at i x equals its closed form in sinh and cosh, and overflows like cosh") {
  for (const char* text : {"1/1024", "-7/3", "25", "600"}) {
    INFO(text);
    const Real x{cl_RA(text)};
    CHECK(relative(stumpff(x, Real(-1)), sinh(x) / x) < 1e-60);
    const Real lost = cosh(x) - Real(1);  // loses 6 digits at 1/1024
    CHECK(relative(stumpff(x, Real(-2)), lost / (x * x)) < 1e-55);
    CHECK(relative(stumpff(x, Real(-3)), (sinh(x) - x) / (x * x * x)) < 1e-55);
  }
  CHECK_FALSE(stumpff(Real(1 << 30), Real(-3)).is_defined());
  CHECK(stumpff(Real(1 << 30), Real(3)).is_defined());
  for (const double x : {-800.0, 1e155, 1e300}) CHECK(std::isinf(interpreter::stumpff(x, -4.0)));
}

TEST_CASE("log1p and expm1 keep all digits of small numbers") {
  for (const int digits : {1, 12, 40, 300}) {
    const cl_RA small = power_of_ten(-digits);
    for (const cl_RA& x : {small, -small}) {
      INFO("+-1e-" << digits);
      const Real real(x);
      CHECK(relative(log1p(expm1(real)), real) < 1e-61);
      // The series x - x^2/2 + ... and x + x^2/2 + ..., truncated after two terms.
      const double share = std::max(std::pow(10, -2 * digits), 1e-61);
      CHECK(relative(log1p(real), Real(x - x * x / 2)) < share);
      CHECK(relative(expm1(real), Real(x + x * x / 2)) < share);
    }
  }
  for (const double x : {1e-12, -1e-12, 3e-5, 0.7, 20.0}) {
    CHECK(relative(exactly(std::log1p(x)), log1p(exactly(x))) < 0x1p-51);
    CHECK(relative(exactly(std::expm1(x)), expm1(exactly(x))) < 0x1p-51);
  }
  CHECK(relative(expm1(Real(-200)), exp(Real(-200)) - Real(1)) < 1e-60);
  CHECK_FALSE(log1p(Real(-1)).is_defined());
}

TEST_CASE("asinh keeps all digits of small and large numbers") {
  for (const double x : {1e-300, 3e-12, 0.2, 1.0, 40.0, 1e17, 1e300}) {
    INFO(x);
    CHECK(relative(exactly(std::asinh(x)), asinh(exactly(x))) < 0x1p-51);
    CHECK(relative(-asinh(exactly(-x)), asinh(exactly(x))) == 0);
  }
  CHECK(relative(sinh(asinh(Real(3))), Real(3)) < 1e-60);
  CHECK(asinh(Dual<double>{0.75, 1}).slope == Approx(0.8));
}

TEST_CASE("hypot has a value if its squares overflow double") {
  CHECK(relative(hypot(Real(-3), Real(4)), Real(5)) < 1e-62);
  CHECK(interpreter::call(FunctionId::hypot, 3e200, 4e200) == Approx(5e200));
  CHECK(hypot(Dual<double>{3, 1}, Dual<double>{4, 0}).slope == Approx(0.6));
  CHECK_FALSE(hypot(Dual<Real>{Real(), Real(1)}, Dual<Real>{}).slope.is_defined());
}

TEST_CASE("enclosures are narrow near 0 and for large arguments") {
  const auto width = [](const Enclosure& x) { return x.high - x.low; };
  const Enclosure near{1e-12, 2e-12};
  CHECK(width(log1p(near)) < 1.001e-12);
  CHECK(width(expm1(near)) < 1.001e-12);
  CHECK(width(stumpff({-1e-3, 1e-3}, point_enclosure(1))) < 2e-7);
  CHECK(width(stumpff({-1e-3, 1e-3}, point_enclosure(2))) < 1e-7);
  CHECK(width(stumpff({1e3, 1e200}, point_enclosure(5))) < 1e-6);
  CHECK(stumpff({-1e9, 1e9}, point_enclosure(1)).low > -0.22);
  CHECK(width(stumpff({-1e-3, 1e-3}, point_enclosure(-1))) < 2e-7);
  CHECK(stumpff({-2, 1}, point_enclosure(-4)).low == Approx(1 / 24.0));
  CHECK(std::isinf(stumpff({1, 1e200}, point_enclosure(-4)).high));
  CHECK(hypot(Enclosure{-1, 2}, Enclosure{3, 4}).low == Approx(3));
}
