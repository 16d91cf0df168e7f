// Sampled states: exact, random but the same in every process, inside the declared ranges.
#pragma once

#include <optional>
#include <vector>

#include "elgen/oracle.hpp"
#include "inspect/checks.hpp"

namespace elgen {

/// A number that vanishes at so many states vanishes: they are exact and random, one in 1e9 is a
/// coincidence.
constexpr unsigned zero_samples = 3;

/// Everything that moves as draw_motion() has it. Run-time parameters whose value is 0 are sampled
/// too: zero is a default there, not a property of the system.
[[nodiscard]] State sampled_state(const Inspected& subject, unsigned seed);

/// A state at which M has a value, and M there, row-major; empty where a few attempts found none.
struct MassSample {
  State state;
  std::vector<cln::cl_R> matrix;
};
[[nodiscard]] std::optional<MassSample> sampled_mass_matrix(const Inspected& subject,
                                                            unsigned seed);

}  // namespace elgen
