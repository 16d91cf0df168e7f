// Instructions are added once.
#include "lower/network/instructions.hpp"

#include <catch2/catch.hpp>

#include "lower/read_program.hpp"

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
  Program program = testing::read_program(
      "parameters m l\nfunction gravity\n  0 = parameter m\n  1 = multiply 0 0\n"
      "  result 1 1 = 1\n");
  Instructions instructions(program.functions[0]);
  CHECK(instructions.add(Opcode::multiply, 0, 0) == 1);
  const std::uint32_t l = instructions.add({.opcode = Opcode::parameter, .a = 1});
  CHECK(l == 2);
  CHECK(instructions.add(Opcode::add, 1, l) == 3);
  program.functions[0].fields[0].entries = {3};
  CHECK(check_invariants(program).empty());
}

TEST_CASE("what two entries compute alike is computed once") {
  const Program program = testing::read_program(
      "parameters m l\nfunction gravity\n  0 = parameter m\n  1 = parameter l\n"
      "  2 = multiply 0 1\n  3 = add 2 0\n  result 2 1 = 2 3\n");
  Function twice = program.functions[0];
  twice.instructions.push_back({.opcode = Opcode::multiply, .a = 0, .b = 1});
  twice.instructions.push_back({.opcode = Opcode::add, .a = 4, .b = 0});
  twice.names.resize(6);
  twice.fields[0].entries = {4, 5};
  const Function once = without_repeats(twice);
  CHECK(once.instructions == program.functions[0].instructions);
  CHECK(once.fields[0].entries == program.functions[0].fields[0].entries);
}
