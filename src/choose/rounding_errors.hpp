// rounding_errors: two ways to write one value, compared by how far rounding may take them.
//
//     2*a*(x + y) + b*z - a*(2*x + y)     has two terms more that cancel,   2 a x: where they are
//     a*y + b*z                           large, no digit of the first way is right
//
// Of each instruction the error is that of its operands, times how much the instruction makes of
// it, and one rounding: its magnitude. That is the running error to first order, in u. A term that
// cancels shows where it outweighs all others, so every leaf has a magnitude of its own.
#pragma once

#include <vector>

#include "elgen/leaf_names.hpp"
#include "evaluate/running_errors.hpp"
#include "lower/graph/rebuild.hpp"

namespace elgen {

/// Where ways are compared.
using MixedPoints = std::vector<Arguments<double>>;

/// The same on every machine: a quarter of ordinary magnitudes, the others from 2^-26 to 2^26, as
/// wide as what programs are checked at. Parameters are positive, as most masses and lengths have
/// to be.
[[nodiscard]] MixedPoints mixed_points(const LeafNames& leaves);

/// Whether, wherever `reference` has a value x, the error of `way` is at most three times that of
/// `reference`, or at most 8 |x|, which no judge refuses; false where it has none at any point. One
/// and the same sum counts up to twice as much when it is put together in another way; what cancels
/// is beyond any factor.
[[nodiscard]] bool is_as_precise(const Expressions& way, const Expressions& reference,
                                 const MixedPoints& points, Leaves leaves);

}  // namespace elgen
