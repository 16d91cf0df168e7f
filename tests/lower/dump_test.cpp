#include <cln/rational.h>

#include <catch2/catch.hpp>

#include "elgen/program.hpp"
#include "support/constant_reader.hpp"

using namespace elgen;

namespace {

Function every_opcode() {
  Function function;
  function.kind = OutputKind::bias;
  function.name = "force";
  function.instructions = {{.opcode = Opcode::constant, .a = 0},
                           {.opcode = Opcode::constant, .a = 1},
                           {.opcode = Opcode::parameter, .a = 1},
                           {.opcode = Opcode::coordinate},
                           {.opcode = Opcode::velocity},
                           {.opcode = Opcode::acceleration},
                           {.opcode = Opcode::input},
                           {.opcode = Opcode::time},
                           {.opcode = Opcode::negate, .a = 3},
                           {.opcode = Opcode::call, .function = FunctionId::min, .a = 2, .b = 8}};
  function.names = std::vector<std::string>(10);
  function.names[8] = "back";
  function.fields = {{.name = "first", .rows = 1, .columns = 2, .entries = {9, 7}}};
  return function;
}

}  // namespace

TEST_CASE("dump names leaves as the model does and writes constants exactly") {
  Program program;
  program.leaves = {{{"m", "l[2]"}, {"theta"}, {"theta"}, {"theta"}, {"u"}, "t"}, true};
  program.constants = {rational_constant(cln::cl_RA("-1/3")), *test::read_constant("2 - pi")};
  program.functions = {every_opcode()};
  CHECK(dump(program) ==
        "parameters m l[2]\n"
        "coordinates theta\n"
        "inputs u\n"
        "time\n"
        "function force = bias\n"
        "  0 = constant -1/3\n"
        "  1 = constant 2-pi\n"
        "  2 = parameter l[2]\n"
        "  3 = coordinate theta\n"
        "  4 = velocity theta\n"
        "  5 = acceleration theta\n"
        "  6 = input u\n"
        "  7 = time\n"
        "  8 = negate 3  ; back\n"
        "  9 = min 2 8\n"
        "  result first 1 2 = 9 7\n");
}

TEST_CASE("a user's function states which output it is") {
  Program program;
  Function function;
  function.kind = OutputKind::user_value;
  function.user = 2;
  function.name = "tip";
  program.functions = {function};
  CHECK(dump(program) == "function tip = user_value 2\n");
}
