// parse_program reads the text form of a Program. It reads the output of dump() back to an equal
// Program.
#pragma once

#include "elgen/program.hpp"

namespace elgen::test {

[[nodiscard]] Result<Program> parse_program(const SourcePointer& text);

}  // namespace elgen::test
