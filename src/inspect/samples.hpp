// Sampled states: exact random numbers inside the declared ranges, the same in every process.
#pragma once

#include <optional>
#include <vector>

#include "elgen/oracle.hpp"
#include "inspect/checks.hpp"

namespace elgen {

/// A quantity that is 0 at this many states counts as 0. The states are exact and random, so a
/// coincidence has a probability of about 1e-9.
constexpr unsigned zero_samples = 3;

/// A state by draw_motion(). Run-time parameters with the value 0 are drawn too, because 0 is often
/// a default and no property of the system.
[[nodiscard]] State sampled_state(const Inspected& subject, unsigned seed);

/// A state at which M has a value, and M there (row-major); none if a few attempts found no such
/// state.
struct MassSample {
  State state;
  std::vector<cln::cl_R> matrix;
};
[[nodiscard]] std::optional<MassSample> sampled_mass_matrix(const Inspected& subject,
                                                            unsigned seed);

}  // namespace elgen
