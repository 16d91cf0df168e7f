// Helpers of a generated driver, which evaluates every function of emitted headers with every
// scalar type.
#pragma once

#include <Eigen/Core>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cstdio>
#include <experimental/simd>
#include <limits>
#include <unsupported/Eigen/AutoDiff>
#include <vector>

#include "../support/counted.hpp"
#include "../support/emitted_calls.hpp"

namespace compiled {

using Reference = boost::multiprecision::cpp_bin_float_50;
using Decimal = boost::multiprecision::cpp_dec_float_50;
using Pack = std::experimental::native_simd<double>;
using Array = Eigen::Array<double, 4, 1>;
using AutoDiff = Eigen::AutoDiffScalar<Eigen::Vector2d>;

inline Reference lowered(float x) { return Reference(x); }
inline Reference lowered(double x) { return Reference(x); }
inline Reference lowered(long double x) { return Reference(x); }
inline Reference lowered(const Reference& x) { return x; }
inline Reference lowered(const Decimal& x) { return Reference(x.str()); }
inline Reference lowered(const Pack& x) { return Reference(static_cast<double>(x[0])); }
inline Reference lowered(const Array& x) { return Reference(x[0]); }
inline Reference lowered(const AutoDiff& x) { return Reference(x.value()); }

template <class Scalar>
double epsilon() {
  return std::numeric_limits<double>::epsilon();
}
template <>
inline double epsilon<float>() {
  return static_cast<double>(std::numeric_limits<float>::epsilon());
}
template <>
inline double epsilon<long double>() {
  return static_cast<double>(std::numeric_limits<long double>::epsilon());
}
template <>
inline double epsilon<Decimal>() {
  return 1e-48;
}

template <>
inline Array made<Array>(double number) {
  return Array::Constant(number);
}

template <class Scalar>
void append(std::vector<Reference>& to, const Scalar& value) {
  to.push_back(lowered(value));
}
template <class Scalar, std::size_t Size>
void append(std::vector<Reference>& to, const std::array<Scalar, Size>& values) {
  for (const Scalar& value : values) to.push_back(lowered(value));
}

/// Prints and counts values that differ by more than rounding errors. Sums have up to some hundred
/// terms of the size of the largest entry, so the tolerance is 4000 epsilon times the largest
/// entry.
inline int failures = 0;
inline void compare(const char* what, const std::vector<Reference>& values,
                    const std::vector<Reference>& reference, double epsilon) {
  Reference scale = 1;
  for (const Reference& x : reference) scale = abs(x) > scale ? Reference(abs(x)) : scale;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const Reference error = abs(values[i] - reference[i]);
    if (error <= 4000 * epsilon * scale) continue;
    ++failures;
    std::printf("%s entry %zu is off by %g\n", what, i, static_cast<double>(error));
  }
}

struct Expected {
  int add, mul, div, sqrt, sincos, other;
};
inline void compare_counts(const char* what, const Expected& expected) {
  const Counts& c = counts;
  const auto angles = static_cast<int>(c.angles.size());
  if (c.add == expected.add && c.mul == expected.mul && c.div == expected.div &&
      c.sqrt == expected.sqrt && angles == expected.sincos && c.other == expected.other) {
    return;
  }
  ++failures;
  std::printf("%s executes %d %d %d %d %d %d\n", what, c.add, c.mul, c.div, c.sqrt, angles,
              c.other);
}

}  // namespace compiled
