// Programs: entries, invariants, and instructions added without duplicates.
#include "elgen/program.hpp"

#include <catch2/catch.hpp>

#include "program/network/instructions.hpp"
#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("the entries of all fields are counted") {
  Function function;
  CHECK(entry_count(function) == 0);
  function.fields = {{"A", 2, 2, {0, 1, 2, 3}}, {"B", 2, 1, {4, 5}}};
  CHECK(entry_count(function) == 6);
}

TEST_CASE("operations are counted as the emitted function executes them") {
  const Program program = read_program(
      "parameters m\n"
      "coordinates x y\n"
      "function bias\n"
      "  0 = parameter m\n"
      "  1 = coordinate x\n"
      "  2 = coordinate y\n"
      "  3 = sin 1\n"
      "  4 = cos 1\n"
      "  5 = cos 2\n"
      "  6 = tan 2\n"
      "  7 = add 3 4\n"
      "  8 = subtract 7 5\n"
      "  9 = negate 8\n"
      "  10 = multiply 9 6\n"
      "  11 = divide 10 0\n"
      "  12 = square_root 11\n"
      "  13 = atan2 12 0\n"
      "  result 1 1 = 13\n");
  const OperationCounts counts = count_operations(program.functions[0]);
  // sin x and cos x share one angle, cos y has another angle; tan and atan2 are other calls;
  // negation is free.
  CHECK(counts ==
        OperationCounts{.add = 2, .mul = 1, .div = 1, .sqrt = 1, .sincos = 2, .other = 2});
  CHECK(cost(counts) == 2 + 1 + 4 + 8 + 2 * 20 + 2 * 16);
}

TEST_CASE("roots and functions of numbers are not counted") {
  const Program program = read_program(
      "parameters m\n"
      "function bias\n"
      "  0 = parameter m\n"
      "  1 = constant 7/10\n"
      "  2 = cos 1\n"
      "  3 = negate 1\n"
      "  4 = exp 3\n"
      "  5 = square_root 1\n"
      "  6 = atan2 1 3\n"
      "  7 = atan2 1 0\n"
      "  result 1 5 = 2 4 5 6 7\n");
  CHECK(count_operations(program.functions[0]) == OperationCounts{.other = 1});
}

TEST_CASE("operand counts follow the opcode and the function's arity") {
  CHECK(operand_count({.opcode = Opcode::time}) == 0);
  CHECK(operand_count({.opcode = Opcode::negate}) == 1);
  CHECK(operand_count({.opcode = Opcode::subtract}) == 2);
  CHECK(operand_count({.opcode = Opcode::call, .function = FunctionId::sin}) == 1);
  CHECK(operand_count({.opcode = Opcode::call, .function = FunctionId::atan2}) == 2);
}

TEST_CASE("an instruction that occurs twice is found at its first place") {
  Function function;
  const Instruction m{.opcode = Opcode::parameter, .a = 0};
  const Instruction l{.opcode = Opcode::parameter, .a = 1};
  function.instructions = {m, m, l};
  function.names.resize(3);
  InstructionBuilder instructions(function);
  CHECK(instructions.add(m) == 0);
  CHECK(instructions.add(l) == 2);
  CHECK(instructions.add({.opcode = Opcode::parameter, .a = 2}) == 3);
}

TEST_CASE("adding an existing instruction returns it, a new instruction is appended") {
  Program program = read_program(
      "parameters m l\nfunction gravity\n  0 = parameter m\n  1 = multiply 0 0\n"
      "  result 1 1 = 1\n");
  InstructionBuilder instructions(program.functions[0]);
  CHECK(instructions.add(Opcode::multiply, 0, 0) == 1);
  const std::uint32_t l = instructions.add({.opcode = Opcode::parameter, .a = 1});
  CHECK(l == 2);
  CHECK(instructions.add(Opcode::add, 1, l) == 3);
  program.functions[0].fields[0].entries = {3};
  CHECK(find_invariant_violation(program).empty());
}

namespace {

/// A change that breaks a valid function in one place, and the message that it must cause.
struct BrokenRow {
  void (*damage)(Function& function);
  const char* broken;
};

}  // namespace

TEST_CASE("every invariant is checked, and messages name function and instruction") {
  const BrokenRow row = GENERATE(values<BrokenRow>({
      {[](Function& f) { f.instructions[0].a = 1; }, "instruction 0: there is no leaf 1"},
      {[](Function& f) { f.instructions[0].opcode = Opcode::time; },
       "instruction 0: there is no leaf 0"},
      {[](Function& f) { f.instructions[0].opcode = Opcode::momentum; },
       "instruction 0: there is no leaf 0"},
      {[](Function& f) { f.instructions[0].opcode = Opcode::step; },
       "instruction 0: there is no leaf 0"},
      {[](Function& f) { f.instructions[1].a = 2; },
       "instruction 1: operand 2 is not computed before"},
      {[](Function& f) { f.instructions[2].b = 2; },
       "instruction 2: operand 2 is not computed before"},
      {[](Function& f) { f.instructions[1].b = 1; }, "instruction 1: the unused operand is not 0"},
      {[](Function& f) { f.instructions[2].function = FunctionId::cos; },
       "instruction 2: only a call names a function"},
      {[](Function& f) { f.instructions[2] = f.instructions[1]; },
       "instruction 2: computed before"},
      {[](Function& f) { f.fields[0].entries[0] = 1; }, "instruction 2: dead"},
      {[](Function& f) { f.names.pop_back(); }, "2 names for 3 instructions"},
      {[](Function& f) { f.fields[0].columns = 2; }, "field `` has 1 entries, not 1 x 2"},
      {[](Function& f) { f.fields[0].entries[0] = 3; }, "field `` refers to instruction 3"},
  }));
  Program program = read_program(
      "coordinates x\nfunction bias\n  0 = coordinate x\n  1 = sin 0\n  2 = multiply 0 1\n"
      "  result 1 1 = 2\n");
  CHECK(find_invariant_violation(program) == "");
  CHECK_NOTHROW(require_invariants(program));
  row.damage(program.functions[0]);
  const std::string broken = std::string("function `bias`: ") + row.broken;
  CHECK(find_invariant_violation(program) == broken);
  CHECK_THROWS_MATCHES(require_invariants(program), std::logic_error, Catch::Message(broken));
}

TEST_CASE("repetitions perform the same operations on different operands") {
  const std::string text =
      "coordinates x y z\nfunction bias\n  0 = coordinate x\n  1 = coordinate y\n"
      "  2 = coordinate z\n  3 = multiply 0 1\n  4 = subtract 3 0\n  5 = multiply 0 2\n"
      "  6 = subtract 5 0\n  repeated 2 2\n  result 2 1 = 4 6\n";
  const Program repeated = read_program(text);
  CHECK(find_invariant_violation(repeated) == "");
  CHECK(first_repeated_instruction(repeated.functions[0]) == 3);
  CHECK(dump(repeated) == text);
  const BrokenRow row = GENERATE(values<BrokenRow>({
      {[](Function& f) { f.instructions[6].a = 3; }, "instruction 6: does not repeat 4"},
      {[](Function& f) { f.instructions[6].opcode = Opcode::add; },
       "instruction 6: does not repeat 4"},
      {[](Function& f) { f.instructions[5].a = 3; }, "instruction 5: does not repeat 3"},
      {[](Function& f) {
         f.repeated = {1, 2};
       },
       "instruction 6: does not repeat 5"},
      {[](Function& f) {
         f.repeated = {4, 2};
       },
       "2 times 4 of 7 instructions are repeated"},
      {[](Function& f) {
         f.repeated = {0, 2};
       },
       "2 times 0 of 7 instructions are repeated"},
  }));
  Program program = repeated;
  row.damage(program.functions[0]);
  CHECK(find_invariant_violation(program) == std::string("function `bias`: ") + row.broken);
}

TEST_CASE("only repetitions may compute a value twice") {
  Program program = read_program(
      "coordinates x\nfunction bias\n  0 = coordinate x\n  1 = multiply 0 0\n"
      "  2 = multiply 0 0\n  result 2 1 = 1 2\n");
  CHECK(find_invariant_violation(program) == "function `bias`: instruction 2: computed before");
  program.functions[0].repeated = {1, 2};
  CHECK(find_invariant_violation(program) == "");
}

TEST_CASE("repetitions are kept if all of them remain at the end") {
  Program program = read_program(
      "coordinates x y\nfunction bias\n  0 = coordinate x\n  1 = coordinate y\n"
      "  2 = multiply 0 0\n  3 = multiply 0 1\n  result 2 1 = 2 3\n");
  Function& function = program.functions[0];
  function.repeated = {1, 2};
  CHECK(reorder_instructions(function, {1, 0, 2, 3}).repeated.count == 2);
  CHECK(reorder_instructions(function, {0, 1, 3, 2}).repeated.count == 0);
  CHECK(with_entries(function, {2}).repeated.count == 0);
}
