// Values of formulas of a, b and c: of the tree, of its text, and of its typeset form. The symbols
// are complex numbers, so that every root and every power has a value.
#pragma once

#include <complex>
#include <string>
#include <string_view>

#include "elgen/formula.hpp"

namespace elgen::test {

using Value = std::complex<double>;

/// Accepts numbers, symbols, signs, sums, products, quotients, powers, roots and sines.
[[nodiscard]] Value value_of_tree(const Formula& formula);

/// The value by the parser of models. This and the next function throw if the text is no formula.
[[nodiscard]] Value value_of_text(const std::string& text);

/// The value of `line`, LaTeX or its ASCII drawing on one line. Adjacent factors are multiplied; a
/// function without brackets applies to all factors up to the next function, sign or dot.
[[nodiscard]] Value value_of_line(std::string_view line);

}  // namespace elgen::test
