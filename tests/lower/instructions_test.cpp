// Instructions are added once.
#include "lower/network/instructions.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("what is found is where it stands first, also where something stands twice") {
  Function function;
  const Instruction m{.opcode = Opcode::parameter, .a = 0};
  const Instruction l{.opcode = Opcode::parameter, .a = 1};
  function.instructions = {m, m, l};
  function.names.resize(3);
  Instructions instructions(function);
  CHECK(instructions.add(m) == 0);
  CHECK(instructions.add(l) == 2);
  CHECK(instructions.add({.opcode = Opcode::parameter, .a = 2}) == 3);
}

TEST_CASE("what is there already is found, what is not comes last") {
  Program program = *parse_program(make_source("test.program",
                                               "parameters m l\nfunction gravity\n  0 = parameter "
                                               "m\n  1 = multiply 0 0\n  result 1 1 = 1\n"));
  Instructions instructions(program.functions[0]);
  CHECK(instructions.add(Opcode::multiply, 0, 0) == 1);
  const std::uint32_t l = instructions.add({.opcode = Opcode::parameter, .a = 1});
  CHECK(l == 2);
  CHECK(instructions.add(Opcode::add, 1, l) == 3);
  program.functions[0].fields[0].entries = {3};
  CHECK(check_invariants(program).empty());
}
