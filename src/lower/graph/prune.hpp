// prune: a Function without the instructions that none of its entries needs.
//
//     before    0 = parameter m   1 = parameter l   2 = multiply 0 0   result = 2
//     after     0 = parameter m   1 = multiply 0 0                     result = 1
#pragma once

#include "elgen/program.hpp"

namespace elgen {

/// Whether each instruction is one of `wanted` or goes into one.
[[nodiscard]] std::vector<bool> needed_for(const Function& function,
                                           const std::vector<std::uint32_t>& wanted);

[[nodiscard]] Function pruned(Function function);

}  // namespace elgen
