// closed_texts: entries as a reader sees them, where they are short enough to be read.
#pragma once

#include <string>
#include <vector>

#include "elgen/program.hpp"

namespace elgen {

/// Longer ones are not printed.
inline constexpr std::size_t longest_read = 100;

/// The closed form of each instruction, over the leaves; "" where it has more characters or was
/// given up. Cost: a small budget for each.
[[nodiscard]] std::vector<std::string> closed_texts(const Program& program,
                                                    const Function& function,
                                                    const std::vector<std::uint32_t>& instructions);

}  // namespace elgen
