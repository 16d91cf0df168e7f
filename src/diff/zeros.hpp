// zeros: the entries of a function that vanish at all states, by proof or at sampled points.
#pragma once

#include "elgen/evaluate.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// A value vanishes at a point if |x| <= 1e-45 E in 64 digits, E the running error of x.
enum class Zero : std::uint8_t {
  no,
  not_decided,  ///< no point shows another value, but it is not analytic, or vanishes at fewer than
                ///< `zero_sample_count`: another point may differ
  sampled,  ///< analytic (program/network/analytic.hpp), and vanishes at `zero_sample_count` points
  proved,   ///< its closed form is the empty sum
};

/// One verdict per entry, in the order of the fields. Cost: one evaluation in 64 digits. Entries
/// that vanish in it are proved, or sampled at 63 more points; twice, and also at `states`, if they
/// are not analytic.
[[nodiscard]] std::vector<Zero> zeros(const Program& program, const Function& function,
                                      const std::vector<Arguments<double>>& states = {});

/// True if the only entry vanishes at a state in 64 digits, even if doubles give another value.
[[nodiscard]] bool vanishes_at(const Program& program, const Function& function,
                               const Arguments<double>& state);

}  // namespace elgen
