// Values of formulas in a, b and c, computed from the tree, from its text, and from its typeset
// form. The symbols are complex numbers, so that every root and every power has a value.
#pragma once

#include <complex>
#include <string>
#include <string_view>

#include "elgen/formula.hpp"

namespace elgen::test {

using Value = std::complex<double>;

/// The value of `formula`, composed of numbers, symbols, signs, sums, products, quotients, powers,
/// roots and sines.
[[nodiscard]] Value value_of_tree(const Formula& formula);

/// The value of `text` by the parser of models. All three functions throw if there is no value.
[[nodiscard]] Value value_of_text(const std::string& text);

/// The value of `line`, LaTeX or its ASCII drawing on one line. Adjacent factors are multiplied; a
/// function without brackets applies to all factors up to the next function, sign or dot.
[[nodiscard]] Value value_of_line(std::string_view line);

}  // namespace elgen::test
