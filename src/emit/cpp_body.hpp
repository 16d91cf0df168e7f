// cpp_body: a Function -> the statements between the braces of its C++ definition.
#pragma once

#include <string>

#include "elgen/model.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// Lines with their indentation and line ends: using-declarations of the functions called, one
/// constant per named value, and the result.
[[nodiscard]] std::string cpp_body(const Model& model, const Program& program,
                                   const Function& function);

}  // namespace elgen
