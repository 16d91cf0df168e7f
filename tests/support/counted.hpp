// A double that counts its operations, by the rules of the table in emitted headers.
#pragma once

#include <cmath>
#include <set>

namespace compiled {

/// The operations of one call, by the rules of the header's table.
struct Counts {
  int add = 0, mul = 0, div = 0, sqrt = 0, other = 0;
  std::set<double> angles = {};
};
inline Counts counts;

/// A double. Each operation on it is added to `counts`.
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
inline Counted asinh(Counted a) { return ++counts.other, Counted(std::asinh(a.x)); }
inline Counted tanh(Counted a) { return ++counts.other, Counted(std::tanh(a.x)); }
inline Counted exp(Counted a) { return ++counts.other, Counted(std::exp(a.x)); }
inline Counted log(Counted a) { return ++counts.other, Counted(std::log(a.x)); }
inline Counted abs(Counted a) { return ++counts.other, Counted(std::abs(a.x)); }
inline Counted atan2(Counted a, Counted b) { return ++counts.other, Counted(std::atan2(a.x, b.x)); }

}  // namespace compiled
