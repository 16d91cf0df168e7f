// parse_program: the text form of a Program -> Program; what dump() prints, reads back equal.
#pragma once

#include "elgen/program.hpp"

namespace elgen::test {

[[nodiscard]] Result<Program> parse_program(const SourcePointer& text);

}  // namespace elgen::test
