// Entries as they are read.
#include "diff/closed_texts.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "lower/read_program.hpp"

using namespace elgen;

TEST_CASE("each instruction is written out, and cancelled") {
  const Program program = testing::read_program(
      "parameters m\ncoordinates x\nfunction gravity\n  0 = parameter m\n  1 = coordinate x\n"
      "  2 = multiply 0 1\n  3 = add 2 1\n  4 = subtract 3 2\n  result 2 1 = 3 4\n");
  CHECK(closed_texts(program, program.functions[0], {3, 4}) ==
        std::vector<std::string>{"x*(1 + m)", "x"});
}

TEST_CASE("what does not fit into a line is left out") {
  std::string text =
      "parameters m\ncoordinates x\nfunction gravity\n  0 = parameter m\n"
      "  1 = coordinate x\n";
  // sin(sin(... x)) m
  int at = 1;
  for (int i = 0; i < 30; ++i, ++at) text += fmt::format("  {} = sin {}\n", at + 1, at);
  text += fmt::format("  {} = multiply 0 {}\n  result 1 1 = {}\n", at + 1, at, at + 1);
  const Program program = testing::read_program(text);
  CHECK(closed_texts(program, program.functions[0], {static_cast<std::uint32_t>(at + 1)}) ==
        std::vector<std::string>{""});
}
