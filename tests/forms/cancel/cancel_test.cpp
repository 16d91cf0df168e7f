// Vanishing expressions become exact zeros, and zeros without a proof are recorded.
#include "elgen/cancel.hpp"

#include <catch2/catch.hpp>

#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Program velocity_force_program(const std::string& instructions) {
  const std::string text =
      "parameters m l\ncoordinates x y\nvelocities x y\nfunction velocity_force\n" + instructions;
  return read_program(text);
}

}  // namespace

TEST_CASE("a sum that cancels becomes 0 by proof") {
  // The entries are z = m (l + x) - (m l + m x) = 0, and z v_x + m.
  const Program program = cancel(velocity_force_program(
      "  0 = parameter m\n  1 = parameter l\n  2 = coordinate x\n  3 = add 1 2\n"
      "  4 = multiply 0 3\n  5 = multiply 0 1\n  6 = multiply 0 2\n  7 = add 5 6\n"
      "  8 = subtract 4 7\n  9 = velocity x\n  10 = multiply 8 9\n  11 = add 10 0\n"
      "  result 2 1 = 8 11\n"));
  const Function& function = program.functions[0];
  CHECK(find_invariant_violation(program).empty());
  CHECK(function.instructions.size() == 2);  // the constant 0 and m
  CHECK(function.instructions[function.fields[0].entries[1]].opcode == Opcode::parameter);
  CHECK(function.sampled_zeros.empty());
}

TEST_CASE("without a proof the entries that depend on the zero are recorded") {
  // (e^(x/5))^5 - e^x: closed forms only know exponents that are multiples of 1/12.
  const Program program = cancel(velocity_force_program(
      "  0 = coordinate x\n  1 = constant 1/5\n  2 = multiply 0 1\n  3 = exp 2\n"
      "  4 = multiply 3 3\n  5 = multiply 4 4\n  6 = multiply 5 3\n  7 = exp 0\n"
      "  8 = subtract 6 7\n  9 = velocity y\n  10 = multiply 8 9\n  11 = parameter m\n"
      "  12 = add 11 10\n  result 3 1 = 11 12 10\n"));
  const Function& function = program.functions[0];
  CHECK(function.instructions.size() == 2);
  CHECK(function.sampled_zeros == std::vector<std::uint32_t>{1, 2});
}

TEST_CASE("a function without zeros is unchanged, with its names") {
  const Program program = velocity_force_program(
      "  0 = parameter m\n  1 = coordinate x\n  2 = sin 1\n"
      "  3 = multiply 0 2\n  result 2 1 = 3 0\n");
  CHECK(dump(cancel(program)) == dump(program));
}
