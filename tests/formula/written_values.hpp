// Values of formulas of a, b and c: of the tree, of its text, and of how it is set. The symbols are
// complex numbers, so that every root and every power has a value.
#pragma once

#include <complex>
#include <string>
#include <string_view>

#include "elgen/formula.hpp"

namespace elgen::testing {

using Value = std::complex<double>;

/// Of numbers, symbols, signs, sums, products, quotients, powers, roots and sines.
[[nodiscard]] Value value_of_tree(const Formula& formula);

/// By the parser of models. These two throw where a text is no formula.
[[nodiscard]] Value value_of_text(const std::string& text);

/// Of LaTeX, or of its drawing in ASCII on one line. Factors stand side by side; a function without
/// brackets takes all factors behind it up to the next function, sign or dot.
[[nodiscard]] Value value_of_line(std::string_view line);

}  // namespace elgen::testing
