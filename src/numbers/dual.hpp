// Dual: value + slope * epsilon with epsilon^2 = 0. A program evaluated on duals also gives the
// derivative along one direction, without a truncation error. Dual<Dual<Real>> gives second
// derivatives.
#pragma once

#include "elgen/leaves.hpp"
#include "elgen/real.hpp"

namespace elgen {

template <class Base>
struct Dual {
  Base value = Base();
  Base slope = Base();
};

template <class Base>
struct ScalarTraits<Dual<Base>> {
  [[nodiscard]] static Dual<Base> from_real(const cln::cl_R& value) {
    return {ScalarTraits<Base>::from_real(value), ScalarTraits<Base>::from_real(0)};
  }
};

template <class Base>
[[nodiscard]] Dual<Base> operator-(const Dual<Base>& x) {
  return {-x.value, -x.slope};
}
template <class Base>
[[nodiscard]] Dual<Base> operator+(const Dual<Base>& x, const Dual<Base>& y) {
  return {x.value + y.value, x.slope + y.slope};
}
template <class Base>
[[nodiscard]] Dual<Base> operator-(const Dual<Base>& x, const Dual<Base>& y) {
  return {x.value - y.value, x.slope - y.slope};
}
template <class Base>
[[nodiscard]] Dual<Base> operator*(const Dual<Base>& x, const Dual<Base>& y) {
  return {x.value * y.value, x.slope * y.value + x.value * y.slope};
}
template <class Base>
[[nodiscard]] Dual<Base> operator/(const Dual<Base>& x, const Dual<Base>& y) {
  const Base quotient = x.value / y.value;
  return {quotient, (x.slope - quotient * y.slope) / y.value};
}
template <class Base>
[[nodiscard]] Dual<Base> sqrt(const Dual<Base>& x) {
  using std::sqrt;
  const Base root = sqrt(x.value);
  return {root, x.slope / (root + root)};
}

/// Needed by function_derivatives.def, which multiplies derivatives by small integers.
[[nodiscard]] inline Real operator*(const Real& x, int factor) { return x * Real(factor); }
template <class Base>
[[nodiscard]] Dual<Base> operator*(const Dual<Base>& x, int factor) {
  return {x.value * factor, x.slope * factor};
}

/// If Base is a built-in floating type, its functions are in the namespace `interpreter`.
#define ELGEN_DUAL_1(name, first, second)                               \
  template <class Base>                                                 \
  [[nodiscard]] Dual<Base> name(const Dual<Base>& argument) {           \
    using namespace interpreter;                                        \
    using std::sqrt;                                                    \
    const Base& x = argument.value;                                     \
    const Base f = name(x);                                             \
    [[maybe_unused]] const Base one = ScalarTraits<Base>::from_real(1); \
    return {f, (first)*argument.slope};                                 \
  }
#define ELGEN_DUAL_2(name, first, second)                                          \
  template <class Base>                                                            \
  [[nodiscard]] Dual<Base> name(const Dual<Base>& left, const Dual<Base>& right) { \
    using namespace interpreter;                                                   \
    using std::sqrt;                                                               \
    const Base& x = left.value;                                                    \
    const Base& y = right.value;                                                   \
    const Base f = name(x, y);                                                     \
    [[maybe_unused]] const Base one = ScalarTraits<Base>::from_real(1);            \
    return {f, (first)*left.slope + (second)*right.slope};                         \
  }
#define ELGEN_DERIVATIVES(name, arity, first, second) ELGEN_DUAL_##arity(name, first, second)
#include "base/function_derivatives.def"
#undef ELGEN_DERIVATIVES
#undef ELGEN_DUAL_2
#undef ELGEN_DUAL_1

/// Leaves as duals: values from `point`, slopes from `direction`.
template <class Base>
[[nodiscard]] LeafValues<Dual<Base>> dual_leaves(const LeafValues<Base>& point,
                                                 const LeafValues<Base>& direction) {
  return map_leaves(
      [](const Base& value, const Base& slope) {
        return Dual<Base>{value, slope};
      },
      point, direction);
}

}  // namespace elgen
