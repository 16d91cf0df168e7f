#include "elgen/program.hpp"

#include <catch2/catch.hpp>

#include "lower/read_program.hpp"

using namespace elgen;

TEST_CASE("the entries of all fields are counted") {
  Function function;
  CHECK(entry_count(function) == 0);
  function.fields = {{"A", 2, 2, {0, 1, 2, 3}}, {"B", 2, 1, {4, 5}}};
  CHECK(entry_count(function) == 6);
}

TEST_CASE("operations are counted as the emitted function executes them") {
  const Program program = testing::read_program(
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
  // sin x and cos x are one angle, cos y another; tan and atan2 are other calls; negation is free.
  CHECK(counts ==
        OperationCounts{.add = 2, .mul = 1, .div = 1, .sqrt = 1, .sincos = 2, .other = 2});
  CHECK(cost(counts) == 2 + 1 + 4 + 8 + 2 * 26 + 2 * 16);
}

TEST_CASE("operand counts follow the opcode and the function's arity") {
  CHECK(operand_count({.opcode = Opcode::time}) == 0);
  CHECK(operand_count({.opcode = Opcode::negate}) == 1);
  CHECK(operand_count({.opcode = Opcode::subtract}) == 2);
  CHECK(operand_count({.opcode = Opcode::call, .function = FunctionId::sin}) == 1);
  CHECK(operand_count({.opcode = Opcode::call, .function = FunctionId::atan2}) == 2);
}
