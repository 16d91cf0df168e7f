// Reads the constants of a dumped Program.
#pragma once

#include <optional>
#include <string>

#include "elgen/constant.hpp"

namespace elgen::test {

/// The constant in its printed form. Empty if the text is not an expression of numbers, pi and
/// functions, or has no value.
[[nodiscard]] std::optional<Constant> read_constant(const std::string& text);

}  // namespace elgen::test
