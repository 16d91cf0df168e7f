// zeros: decides by proof or by sampling which entries of a function vanish at all states.
#pragma once

#include "elgen/evaluate.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// An entry x vanishes at a point if |x| <= 1e-45 E in 64 digits; E is the running error of x.
enum class ZeroVerdict : std::uint8_t {
  nonzero,
  undecided,  ///< no computed value differs from 0, but neither `sampled` nor `proved` applies
  sampled,    ///< vanishes at `zero_sample_count` points; functions that are not analytic
              ///< (program/network/analytic.hpp) are random variables there
  proved,     ///< the closed form is the empty sum
};

/// The verdict on each entry, in the order of the fields. Cost: one evaluation at a random point in
/// 64 digits, and a proof for each entry that may vanish at this point. Entries whose proof is
/// undecided are evaluated at `zero_sample_count` more points. If one of these entries is not
/// analytic, all of them are evaluated at `states` and at `zero_sample_count` further points.
[[nodiscard]] std::vector<ZeroVerdict> decide_zeros(
    const Program& program, const Function& function,
    const std::vector<Arguments<double>>& states = {});

/// True if the function's only entry vanishes at a state in 64 digits, even if doubles give another
/// value.
[[nodiscard]] bool vanishes_at(const Program& program, const Function& function,
                               const Arguments<double>& state);

}  // namespace elgen
