// precision: the digits that a function may lose, at fixed points where sums cancel.
//
//     e/(|x| + K)     e its running error (evaluate/running_errors.hpp), K what the rounding of its
//                     inputs would cost whatever formula is taken (evaluate/conditioning.hpp)
//
// In exact arithmetic, so that every machine chooses the same.
#pragma once

#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/program.hpp"
#include "evaluate/conditioning.hpp"

namespace elgen {

using ExtremePoints = std::vector<Arguments<double>>;

/// The same on every machine: ordinary magnitudes; wide ones; and parameters of wide ratios, or one
/// far larger than the others, where the coordinates that sines are taken of are near multiples of
/// a right angle, nearly the same, or tiny.
[[nodiscard]] ExtremePoints extreme_points(const Program& program);

/// Of each entry the largest e/(|x| + K) over all points where it has a value; 0 where it is at
/// most tolerated_loss. Cost: an error per instruction and point; where digits are lost,
/// derivatives too.
[[nodiscard]] std::vector<double> possible_losses(const Program& program, const Function& function,
                                                  const ExtremePoints& points);

/// Whether one way loses so much more than another that it does not matter which is cheaper.
[[nodiscard]] bool loses_more(double loss, double other);

}  // namespace elgen
