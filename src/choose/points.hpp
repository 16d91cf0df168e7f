// points: where rewritings of a function are compared: at most 66, the same for all its forms.
//
// States inside the ranges, with the parameters at their values; such with other parameters, equal
// ones of one unit multiplied by one factor, since what is equal may cancel; and states near the
// places where sums of the text vanish:
//
//     before    F*sqrt((x - a)^2 + y^2)
//     after     x near a and -a, x near 0, y near 0; both near 0; x near a and y near 0
//
// and at rest, where no rate, acceleration or input hides what a force loses; and far out, where
// exponentials and logarithms of coordinates without a range vanish or grow.
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

/// Whether it takes rates, momenta, accelerations or inputs.
[[nodiscard]] bool has_motion(const Function& function);

/// `text`: the recursive form of the function; `zeros` are approached where it takes no rates. No
/// function of libm is called, so that every machine gets the same points. Cost: one walk over the
/// instructions.
[[nodiscard]] Points comparison_points(const Program& program, const Function& text,
                                       const Domain& domain, const SumZeros& zeros = {});

/// A coordinate is near `factor` times another one, or near the number `factor`.
struct NearPlace {
  std::uint32_t coordinate = 0;
  double factor = 0;
  std::optional<std::uint32_t> other = {};
  friend bool operator==(const NearPlace&, const NearPlace&) = default;
};

using NearPlaces = std::vector<NearPlace>;

/// 0, where two terms of a sum cancel, and right angles, at the values that the parameters have in
/// the first state of `domain`, taken from the coordinates in turn. `most`: places of one
/// coordinate. Cost: one walk over `text`.
[[nodiscard]] NearPlaces cancelling_places(const Program& program, const Function& text,
                                           const Domain& domain, std::size_t most);

/// The zeros of the typed sums of all functions without rates, and of logarithms; a sum of squares
/// vanishes with all of its squares. Found by projecting some states on r = 0 for one square after
/// another, r the base: q - r grad r/|grad r|^2 (Kaczmarz), in 64 digits, so that every machine
/// finds the same. Cost: at most eight sums of a function and 30 rounds from seven states; none of
/// long programs.
[[nodiscard]] SumZeros sum_zeros(const Program& program, const Domain& domain);

}  // namespace elgen
