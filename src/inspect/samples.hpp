// Sampled states: exact random states inside the declared ranges, the same in every process.
#pragma once

#include <optional>
#include <vector>

#include "elgen/oracle.hpp"
#include "inspect/checks.hpp"

namespace elgen {

/// The number of states at which a quantity must be 0 to count as identically 0. The states are
/// exact and random, so the probability of a coincidence is about 1e-9.
constexpr unsigned zero_sample_count = 3;

/// A state with leaves from draw_motion(). Parameters that are not fixed and have the value 0 are
/// random too, because 0 is often only a default.
[[nodiscard]] State sample_state(const InspectedModel& subject, unsigned seed);

/// A state and the value of M at this state (row-major). None if a few attempts find no state at
/// which M has a value that more digits confirm.
struct MassSample {
  State state;
  std::vector<cln::cl_R> matrix;
};
[[nodiscard]] std::optional<MassSample> sample_mass_matrix(const InspectedModel& subject,
                                                           unsigned seed);

}  // namespace elgen
