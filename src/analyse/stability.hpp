// Stability of a state of rest: by Lagrange and Dirichlet where energy decides, else by the poles.
#pragma once

#include <vector>

#include "elgen/analyse.hpp"

namespace elgen {

/// The conditions under which a strict minimum of W = V0 - T0 is stable: L is free of t, no force Q
/// acts, D is dissipative at the point.
struct RestConditions {
  bool is_conservative = false;
  std::size_t free_count = 0;  ///< coordinates that the equations at rest do not hold
  /// Coordinates alone in their equations along which K is exactly 0.
  std::vector<LeadingTerm> degenerate = {};
  std::vector<bool> is_positive = {};  ///< of the coefficients of `degenerate`
};

/// Whether W = V0 - T0 decides by Lagrange and Dirichlet: L is free of t, no force acts but D >= 0
/// and inputs whose B does not depend on q. `state`: parameters and inputs as they are.
[[nodiscard]] bool is_conservative(const Program& moving, const State& state);

[[nodiscard]] StabilityVerdict stability_of(const RestPoint& point,
                                            const RestConditions& conditions);

/// Whether a symmetric matrix without the rows and columns of `left_out` is positive definite: each
/// pivot in 64 digits is above 1e-25 of its diagonal entry, or of the entry in `usual`.
[[nodiscard]] bool is_positive_definite(const std::vector<cln::cl_R>& matrix,
                                        const std::vector<std::uint32_t>& left_out = {},
                                        const std::vector<cln::cl_R>& usual = {});

}  // namespace elgen
