// comment_reader: the equations above a function of a header, compared by value.
//
//     ///     [ M + m,          m*l*cos(theta) ]     entries 0 and 1
//     ///     [ m*l*cos(theta), m*l^2          ]     entries 2 and 3
#pragma once

#include <string_view>
#include <vector>

#include "readback/equation_reader.hpp"
#include "readback/token_reader.hpp"

namespace elgen {

/// Splits at commas outside of brackets, and trims.
[[nodiscard]] std::vector<std::string> split_row(std::string_view row);

/// `comments` are the lines above the function that the equations were started with.
void read_comment(const std::vector<std::string_view>& comments, const TokenReader& tokens,
                  EquationReader& equations, const Origin& origin);

}  // namespace elgen
