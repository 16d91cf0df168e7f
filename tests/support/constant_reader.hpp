// read_constant: the text of a constant in a dumped Program -> the Constant.
//
//     exp(1)+cos(1)-1   ->   the sum of three terms
//
// Only what dump() prints is read.
#pragma once

#include <optional>
#include <string>

#include "elgen/constant.hpp"

namespace elgen::test {

/// None where it is no expression of numbers, pi and functions, or has no value.
[[nodiscard]] std::optional<Constant> read_constant(const std::string& text);

}  // namespace elgen::test
