#include <catch2/catch.hpp>

#include "elgen/program.hpp"
#include "lower/read_program.hpp"

using namespace elgen;

namespace {

/// A sound program, broken in one place.
struct BrokenRow {
  void (*damage)(Function& function);
  const char* broken;
};

}  // namespace

TEST_CASE("every invariant is watched, and names function and instruction") {
  const BrokenRow row = GENERATE(values<BrokenRow>({
      {[](Function& f) { f.instructions[0].a = 1; }, "instruction 0: there is no leaf 1"},
      {[](Function& f) { f.instructions[0].opcode = Opcode::time; },
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
  Program program = testing::read_program(
      "coordinates x\nfunction bias\n  0 = coordinate x\n  1 = sin 0\n  2 = multiply 0 1\n"
      "  result 1 1 = 2\n");
  CHECK(check_invariants(program) == "");
  row.damage(program.functions[0]);
  CHECK(check_invariants(program) == std::string("function `bias`: ") + row.broken);
}
