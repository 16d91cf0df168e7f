// points: the states, at most 138, at which all forms of a function are compared.
//
// Some states are inside the ranges with nominal parameters. Others have parameters from their
// declared bounds, or scaled parameters. Others are near zeros of sums in the recursive form, the
// `text`:
//
//     before    F*sqrt((x - a)^2 + y^2)
//     after     x near a and -a, x near 0, y near 0; both near 0; x near a and y near 0
//
// At states of rest, no rate, acceleration or input hides losses of a force. At minima of V, all
// terms of a force vanish together. At remote states, coordinates without a range are large. Small
// solutions (is_small_solution) have most states a second time, with other parameters.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "elgen/choose.hpp"
#include "elgen/domain.hpp"
#include "elgen/program.hpp"
#include "forms/write/remainders.hpp"
#include "sample/points.hpp"

namespace elgen {

/// True if a function depends on rates, momenta, reference velocities, accelerations or inputs.
[[nodiscard]] bool depends_on_motion(const Function& function);

/// True for forward dynamics of two or three velocities without constraints.
[[nodiscard]] bool is_small_solution(const Program& program, const Function& function);

/// The points at which all forms of a function are compared. `text` is the recursive form. Unless
/// depends_on_motion(text), points near `zeros` are added. Each of domain.minima gives four points
/// at rest: one at the minimum, and three near it. Coordinates are computed without libm, so that
/// all machines get the same points. Cost: one pass over the instructions.
[[nodiscard]] Points comparison_points(const Program& program, const Function& text,
                                       const Domain& domain, const SumZeros& zeros = {});

/// A coordinate near `factor` times the coordinate `other`, or, without `other`, near the number
/// `factor`.
struct NearPlace {
  std::uint32_t coordinate = 0;
  double factor = 0;
  std::optional<std::uint32_t> other = {};
  friend bool operator==(const NearPlace&, const NearPlace&) = default;
};

using NearPlaces = std::vector<NearPlace>;

/// Places near 0, near zeros at which two terms of a sum cancel, and near multiples of pi/2: first
/// one place of each coordinate, then a second place of each, and so on; at most `most` in total.
/// Parameters have the values of the first state of `domain`. Cost: one pass over `text`.
[[nodiscard]] NearPlaces cancelling_places(const Program& program, const Function& text,
                                           const Domain& domain, std::size_t most);

/// The minima of `domain` with exact values: 0, parameters with the unit of the coordinate, their
/// halves, doubles and sums of two, multiples of pi/2, and rational numbers with small numerators
/// and denominators. Coordinates with other values may have any value. Several values may equal a
/// coordinate at a minimum, so there may be more places than minima.
[[nodiscard]] std::vector<ExactPlace> exact_places(const Domain& domain);

/// The coordinates that `function` loads, in the order of its instructions.
[[nodiscard]] std::vector<std::uint32_t> coordinates_of(const Function& function);

/// The zeros of logarithms and of typed sums, in all functions without rates. A sum of squares
/// vanishes if all its squares do. For the base r of each square in turn, a state q is projected
/// onto r = 0: q - r grad r/|grad r|^2 (Kaczmarz). All computations have 64 digits, so that all
/// machines find the same zeros. Cost: per function at most eight sums, with 30 rounds from each
/// start; nothing for long functions.
[[nodiscard]] SumZeros find_sum_zeros(const Program& program, const Domain& domain);

}  // namespace elgen
