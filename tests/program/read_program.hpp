// Reads the text form of a program. Fails the test with the first diagnostic if there is an error.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "support/parse_program.hpp"

namespace elgen::test {

[[nodiscard]] inline Program read_program(const std::string& text) {
  const Result<Program> program = parse_program(make_source("program", text));
  if (!program) FAIL(program.diagnostics.at(0).message);
  return *program;
}

}  // namespace elgen::test
