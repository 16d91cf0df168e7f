// Agreement: when an exact number of the program and one of the oracle are the same.
#pragma once

#include "verify/bounds/oracle_cache.hpp"

namespace elgen {

/// A number in 64 digits with the B of its error bound.
struct Measured {
  Real value = {};
  Real bound = {};
};

/// To 50 digits of the bound. A number that is zero on paper has no bound worth the name: it is
/// rounding of `scale`, the largest magnitude met on the way. An undefined number agrees with none.
[[nodiscard]] bool agrees(const Measured& number, const Real& truth, const Real& scale);

/// The scale grows by what the oracle's own rounding is of: where the entry's does not do, by the
/// energy, and where that is not enough, by the forces, by the inertia, or by the motion.
[[nodiscard]] bool agrees_with_oracle(const Measured& number, const cln::cl_R& truth,
                                      const Real& scale, OracleCache& oracle);

/// "1.5", or "undefined".
[[nodiscard]] std::string short_text(const Real& value);

}  // namespace elgen
