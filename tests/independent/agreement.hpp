// Random states, and how far two oracles are apart there.
#pragma once

#include <string>

#include "independent/oracle.hpp"

namespace elgen::test {

/// Two programs in double differ by some roundings of the largest entry: 3e-15 is seen between KDL
/// and MuJoCo. A wrong term shows at 1e-3 or more.
inline constexpr double agreed = 1e-12;

/// MuJoCo's reader of URDF diagonalises inertias to 7 digits.
inline constexpr double agreed_of_urdf = 1e-6;

/// Largest difference of an entry, in units of the largest entry of `reference`.
[[nodiscard]] double relative_difference(const std::vector<double>& values,
                                         const std::vector<double>& reference);

/// The largest relative differences of two oracles over some states.
struct Differences {
  double mass_matrix = 0.0;
  double bias = 0.0;
  double torque = 0.0;
};
[[nodiscard]] Differences differences(const Oracle& oracle, const Oracle& reference,
                                      const std::vector<State>& states);

/// Angles over the circle, rates to 3 and accelerations to 5 in SI units; always the same states.
[[nodiscard]] std::vector<State> random_states(std::size_t joints, bool floating);

}  // namespace elgen::test
