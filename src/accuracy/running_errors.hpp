// Running errors: a bound E on the rounding errors of a value, in u, half the epsilon of a scalar
// type. Each instruction propagates the errors of its operands and adds one rounding:
//
//     leaf        |x|, or 0 if x is a number of the scalar
//     x +- y      Ex + Ey + |x +- y|
//     x y         Ex |y| + Ey |x| + u Ex Ey + |x y|, without |x y| if x or y is a power of two
//     x / y       (Ex + |x/y| Ey) / |y| + |x/y|
//     f(x)        |f'| Ex + |f|; for sine and cosine also u/2 Ex^2
//
// A result below the normal numbers adds eta/u, eta the smallest denormal. This is the first order
// of N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., section 3.3. The second
// order is added if it is all that remains: at a zero of f', and in (x^2 - y^2)^2 at x = y.
//
// Number is Real, or double for a rough figure. It is right within a factor of two on every
// machine, as long as a value loses only its last digits.
#pragma once

#include "elgen/evaluate.hpp"
#include "numbers/dual.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {

/// The constants of a scalar type in the error formulas.
template <class Number>
struct Rounding {
  Number roundoff;   ///< u
  Number underflow;  ///< eta/u
  Number smallest;   ///< the smallest normal number; below it eta counts
  Number largest;    ///< the largest finite number / 16; above it overflow is near
  bool (*is_exact)(const cln::cl_R& value);  ///< true if the scalar can represent it
};

/// Scalar: double or float; rough figures exist for double only.
template <class Scalar, class Number = Real>
[[nodiscard]] const Rounding<Number>& rounding();

/// Up to sign. Multiplying by a power of two is exact.
[[nodiscard]] bool is_power_of_two(const Real& x);
[[nodiscard]] bool is_power_of_two(double x);

/// A value with its running error.
template <class Number>
struct Running {
  Number value = {};
  Number error = {};        ///< E, in u; undefined if the value or a slope is
  bool is_lost = false;     ///< E is void: a quotient, root, function or sign of an uncertain value
  bool underflows = false;  ///< it depends on a value below the normal numbers
};

template <class Number>
[[nodiscard]] std::vector<Number> values_of(const std::vector<Running<Number>>& all) {
  std::vector<Number> values;
  values.reserve(all.size());
  for (const Running<Number>& x : all) values.push_back(x.value);
  return values;
}

/// A leaf, rounded once if the scalar cannot represent its value.
template <class Number>
[[nodiscard]] Running<Number> running_leaf(const cln::cl_R& value,
                                           const Rounding<Number>& rounding);

/// True if the rules replace a value by its limit: exponential functions at |x| > 2^20, because 64
/// digits do not distinguish them. A limit of 0 must not be a divisor. `y`: x if there is one
/// argument.
[[nodiscard]] bool takes_limit(FunctionId function, const Real& x, const Real& y);

/// Leaves are exact, or each is rounded once. Then cos(q + 1) and cos(q)*cos(1) - sin(q)*sin(1) at
/// an angle of 1e6 have as few digits as the angle.
enum class Leaves : std::uint8_t { exact, rounded };

template <class Number>
[[nodiscard]] LeafValues<Running<Number>> running_leaves(const Arguments<double>& point,
                                                         Leaves leaves);

/// Rules of fold.hpp that compute running errors.
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
  /// Kinked functions pass on the larger error of their operands; the sign of an uncertain value is
  /// lost. Functions of one argument ignore y.
  [[nodiscard]] Value call(FunctionId function, const Value& x, const Value& y) const;
};

}  // namespace elgen
