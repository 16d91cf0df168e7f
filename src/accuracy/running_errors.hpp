// Running errors: how far rounding takes a value, in u, half the epsilon of a scalar type. Of each
// instruction the error is that of its operands, times how much the instruction makes of it, and
// one rounding:
//
//     leaf        |x|, or 0 where x is a number of the scalar
//     x +- y      Ex + Ey + |x +- y|
//     x y         Ex |y| + Ey |x| + u Ex Ey + |x y|, without the last where x or y is a power of
//     two x / y       (Ex + |x/y| Ey) / |y| + |x/y| f(x)        |f'| Ex + |f|; of sines and cosines
//     also u/2 Ex^2
//
// Beside that a result below the normal numbers is off by eta/u, eta the smallest denormal. This is
// the first order of N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., section
// 3.3, and the second where it is all that remains: at a zero of f', and in (x^2 - y^2)^2 at x = y.
//
// Number is Real, or double for a rough figure, right within a factor of two on every machine as
// long as nothing but the last digits of a value is lost.
#pragma once

#include "elgen/evaluate.hpp"
#include "numbers/dual.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {

/// The numbers of a scalar type that errors depend on.
template <class Number>
struct Rounding {
  Number roundoff;                           ///< u
  Number underflow;                          ///< eta/u
  Number smallest;                           ///< normal number: below it eta counts
  Number largest;                            ///< finite number / 16: above it overflow is near
  bool (*is_exact)(const cln::cl_R& value);  ///< whether the scalar has the value
};

/// Scalar: double or float, of which double alone has rough figures.
template <class Scalar, class Number = Real>
[[nodiscard]] const Rounding<Number>& rounding();

/// Up to sign; multiplying by it rounds nothing.
[[nodiscard]] bool is_power_of_two(const Real& x);
[[nodiscard]] bool is_power_of_two(double x);

/// A value with the error of its rounding.
template <class Number>
struct Running {
  Number value = {};
  Number error = {};     ///< E, in u; undefined where the value or a slope is
  bool is_lost = false;  ///< made of a quotient, root, function or sign of what is hardly known, so
                         ///< that E says nothing
  bool underflows = false;  ///< something it is made of is below the normal numbers
};

template <class Number>
[[nodiscard]] std::vector<Number> values_of(const std::vector<Running<Number>>& all) {
  std::vector<Number> values;
  values.reserve(all.size());
  for (const Running<Number>& x : all) values.push_back(x.value);
  return values;
}

/// A leaf: rounded once where the scalar does not have its value.
template <class Number>
[[nodiscard]] Running<Number> running_leaf(const cln::cl_R& value,
                                           const Rounding<Number>& rounding);

/// Whether the rules take the limit of a function for its value: of an exponential one if |x| >
/// 2^20, since 64 digits do not tell them apart. A limit of 0 is no divisor. `y`: x if there is
/// one argument.
[[nodiscard]] bool takes_limit(FunctionId function, const Real& x, const Real& y);

/// The leaves are given exactly, or each is rounded once, so that at an angle of 1e6 both cos(q +
/// 1) and cos(q)*cos(1) - sin(q)*sin(1) have as few digits as the angle itself.
enum class Leaves : std::uint8_t { exact, rounded };

template <class Number>
[[nodiscard]] LeafValues<Running<Number>> running_leaves(const Arguments<double>& point,
                                                         Leaves leaves);

/// The rules of fold.hpp.
template <class Number>
struct RunningErrorRules {
  using Value = Running<Number>;

  LeafValues<Value> leaves;
  const Rounding<Number>& rounding = elgen::rounding<double, Number>();

  [[nodiscard]] Value constant(const Constant& constant) const {
    return running_leaf(constant.value, rounding);
  }
  [[nodiscard]] Value leaf(Opcode kind, std::uint32_t number) const {
    return leaf_of(leaves, kind, number);
  }
  [[nodiscard]] Value negate(Value x) const {
    x.value = -x.value;
    return x;
  }
  [[nodiscard]] Value add(const Value& x, const Value& y) const;
  [[nodiscard]] Value subtract(const Value& x, const Value& y) const { return add(x, negate(y)); }
  [[nodiscard]] Value multiply(const Value& x, const Value& y) const;
  [[nodiscard]] Value divide(const Value& x, const Value& y) const;
  [[nodiscard]] Value square_root(const Value& x) const;
  /// Kinked functions pass an operand on; the sign of what is hardly known is lost. Functions of
  /// one argument ignore y.
  [[nodiscard]] Value call(FunctionId function, const Value& x, const Value& y) const;
};

}  // namespace elgen
