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

/// The instructions `order`, by their old numbers, and nothing else. Operands stand before what
/// they go into, and every entry is there.
[[nodiscard]] Function reordered(const Function& function, const std::vector<std::uint32_t>& order);

[[nodiscard]] Function pruned(const Function& function);

/// The instructions `entries` as one field, with what they need.
[[nodiscard]] Function with_entries(Function function, const std::vector<std::uint32_t>& entries);

}  // namespace elgen
