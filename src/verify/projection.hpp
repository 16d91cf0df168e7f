// Projections: one exact number per output and state, contracted with random rational directions,
// that program and oracle both give at small cost.
#pragma once

#include <string>

#include "base/random.hpp"
#include "oracle_cache.hpp"
#include "own_bound.hpp"

namespace elgen {

/// A function of the program at one state.
struct FunctionRun {
  const Function& function;
  BoundedRun exact;
};

/// Empty where the contraction of the exact entries is the oracle's, to 50 digits of sum |w_i y_j|
/// B_ij, or where the oracle has none; otherwise both numbers. The program may be undefined.
///
///     every field:       w.x, w.X y
///     forward_dynamics:  w.(M a + bias) = w.B u; and each relative pivot
[[nodiscard]] std::string compare_projection(const Subject& subject, const FunctionRun& run,
                                             OracleCache& oracle, Random& random);

}  // namespace elgen
