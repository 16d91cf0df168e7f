// Random states, and the largest differences between two oracles at these states.
#pragma once

#include <string>

#include "independent/oracle.hpp"

namespace elgen::test {

/// Two programs in double differ by a few rounding errors of the largest entry: KDL and MuJoCo by
/// 3e-15. A wrong term differs by 1e-3 or more.
inline constexpr double agreement_tolerance = 1e-12;

/// MuJoCo's URDF reader diagonalises inertias to 7 digits.
inline constexpr double urdf_agreement_tolerance = 1e-6;

/// max |values_i - reference_i| / max |reference_i|.
[[nodiscard]] double relative_difference(const std::vector<double>& values,
                                         const std::vector<double>& reference);

/// The largest relative differences between two oracles over a set of states.
struct Differences {
  double mass_matrix = 0.0;
  double bias = 0.0;
  double torque = 0.0;
};
[[nodiscard]] Differences differences(const Oracle& oracle, const Oracle& reference,
                                      const std::vector<State>& states);

/// Random states from a fixed seed: angles within one turn, |v_i| <= 3, |a_i| <= 5, in SI units.
[[nodiscard]] std::vector<State> random_states(std::size_t joints, bool floating);

}  // namespace elgen::test
