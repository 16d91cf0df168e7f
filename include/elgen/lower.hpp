// lower: EquationsOfMotion -> Program. The only place that decides the order of evaluation and what
// is shared.
//
// Definitions are imported into a hash-consed graph of n-ary sums and products, ordered by elgen's
// own keys (declaration order of the leaves, then structure), common signs pulled out, so that
// nothing of GiNaC's address-dependent order survives. Common sub-sums and sub-products are shared
// once, over all outputs of a function.
#pragma once

#include <vector>

#include "elgen/limits.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

struct EquationsOfMotion;

/// One Function per requested output but `step`, or its parts (elgen/compose.hpp); `dynamics`,
/// where requested, has one field per output that takes neither a nor u. E908: more than
/// limits.derived_nodes nodes.
[[nodiscard]] Result<Program> lower(const EquationsOfMotion& equations,
                                    const std::vector<OutputRequest>& outputs,
                                    const Limits& limits);

}  // namespace elgen
