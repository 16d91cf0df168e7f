#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational.h>
#include <rapidcheck.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "elgen/evaluate.hpp"

using namespace elgen;

namespace {

/// x as an exact rational.
template <class Scalar>
cln::cl_RA exact(Scalar x) {
  int exponent = 0;
  const Scalar fraction = std::frexp(x, &exponent);
  const auto integer = static_cast<std::int64_t>(std::ldexp(std::abs(fraction), 63));
  // 63 of at most 64 bits, then what is left.
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
  const cln::cl_RA eta = exact(smallest);
  CHECK(from<Scalar>(0) == 0);
  CHECK(from<Scalar>(exact(Limits::max())) == Limits::max());
  CHECK(from<Scalar>(exact(Limits::min())) == Limits::min());
  CHECK(from<Scalar>(eta) == smallest);
  CHECK(from<Scalar>(eta * 3 / 2) == 2 * smallest);  // a tie goes to the even neighbour
  CHECK(from<Scalar>(eta / 2) == 0);                 // likewise
  CHECK(from<Scalar>(eta * 3 / 4) == smallest);
  CHECK(from<Scalar>(-eta * 5 / 4) == -smallest);
  CHECK(from<Scalar>(cln::expt(eta, 3)) == 0);
  const cln::cl_RA half_ulp =
      exact(Limits::max()) - exact(std::nextafter(Limits::max(), Scalar(0)));
  CHECK(from<Scalar>(exact(Limits::max()) + half_ulp / 3) == Limits::max());
  CHECK(from<Scalar>(exact(Limits::max()) + half_ulp / 2) == Limits::infinity());
  CHECK(from<Scalar>(-exact(Limits::max()) * 5) == -Limits::infinity());
  const cln::cl_F one = cln::cl_float(1, cln::float_format(60));
  CHECK(from<Scalar>(-cln::scale_float(one, 1L << 42)) == -Limits::infinity());
  CHECK(from<Scalar>(cln::scale_float(one, -(1L << 42))) == 0);
}

}  // namespace

TEST_CASE("zero, the largest, the smallest and beyond") {
  check_limits<float>();
  check_limits<double>();
  check_limits<long double>();
}

TEST_CASE("decimal literals round as the compiler's do") {
  CHECK(from<double>(cln::cl_RA("980665/100000")) == 9.80665);
  CHECK(from<float>(cln::cl_RA("1/10")) == 0.1F);
  CHECK(from<long double>(cln::cl_RA("-1/3")) == -1.0L / 3.0L);
  CHECK(from<double>(cln::pi(cln::float_format(60))) == 3.14159265358979323846);
}

TEST_CASE("every binary value comes back, and a value between two goes to the nearer") {
  CHECK(rc::check("double", [](std::uint64_t bits, std::uint16_t weight) {
    double x = 0;
    std::memcpy(&x, &bits, sizeof x);
    RC_PRE(std::isfinite(x) && std::abs(x) < 1e308);
    RC_ASSERT(from<double>(exact(x)) == x);
    const double next = std::nextafter(x, std::numeric_limits<double>::infinity());
    const cln::cl_RA part = cln::cl_RA(static_cast<int>(weight)) / 65536;
    const cln::cl_RA between = exact(x) + (exact(next) - exact(x)) * part;
    if (part != cln::cl_RA("1/2")) {
      RC_ASSERT(from<double>(between) == (part < cln::cl_RA("1/2") ? x : next));
    }
  }));
}
