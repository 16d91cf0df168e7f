// The constants of a dumped Program.
#pragma once

#include <optional>
#include <string>

#include "elgen/constant.hpp"

namespace elgen::test {

/// None where it is no expression of numbers, pi and functions, or has no value. The graph gives it
/// the form that it had when it was printed.
[[nodiscard]] std::optional<Constant> read_constant(const std::string& text);

}  // namespace elgen::test
