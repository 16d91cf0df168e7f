// Conservation: whether energy decides about stability.
#pragma once

#include "elgen/analyse.hpp"
#include "elgen/evaluate.hpp"

namespace elgen {

/// d f/d v of the entries of a function, row-major, one column for each velocity.
[[nodiscard]] std::vector<Real> velocity_slopes(const Program& moving, OutputKind kind,
                                                const Arguments<Real>& at);

/// Whether W = V0 - T0 decides by Lagrange and Dirichlet: L is free of t, no force acts but D >= 0
/// and inputs whose B does not depend on q. `state`: parameters and inputs as they are.
[[nodiscard]] bool is_conservative(const Program& moving, const State& state);

}  // namespace elgen
