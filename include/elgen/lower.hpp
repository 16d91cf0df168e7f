// lower: EquationsOfMotion -> Program. Only this stage decides the order of evaluation and which
// values are shared.
//
// Definitions are imported into a hash-consed graph of n-ary sums and products. Terms and factors
// are sorted (by declaration order of the leaves, then by structure), and common signs are factored
// out. The result is therefore independent of GiNaC's order by address. Common sub-sums and
// sub-products are shared by all fields of a function.
#pragma once

#include <vector>

#include "elgen/limits.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

struct EquationsOfMotion;

/// One Function per requested output except `step` and `step_derivatives`. For a composed output,
/// the function computes the parts of the output (elgen/compose.hpp). A requested `dynamics` has
/// one field per requested output that takes neither a nor u. E312: a denominator is 0 at every
/// state. E501, E603: a matrix with which the output solves is singular. E908: more than
/// limits.derived_nodes nodes. E912: an internal error.
[[nodiscard]] Result<Program> lower(const EquationsOfMotion& equations,
                                    const std::vector<OutputRequest>& outputs,
                                    const Limits& limits);

}  // namespace elgen
