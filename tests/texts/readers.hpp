// Readers of the equations that people and programs read, compared by value with the Program.
#pragma once

#include <stdexcept>
#include <string>

#include "texts/written_equations.hpp"

namespace elgen::texts {

/// The first thing in a text that is not what was derived.
using Mistake = std::runtime_error;

/// The comments above the functions of a header in C++ or C.
///
///     ///     [ M + m,          m*l*cos(theta) ]     entries 0 and 1
///     ///     [ m*l*cos(theta), m*l^2          ]     entries 2 and 3
void read_comments(const std::string& header, WrittenEquations& equations);

/// The sidecar of equations: everything in it but hashes and the line that says what made it.
void read_sidecar(const std::string& json, WrittenEquations& equations);

/// The page that `show` prints as text; a function without a section has no entry but 0.
///
///     named parts
///       cos_theta = cos(theta)
///
///     gravity
///       gravity[1] = 0
///       gravity[2] = -m*l*g*sin(theta)
void read_page(const std::string& page, WrittenEquations& equations);

}  // namespace elgen::texts
