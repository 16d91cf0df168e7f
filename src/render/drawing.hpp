// drawing: LaTeX -> a block, in Unicode or in ASCII.
#pragma once

#include "elgen/render.hpp"
#include "render/block.hpp"
#include "render/latex_tree.hpp"

namespace elgen {

enum class Fractions : std::uint8_t { stacked, in_line };

[[nodiscard]] Block drawing(const LatexTree& tree, Alphabet alphabet,
                            Fractions fractions = Fractions::stacked);

/// "2" -> "²"; "1/2", which has no small characters, "^(1/2)".
[[nodiscard]] std::string small_exponent(const std::string& exponent);

/// Square brackets around a grid.
[[nodiscard]] Block matrix_drawing(const std::vector<Block>& entries, std::size_t columns,
                                   Alphabet alphabet);

}  // namespace elgen
