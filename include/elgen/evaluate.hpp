// The interpreter: a Function on numbers of any scalar type, one instruction after another.
//
// Cost: one operation of Scalar per instruction. Scalar needs + - * / unary minus, construction by
// ScalarTraits<Scalar>::from_real, and the functions of functions.def by argument-dependent lookup.
#pragma once

#include <cmath>
#include <vector>

#include "elgen/fold.hpp"
#include "elgen/leaves.hpp"
#include "elgen/real.hpp"

namespace elgen {

template <class Scalar>
using Arguments = LeafValues<Scalar>;

}  // namespace elgen

#include "elgen/evaluate_impl.hpp"
