// Output values: every row of the output table, from directional derivatives along unit vectors.
#pragma once

#include <vector>

#include "elgen/oracle.hpp"
#include "mechanics.hpp"

namespace elgen::oracle {

/// All entries, row-major, one field after another. `dynamics` has no entries of its own. Throws
/// OutsideDomain.
[[nodiscard]] std::vector<cln::cl_R> output_values(const Model& model, const OutputRequest& output,
                                                   const State& state);

}  // namespace elgen::oracle
