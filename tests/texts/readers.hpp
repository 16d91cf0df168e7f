// Readers of the printed equations, which are compared by value with the Program.
#pragma once

#include <stdexcept>
#include <string>

#include "texts/written_equations.hpp"

namespace elgen::test {

/// The first difference between a text and the Program.
using Mistake = std::runtime_error;

/// Reads the comments above the functions of a header in C++ or C.
///
///     ///     [ M + m,          m*l*cos(theta) ]     entries 0 and 1
///     ///     [ m*l*cos(theta), m*l^2          ]     entries 2 and 3
void read_comments(const std::string& header, WrittenEquations& equations);

/// Reads the JSON file of equations: everything except hashes and the line that names the
/// generator.
void read_sidecar(const std::string& json, WrittenEquations& equations);

/// Reads the text page that `show` prints. A function without a section has only zero entries.
///
///     named parts
///       cos_theta = cos(theta)
///
///     gravity
///       gravity[1] = 0
///       gravity[2] = -m*l*g*sin(theta)
void read_page(const std::string& page, WrittenEquations& equations);

}  // namespace elgen::test
