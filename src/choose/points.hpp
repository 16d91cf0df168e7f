// points: at most 66 states at which all forms of a function are compared.
//
// They include states inside the ranges with parameters at their values; states with parameters
// scaled, equal ones of one unit by one factor, since they may cancel; and states near zeros of
// sums in the text:
//
//     before    F*sqrt((x - a)^2 + y^2)
//     after     x near a and -a, x near 0, y near 0; both near 0; x near a and y near 0
//
// There are states at rest too, where no rate, acceleration or input hides losses of a force, and
// remote ones, where exponentials and logarithms of unbounded coordinates vanish or grow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "elgen/choose.hpp"
#include "elgen/domain.hpp"
#include "elgen/program.hpp"
#include "sample/points.hpp"

namespace elgen {

/// Whether a function takes rates, momenta, reference velocities, accelerations or inputs.
[[nodiscard]] bool has_motion(const Function& function);

/// `text` is the recursive form of the function. If it takes no rates, `zeros` are approached. No
/// function of libm is called, so that all machines get the same points. Cost: one walk over the
/// instructions.
[[nodiscard]] Points comparison_points(const Program& program, const Function& text,
                                       const Domain& domain, const SumZeros& zeros = {});

/// A coordinate near `factor` times another one, or near the number `factor`.
struct NearPlace {
  std::uint32_t coordinate = 0;
  double factor = 0;
  std::optional<std::uint32_t> other = {};
  friend bool operator==(const NearPlace&, const NearPlace&) = default;
};

using NearPlaces = std::vector<NearPlace>;

/// 0, zeros where two terms of a sum cancel, and right angles, with the parameters of the first
/// state of `domain`, taken from the coordinates in turn. `most` limits the places of a coordinate.
/// Cost: one walk over `text`.
[[nodiscard]] NearPlaces cancelling_places(const Program& program, const Function& text,
                                           const Domain& domain, std::size_t most);

/// The zeros of logarithms and of typed sums, in all functions without rates. A sum of squares
/// vanishes if all its squares do. States are projected on r = 0 for one base r of a square after
/// another: q - r grad r/|grad r|^2 (Kaczmarz), in 64 digits, so that all machines find the same
/// zeros. Cost: at most eight sums of a function and 30 rounds from seven states; nothing for long
/// programs.
[[nodiscard]] SumZeros sum_zeros(const Program& program, const Domain& domain);

}  // namespace elgen
