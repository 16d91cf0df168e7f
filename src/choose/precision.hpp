// precision: the digits that a function may lose, at fixed points where sums cancel.
//
//     e/(|x| + K)     e its running error (evaluate/running_errors.hpp), K what the rounding of its
//                     inputs would cost whatever formula is taken (evaluate/conditioning.hpp), x
//                     the entry, or the largest entry of its field
//
// In exact arithmetic, so that every machine chooses the same.
#pragma once

#include <cstdint>
#include <vector>

#include "choose/points.hpp"
#include "elgen/program.hpp"
#include "evaluate/conditioning.hpp"

namespace elgen {

/// The same on every machine: ordinary and wide magnitudes; and where the coordinates that sines
/// are taken of are near multiples of a right angle, nearly the same, or tiny, with parameters of
/// wide ratios, or one far larger than the others.
[[nodiscard]] ComparisonPoints extreme_points(const Program& program);

/// The magnitude that errors are compared with.
enum class Scale : std::uint8_t {
  entry,  ///< the entry itself
  field,  ///< the largest entry of its field: one that vanishes among others may be noise
};

/// Of each entry the largest e/(|x| + K) over all points where it has a value; 0 where it is at
/// most tolerated_loss. Cost: an error per instruction and point; where digits are lost,
/// derivatives too.
[[nodiscard]] std::vector<double> possible_losses(const Program& program, const Function& function,
                                                  const ComparisonPoints& points,
                                                  Scale scale = Scale::entry);

/// By point, |x| of the scale for each entry. Cost: an error of each instruction and point.
using Magnitudes = std::vector<std::vector<double>>;
[[nodiscard]] Magnitudes magnitudes_of(const Program& program, const Function& function,
                                       const ComparisonPoints& points, Scale scale);

/// The same of a function that has one entry of another, whose magnitudes are `beside`, by point.
[[nodiscard]] double possible_loss(const Program& program, const Function& function,
                                   const ComparisonPoints& points,
                                   const std::vector<double>& beside);

/// Whether one way loses so much more than another, and more than `tolerated`, that it does not
/// matter which is cheaper.
[[nodiscard]] bool loses_more(double loss, double other, double tolerated = tolerated_loss);

}  // namespace elgen
