// The interpreter: a Function on numbers of any scalar type, one instruction after another.
//
// Cost: one operation of Scalar per instruction. Scalar needs + - * / unary minus, construction by
// ScalarTraits<Scalar>::from_real, and the functions of functions.def by argument-dependent lookup.
#pragma once

#include <cmath>
#include <vector>

#include "elgen/fold.hpp"
#include "elgen/leaves.hpp"

namespace elgen {

template <class Scalar>
using Arguments = LeafValues<Scalar>;

/// How a scalar type is made from an exact number; specialised for float, double, long double,
/// cl_F, …
template <class Scalar>
struct ScalarTraits;

/// Correctly rounded to the nearest binary value.
template <>
struct ScalarTraits<float> {
  [[nodiscard]] static float from_real(const cln::cl_R& value);
};
template <>
struct ScalarTraits<double> {
  [[nodiscard]] static double from_real(const cln::cl_R& value);
};
template <>
struct ScalarTraits<long double> {
  [[nodiscard]] static long double from_real(const cln::cl_R& value);
};

}  // namespace elgen

#include "elgen/evaluate_impl.hpp"
