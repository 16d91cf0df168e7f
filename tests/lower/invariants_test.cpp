#include <catch2/catch.hpp>

#include "elgen/program.hpp"
#include "lower/read_program.hpp"

using namespace elgen;

namespace {

Program product() {
  return testing::read_program(
      "coordinates x\n"
      "function bias\n"
      "  0 = coordinate x\n"
      "  1 = sin 0\n"
      "  2 = multiply 0 1\n"
      "  result 1 1 = 2\n");
}

}  // namespace

TEST_CASE("a sound program has no broken invariant") { CHECK(check_invariants(product()) == ""); }

TEST_CASE("every invariant is watched, and names function and instruction") {
  Program program = product();
  Function& function = program.functions[0];
  std::string broken;

  SECTION("a leaf that does not exist") {
    function.instructions[0].a = 1;
    broken = "function `bias`: instruction 0: there is no leaf 1";
  }
  SECTION("time where the program has none") {
    function.instructions[0].opcode = Opcode::time;
    broken = "function `bias`: instruction 0: there is no leaf 0";
  }
  SECTION("a step where the program has none") {
    function.instructions[0].opcode = Opcode::step;
    broken = "function `bias`: instruction 0: there is no leaf 0";
  }
  SECTION("first operand after its user") {
    function.instructions[1].a = 2;
    broken = "function `bias`: instruction 1: operand 2 is not computed before";
  }
  SECTION("second operand after its user") {
    function.instructions[2].b = 2;
    broken = "function `bias`: instruction 2: operand 2 is not computed before";
  }
  SECTION("a value in an unused slot") {
    function.instructions[1].b = 1;
    broken = "function `bias`: instruction 1: the unused operand is not 0";
  }
  SECTION("a function without a call") {
    function.instructions[2].function = FunctionId::cos;
    broken = "function `bias`: instruction 2: only a call names a function";
  }
  SECTION("twice the same") {
    function.instructions[2] = function.instructions[1];
    broken = "function `bias`: instruction 2: computed before";
  }
  SECTION("dead") {
    function.fields[0].entries[0] = 1;
    broken = "function `bias`: instruction 2: dead";
  }
  SECTION("names of another length") {
    function.names.pop_back();
    broken = "function `bias`: 2 names for 3 instructions";
  }
  SECTION("too few entries") {
    function.fields[0].columns = 2;
    broken = "function `bias`: field `` has 1 entries, not 1 x 2";
  }
  SECTION("an entry of nothing") {
    function.fields[0].entries[0] = 3;
    broken = "function `bias`: field `` refers to instruction 3";
  }
  CHECK(check_invariants(program) == broken);
}
