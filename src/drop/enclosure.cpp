// Interval arithmetic on rationals, which need no rounding but for roots.
#include "drop/enclosure.hpp"

#include <cln/float.h>
#include <cln/integer.h>

#include <algorithm>

#include "base/exact_number.hpp"

namespace elgen {

using cln::cl_I;
using cln::cl_RA;

namespace {

/// Irrational numbers are kept to 100 digits.
cl_RA uncertainty(const cl_RA& value) {
  static const cl_RA relative = power_of_ten(-90);
  return cln::abs(value) * relative;
}

/// floor(sqrt(x) 2^64) / 2^64 and the next one above.
Enclosure root_of(const cl_RA& x) {
  constexpr long bits = 64;
  const cl_I denominator = cln::denominator(x);
  cl_I root;
  const cl_I scaled = cln::ash(cln::numerator(x) * denominator, 2 * bits);
  const bool is_exact = cln::isqrt(scaled, &root);
  const cl_I divisor = cln::ash(denominator, bits);
  return {root / divisor, (is_exact ? root : root + 1) / divisor};
}

}  // namespace

Enclosure enclosure_of(const cln::cl_R& value) { return enclosure_of(value, value); }

Enclosure enclosure_of(const cln::cl_R& low, const cln::cl_R& high) {
  Enclosure result{cln::rational(low), cln::rational(high)};
  if (!is_rational(low)) result.low = result.low - uncertainty(result.low);
  if (!is_rational(high)) result.high = result.high + uncertainty(result.high);
  return result;
}

Enclosure sum(const Enclosure& x, const Enclosure& y) { return {x.low + y.low, x.high + y.high}; }

Enclosure product(const Enclosure& x, const Enclosure& y) {
  const cl_RA corners[] = {x.low * y.low, x.low * y.high, x.high * y.low, x.high * y.high};
  const auto less = [](const cl_RA& a, const cl_RA& b) { return a < b; };
  const auto [low, high] = std::minmax_element(std::begin(corners), std::end(corners), less);
  return {*low, *high};
}

std::optional<Enclosure> power(const Enclosure& x, std::int32_t exponent) {
  const bool holds_zero = !cln::plusp(x.low) && !cln::minusp(x.high);
  if (exponent < 0) {
    if (holds_zero) return std::nullopt;
    return power({cln::recip(x.high), cln::recip(x.low)}, -exponent);
  }
  if (exponent == 0) return Enclosure{1, 1};
  const cl_RA low = cln::expt(x.low, exponent);
  const cl_RA high = cln::expt(x.high, exponent);
  if (exponent % 2 != 0) return Enclosure{low, high};
  return Enclosure{holds_zero ? cl_RA(0) : cl_RA(cln::min(low, high)), cln::max(low, high)};
}

Enclosure square_root(const Enclosure& x) {
  const cl_RA zero = 0;
  return {root_of(cln::max(x.low, zero)).low, root_of(cln::max(x.high, zero)).high};
}

cl_RA magnitude(const Enclosure& x) { return cln::max(cln::abs(x.low), cln::abs(x.high)); }

}  // namespace elgen
