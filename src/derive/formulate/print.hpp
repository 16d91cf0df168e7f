// GiNaC expressions as text with terms and factors sorted and signs in one place, so that two runs
// print the same although GiNaC orders by address.
#pragma once

#include <string>

#include "elgen/lagrangian.hpp"

namespace elgen {

/// Leaves print under their names, definitions as d0, d1, … in the order of the list.
[[nodiscard]] std::string expression_text(const Definitions& definitions, const GiNaC::ex& value);

/// One line per definition: `d3 = l*sin(theta)    ; bob_x`.
[[nodiscard]] std::string dump(const Definitions& definitions);

}  // namespace elgen
