// zeros: which entries of a function vanish at all states, proved or at 64 random points.
#pragma once

#include "elgen/diff.hpp"
#include "elgen/program.hpp"

namespace elgen {

enum class Zero : std::uint8_t {
  no,
  sampled,  ///< |x| <= 1e-45 B at `zero_points` points, in 64 digits, B of its error bound u B
  proved,   ///< its closed form is the empty sum
};

/// Of every entry, in the order of the fields. Parameters that are `positive` (by their numbers)
/// are drawn so; the others at every second point, since most masses and lengths have to be. Cost:
/// the function once in 64 digits; what vanishes there is proved, or sampled 63 times more.
[[nodiscard]] std::vector<Zero> zeros(const Program& program, const Function& function,
                                      const std::vector<bool>& positive);

}  // namespace elgen
