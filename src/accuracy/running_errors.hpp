// Running errors: a bound E on the rounding error of a value, in units of u, half the epsilon of a
// scalar type. Each instruction propagates the errors of its operands and adds one rounding:
//
//     leaf        |x|, or 0 if the scalar type can represent x
//     x +- y      Ex + Ey + |x +- y|, without |x +- y| for a difference of exact numbers within a
//                 factor of two
//     x y         Ex |y| + Ey |x| + u Ex Ey + |x y|, without |x y| if x or y is a power of two
//     x / y       (Ex + |x/y| Ey) / |y| + |x/y|
//     f(x)        |f'| Ex + |f|; for sine and cosine also u/2 Ex^2
//
// If a result is below the normal numbers, E grows by eta/u, with eta the smallest denormal. The
// formulas are the first-order errors of N. J. Higham, Accuracy and Stability of Numerical
// Algorithms, 2nd ed., section 3.3. Second-order terms are included where first-order terms vanish:
// at a zero of f', and in (x^2 - y^2)^2 at x = y.
//
// The template argument Number is Real, or double for rough errors. Rough errors are correct within
// a factor of two on every machine, as long as a value loses only its last digits.
#pragma once

#include "elgen/evaluate.hpp"
#include "numbers/dual.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {

/// The constants of a scalar type in the error formulas.
template <class Number>
struct RoundingConstants {
  Number roundoff;   ///< u
  Number underflow;  ///< eta/u
  Number smallest;   ///< the smallest normal number; a smaller result has the error eta
  Number largest;    ///< the largest finite number / 16; a larger value may overflow
  bool (*is_exact)(const cln::cl_R& value);  ///< true if the scalar can represent `value`
};

/// The constants of Scalar, double or float. If Number is double, Scalar must be double.
template <class Scalar, class Number = Real>
[[nodiscard]] const RoundingConstants<Number>& rounding_constants();

/// True for +-2^n with an integer n. Multiplying by such a number is exact.
[[nodiscard]] bool is_power_of_two(const Real& x);
[[nodiscard]] bool is_power_of_two(double x);

/// A value with its running error.
template <class Number>
struct RunningValue {
  Number value = {};
  Number error = {};        ///< E, in u; undefined if the value or a derivative is undefined
  bool is_lost = false;     ///< E is invalid: the divisor or argument of an operation is uncertain
  bool underflows = false;  ///< the value depends on a number below the normal numbers
};

template <class Number>
[[nodiscard]] std::vector<Number> values_of(const std::vector<RunningValue<Number>>& all) {
  std::vector<Number> values;
  values.reserve(all.size());
  for (const RunningValue<Number>& x : all) values.push_back(x.value);
  return values;
}

/// `value` with its running error as a leaf: 0 if the scalar can represent `value`, else |value|.
template <class Number>
[[nodiscard]] RunningValue<Number> running_leaf(const cln::cl_R& value,
                                                const RoundingConstants<Number>& rounding);

/// True if the rules replace f(x, y) by its limit for x -> +-infinity: for exponential functions at
/// |x| > 2^20. A finite limit then equals the value in 64 digits. A limit of 0 must not be used as
/// a divisor. For a function of one argument, `y` is x.
[[nodiscard]] bool is_replaced_by_limit(FunctionId function, const Real& x, const Real& y);

/// Whether leaves are exact or are rounded once. If q = 1e6 is rounded, q loses digits, and both
/// cos(q + 1) and cos(q)*cos(1) - sin(q)*sin(1) lose the same digits.
enum class LeafRounding : std::uint8_t { exact, rounded };

template <class Number>
[[nodiscard]] LeafValues<RunningValue<Number>> running_leaves(const Arguments<double>& point,
                                                              LeafRounding leaves);

/// Rules of fold.hpp that compute running errors.
template <class Number>
struct RunningErrorRules {
  using Value = RunningValue<Number>;

  LeafValues<Value> leaves;
  const RoundingConstants<Number>& rounding = elgen::rounding_constants<double, Number>();

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
  /// The value and error of f(x, y); functions of one argument ignore y. The error of a function
  /// with kinks is the larger error of x and y; `is_lost` is set for `sign` of an uncertain value.
  [[nodiscard]] Value call(FunctionId function, const Value& x, const Value& y) const;
};

}  // namespace elgen
