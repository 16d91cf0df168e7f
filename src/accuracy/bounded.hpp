// Bounds: numbers in 64 digits with the B of their error bounds u B, as a domain to fold programs
// in.
//
// Rules (first order, but for functions): leaf |x|; x +- y: Bx + By; x y: Bx By; x / y: (Bx + |x/y|
// By)/|y|; f(x): |f| + |f'| A + 1/2 u max|f''| A^2 with A = Bx, or 0 where the argument is exact
// (an input times +- a power of two). A result that may underflow adds eta/u.
#pragma once

#include "elgen/evaluate.hpp"
#include "numbers/dual.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {

/// The numbers of a scalar type that bounds depend on.
struct Rounding {
  Real roundoff;                            ///< u, half the epsilon
  Real underflow;                           ///< eta/u, eta the smallest denormal
  Real smallest;                            ///< normal number: below it eta counts
  Real largest;                             ///< finite number / 16: above it overflow is near
  Real (*nearest)(const cln::cl_R& value);  ///< number of the scalar
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

/// Up to sign; multiplying by it keeps the digits.
[[nodiscard]] bool is_power_of_two(const Real& x);

/// A leaf: B = |x|, and a rounding where it is not exact.
[[nodiscard]] Bound leaf_bound(const Real& value, bool exact);

/// A leaf, exact where it is a number of the scalar.
[[nodiscard]] Bound leaf_bound(const cln::cl_R& value, const Rounding& rounding);

/// The rules of fold.hpp.
struct BoundRules {
  const LeafValues<Bound>& leaves;
  const Rounding& rounding;

  /// Constants that are not binary count as rounded.
  [[nodiscard]] Bound constant(const Constant& constant) const {
    return leaf_bound(constant.value, rounding);
  }
  [[nodiscard]] Bound leaf(Opcode kind, std::uint32_t number) const {
    return leaf_of(leaves, kind, number);
  }
  [[nodiscard]] Bound negate(const Bound& x) const;
  [[nodiscard]] Bound add(const Bound& x, const Bound& y) const;
  [[nodiscard]] Bound subtract(const Bound& x, const Bound& y) const { return add(x, negate(y)); }
  [[nodiscard]] Bound multiply(const Bound& x, const Bound& y) const;
  [[nodiscard]] Bound divide(const Bound& x, const Bound& y) const;
  [[nodiscard]] Bound square_root(const Bound& x) const;
  [[nodiscard]] Bound call(FunctionId function, const Bound& x, const Bound& slot) const;
};

/// The rules of fold.hpp along what repeats itself, as steps do. B has every rounding, and no
/// roundings are counted: x + y: Bx + By + |x + y|; x y: |x| By + |y| Bx + u Bx By + |x y|; x / y:
/// |x/y| more than above. Where an iteration takes errors away this B stays, and every product
/// raises the one above to a power.
struct RunningBoundRules : BoundRules {
  [[nodiscard]] Bound add(const Bound& x, const Bound& y) const;
  [[nodiscard]] Bound subtract(const Bound& x, const Bound& y) const { return add(x, negate(y)); }
  [[nodiscard]] Bound multiply(const Bound& x, const Bound& y) const;
  [[nodiscard]] Bound divide(const Bound& x, const Bound& y) const;
};

}  // namespace elgen
