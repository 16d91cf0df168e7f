// Stability of a state of rest: by Lagrange and Dirichlet if energy decides, else by poles.
#pragma once

#include <vector>

#include "elgen/analyse.hpp"

namespace elgen {

/// The conditions under which a strict minimum of W = V0 - T0 is stable: L is free of t, no force Q
/// acts, and D is dissipative at the point.
struct RestConditions {
  bool is_conservative = false;
  std::size_t free_count = 0;  ///< coordinates in no equation at rest
  /// Coordinates that are alone in their equations and have K exactly 0.
  std::vector<LeadingTerm> degenerate = {};
  std::vector<bool> is_positive = {};  ///< of the coefficients of `degenerate`
};

/// Whether W = V0 - T0 decides by Lagrange and Dirichlet: L is free of t, and the only forces are D
/// >= 0 and inputs whose B does not depend on q. `state` has the parameters and inputs.
[[nodiscard]] bool is_conservative(const Program& moving, const State& state);

[[nodiscard]] StabilityVerdict stability_of(const RestPoint& point,
                                            const RestConditions& conditions);

/// Whether a symmetric matrix without the rows and columns of `left_out` is positive definite: each
/// pivot in 64 digits exceeds 1e-25 of its diagonal entry, or of that in `usual`.
[[nodiscard]] bool is_positive_definite(const std::vector<cln::cl_R>& matrix,
                                        const std::vector<std::uint32_t>& left_out = {},
                                        const std::vector<cln::cl_R>& usual = {});

}  // namespace elgen
