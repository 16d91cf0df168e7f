// cpp_body: a FunctionBody -> the statements between the braces of its C++ definition.
#pragma once

#include <string>
#include <vector>

#include "elgen/program.hpp"
#include "sections.hpp"
#include "statements.hpp"

namespace elgen {

/// A function with its text, and of each field whether it is a Scalar and no array.
struct CppText {
  const Function& function;
  const FunctionBody& body;
  std::vector<bool> is_scalar = {};
};

[[nodiscard]] CppText cpp_text(const Program& program, const Function& function,
                               const FunctionBody& body);

/// Lines with their indentation and line ends: using-declarations of the functions called, one
/// constant per named value, and the result.
[[nodiscard]] std::string cpp_body(const CppText& text);

/// The same of one part of a function, which writes into `result` and the workspace `w`.
[[nodiscard]] std::string cpp_part(const CppText& text, const Sections& sections, std::size_t part);

}  // namespace elgen
