// Bounded: a number in 64 digits with the B of its error bound u B, as a scalar to run programs on.
//
// Rules (first order, but for functions): leaf |x|; x +- y: Bx + By; x y: Bx By; x / y: (Bx + |x/y|
// By)/|y|; f(x): |f| + |f'| A + 1/2 u max|f''| A^2 with A = Bx, or 0 where the argument is exact
// (an input times +- a power of two). What may underflow adds eta/u.
#pragma once

#include "base/exact_number.hpp"
#include "evaluate/dual.hpp"

namespace elgen {

/// The numbers of a scalar type that bounds depend on.
struct Rounding {
  Real roundoff;   ///< u, half the epsilon
  Real underflow;  ///< eta/u, eta the smallest denormal
  Real smallest;   ///< normal number: below it eta counts
  Real largest;    ///< finite number / 16: above it overflow is near
};

/// Scalar: double or float.
template <class Scalar>
[[nodiscard]] const Rounding& rounding();

struct Bound {
  Real value = {};
  Real bound = {};              ///< B
  bool exact = true;            ///< representable and without error
  bool lost = false;            ///< divided by, or rooted, what is uncertain by more than a tenth
  std::uint32_t roundings = 0;  ///< relative errors of u, in first order, that may meet in it
  bool underflows = false;      ///< something it is made of is below the normal numbers
};

/// Bound whose rounding is Scalar's.
template <class Scalar>
struct Bounded : Bound {};

/// Up to sign; multiplying by it keeps the digits.
[[nodiscard]] bool is_power_of_two(const Real& x);

/// A leaf: B = |x|, and a rounding where it is not exact.
[[nodiscard]] Bound leaf_bound(const Real& value, bool exact);
[[nodiscard]] Bound negated(const Bound& x);
[[nodiscard]] Bound sum(const Bound& x, const Bound& y, const Rounding& rounding);
[[nodiscard]] Bound product(const Bound& x, const Bound& y, const Rounding& rounding);
[[nodiscard]] Bound quotient(const Bound& x, const Bound& y, const Rounding& rounding);
[[nodiscard]] Bound root(const Bound& x, const Rounding& rounding);
/// Any function of the table; y is ignored by those of one argument.
[[nodiscard]] Bound function_bound(FunctionId function, const Bound& x, const Bound& y,
                                   const Rounding& rounding);

template <class Scalar>
[[nodiscard]] Bounded<Scalar> operator-(const Bounded<Scalar>& x) {
  return {negated(x)};
}
template <class Scalar>
[[nodiscard]] Bounded<Scalar> operator+(const Bounded<Scalar>& x, const Bounded<Scalar>& y) {
  return {sum(x, y, rounding<Scalar>())};
}
template <class Scalar>
[[nodiscard]] Bounded<Scalar> operator-(const Bounded<Scalar>& x, const Bounded<Scalar>& y) {
  return {sum(x, negated(y), rounding<Scalar>())};
}
template <class Scalar>
[[nodiscard]] Bounded<Scalar> operator*(const Bounded<Scalar>& x, const Bounded<Scalar>& y) {
  return {product(x, y, rounding<Scalar>())};
}
template <class Scalar>
[[nodiscard]] Bounded<Scalar> operator/(const Bounded<Scalar>& x, const Bounded<Scalar>& y) {
  return {quotient(x, y, rounding<Scalar>())};
}
template <class Scalar>
[[nodiscard]] Bounded<Scalar> sqrt(const Bounded<Scalar>& x) {
  return {root(x, rounding<Scalar>())};
}

#define ELGEN_BOUNDED_1(name)                                            \
  template <class Scalar>                                                \
  [[nodiscard]] Bounded<Scalar> name(const Bounded<Scalar>& x) {         \
    return {function_bound(FunctionId::name, x, x, rounding<Scalar>())}; \
  }
#define ELGEN_BOUNDED_2(name)                                                              \
  template <class Scalar>                                                                  \
  [[nodiscard]] Bounded<Scalar> name(const Bounded<Scalar>& x, const Bounded<Scalar>& y) { \
    return {function_bound(FunctionId::name, x, y, rounding<Scalar>())};                   \
  }
#define ELGEN_FUNCTION(name, arity, use, parity, first, second) ELGEN_BOUNDED_##arity(name)
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
#undef ELGEN_BOUNDED_2
#undef ELGEN_BOUNDED_1

/// Inputs come as binary numbers and are exact; constants that are not binary count as rounded.
template <class Scalar>
struct ScalarTraits<Bounded<Scalar>> {
  [[nodiscard]] static Bounded<Scalar> from_real(const cln::cl_R& value) {
    const Real number(value);
    const Scalar rounded = ScalarTraits<Scalar>::from_real(value);
    const Real difference = number - Real(widened(rounded));
    return {leaf_bound(number, difference.is_defined() && cln::zerop(difference.value()))};
  }

 private:
  static cln::cl_R widened(Scalar x) { return exact_value(static_cast<double>(x)); }
};

}  // namespace elgen
