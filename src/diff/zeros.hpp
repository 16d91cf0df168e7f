// zeros: which entries of a function vanish at all states, by proof or by points.
#pragma once

#include "elgen/evaluate.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// A value vanishes at a point where |x| <= 1e-45 E in 64 digits, E the running error of x.
enum class Zero : std::uint8_t {
  no,
  not_decided,  ///< no point shows another value, but it is not analytic, or vanishes at fewer than
                ///< `zero_points`: another point may tell
  sampled,      ///< analytic (program/network/analytic.hpp), and vanishes at `zero_points` points
  proved,       ///< its closed form is the empty sum
};

/// One verdict per entry, in the order of the fields. Cost: the function once in 64 digits. Values
/// that vanish there are proved, or sampled 63 times more; twice that and in `states` if they are
/// not analytic.
[[nodiscard]] std::vector<Zero> zeros(const Program& program, const Function& function,
                                      const std::vector<Arguments<double>>& states = {});

/// Whether the only entry vanishes at a state, whatever its terms are in doubles.
[[nodiscard]] bool vanishes_at(const Program& program, const Function& function,
                               const Arguments<double>& state);

}  // namespace elgen
