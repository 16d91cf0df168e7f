// What a generated driver needs to call every function of emitted headers with every scalar type:
// values of a fixed state, calls that find out their own arguments, a scalar that counts.
#pragma once

#include <Eigen/Core>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>
#include <cstdio>
#include <experimental/simd>
#include <limits>
#include <set>
#include <unsupported/Eigen/AutoDiff>
#include <vector>

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

/// What one call executed, by the rules of the header's table.
struct Counts {
  int add = 0, mul = 0, div = 0, sqrt = 0, other = 0;
  std::set<double> angles = {};
};
inline Counts counts;

/// A double that counts what is done with it.
struct Counted {
  using value_type = double;
  double x = 0;
  Counted() = default;
  Counted(double value) : x(value) {}
};
inline Counted operator+(Counted a, Counted b) { return ++counts.add, Counted(a.x + b.x); }
inline Counted operator-(Counted a, Counted b) { return ++counts.add, Counted(a.x - b.x); }
inline Counted operator*(Counted a, Counted b) { return ++counts.mul, Counted(a.x * b.x); }
inline Counted operator/(Counted a, Counted b) { return ++counts.div, Counted(a.x / b.x); }
inline Counted operator-(Counted a) { return Counted(-a.x); }
inline bool operator<(Counted a, Counted b) { return a.x < b.x; }
inline bool operator>(Counted a, Counted b) { return a.x > b.x; }
inline Counted sin(Counted a) { return counts.angles.insert(a.x), Counted(std::sin(a.x)); }
inline Counted cos(Counted a) { return counts.angles.insert(a.x), Counted(std::cos(a.x)); }
inline Counted sqrt(Counted a) { return ++counts.sqrt, Counted(std::sqrt(a.x)); }
inline Counted tan(Counted a) { return ++counts.other, Counted(std::tan(a.x)); }
inline Counted asin(Counted a) { return ++counts.other, Counted(std::asin(a.x)); }
inline Counted acos(Counted a) { return ++counts.other, Counted(std::acos(a.x)); }
inline Counted atan(Counted a) { return ++counts.other, Counted(std::atan(a.x)); }
inline Counted sinh(Counted a) { return ++counts.other, Counted(std::sinh(a.x)); }
inline Counted cosh(Counted a) { return ++counts.other, Counted(std::cosh(a.x)); }
inline Counted tanh(Counted a) { return ++counts.other, Counted(std::tanh(a.x)); }
inline Counted exp(Counted a) { return ++counts.other, Counted(std::exp(a.x)); }
inline Counted log(Counted a) { return ++counts.other, Counted(std::log(a.x)); }
inline Counted abs(Counted a) { return ++counts.other, Counted(std::abs(a.x)); }
inline Counted atan2(Counted a, Counted b) { return ++counts.other, Counted(std::atan2(a.x, b.x)); }

/// `number` in every component: dyadic, so that all types hold the same value.
template <class Scalar>
Scalar made(double number) {
  Scalar result;
  result = static_cast<Scalar>(number);
  return result;
}
template <>
inline Array made<Array>(double number) {
  return Array::Constant(number);
}

/// start, start + 11/64, …: no two entries, sums or differences of the state are equal.
template <class Scalar, std::size_t Size>
std::array<Scalar, Size> state(double start) {
  std::array<Scalar, Size> result{};
  double number = start;
  for (Scalar& entry : result) {
    entry = made<Scalar>(number);
    number += 11.0 / 64.0 + number / 1024.0;
  }
  return result;
}

/// The arguments of all functions: each takes as many of them as it wants.
template <class Parameters, class Coordinates, class Velocities, class Inputs, class Scalar>
struct Arguments {
  Parameters p;
  Coordinates q;
  Velocities v, a;
  Inputs u;
  Scalar t;
};

template <class Function, class All>
auto call(const Function& f, const All& x) {
  const auto& [p, q, v, a, u, t] = x;
  using P = decltype(p);
  using Q = decltype(q);
  using V = decltype(v);
  using U = decltype(u);
  using T = decltype(t);
  if constexpr (std::is_invocable_v<Function, P, Q>) {
    return f(p, q);
  } else if constexpr (std::is_invocable_v<Function, P, Q, V>) {
    return f(p, q, v);
  } else if constexpr (std::is_invocable_v<Function, P, Q, V, V>) {
    return f(p, q, v, a);
  } else if constexpr (std::is_invocable_v<Function, P, Q, V, U>) {
    return f(p, q, v, u);
  } else if constexpr (std::is_invocable_v<Function, P, Q, T>) {
    return f(p, q, t);
  } else if constexpr (std::is_invocable_v<Function, P, Q, V, T>) {
    return f(p, q, v, t);
  } else if constexpr (std::is_invocable_v<Function, P, Q, V, V, T>) {
    return f(p, q, v, a, t);
  } else {
    return f(p, q, v, u, t);
  }
}

template <class Scalar>
void append(std::vector<Reference>& to, const Scalar& value) {
  to.push_back(lowered(value));
}
template <class Scalar, std::size_t Size>
void append(std::vector<Reference>& to, const std::array<Scalar, Size>& values) {
  for (const Scalar& value : values) to.push_back(lowered(value));
}

/// Prints a line and counts a failure where values differ by more than the type's rounding can
/// make: the sums have up to some hundred terms of the size of the largest entry, hence 4000
/// epsilon of it.
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
