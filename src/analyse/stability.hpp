// Stability of an equilibrium: by the theorem of Lagrange and Dirichlet if it applies, else by
// poles.
#pragma once

#include <vector>

#include "elgen/analyse.hpp"

namespace elgen {

/// The premises of the theorem of Lagrange and Dirichlet: if is_conservative() holds, a strict
/// minimum of W = V0 - T0 is stable.
struct LagrangeDirichletPremises {
  bool is_conservative = false;
  std::size_t free_count = 0;  ///< coordinates in no equation at rest
  /// Leading terms of W along coordinates that are alone in their equation and have K = 0 exactly.
  std::vector<LeadingTerm> degenerate = {};
  std::vector<bool> is_positive = {};  ///< for each coefficient of `degenerate`
};

/// True if a minimum of W = V0 - T0 decides stability: L does not contain t, D >= 0 at v = 0, no
/// force Q acts, and the inputs are 0 or B does not depend on q. `state` has parameters and inputs.
[[nodiscard]] bool is_conservative(const Program& motion_program, const State& state);

[[nodiscard]] StabilityVerdict stability_of(const RestPoint& point,
                                            const LagrangeDirichletPremises& conditions);

/// True if a symmetric matrix, without the rows and columns `excluded`, is positive definite: in 64
/// digits each pivot exceeds 1e-25 times its diagonal entry in `reference` (default: in the
/// matrix).
[[nodiscard]] bool is_positive_definite(const std::vector<cln::cl_R>& matrix,
                                        const std::vector<std::uint32_t>& excluded = {},
                                        const std::vector<cln::cl_R>& reference = {});

}  // namespace elgen
