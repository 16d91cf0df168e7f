// from_program: Program -> Graph, the way back from instructions to sums and products.
#pragma once

#include <vector>

#include "lower/graph/rebuild.hpp"

namespace elgen {

/// The values of the instructions `wanted`; those that `is_zero` says (none where it is empty) are
/// 0 wherever they are used, so none of them may divide.
[[nodiscard]] Expressions from_program(const Program& program, const Function& function,
                                       const std::vector<std::uint32_t>& wanted,
                                       const std::vector<bool>& is_zero = {});

}  // namespace elgen
