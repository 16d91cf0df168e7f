// Output values: every row of the output table, from directional derivatives along unit vectors.
#pragma once

#include <vector>

#include "elgen/oracle.hpp"
#include "oracle/mechanics.hpp"

namespace elgen::oracle {

/// All entries, row-major, one field after another. `dynamics` has no entries of its own. Throws
/// OutsideDomain.
[[nodiscard]] std::vector<cln::cl_R> output_values(const Model& model, const OutputRequest& output,
                                                   const State& state);

/// w.x or w.X y; by directional derivatives where the output is made of them, else from all entries
/// (of a structure: of its first field, or as many as w has). Throws OutsideDomain.
[[nodiscard]] cln::cl_R contracted_values(const Model& model, const OutputRequest& output,
                                          const State& state, const Contraction& by);

}  // namespace elgen::oracle
