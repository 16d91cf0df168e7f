// A vanishing diagonal entry is singular.
#include "choose/guarded_pivots.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "elgen/evaluate.hpp"
#include "lower/read_program.hpp"

using namespace elgen;

namespace {

/// M = diag(m, m r^2, 2): all pivots are 1.
Program polar() {
  return testing::read_program(
      "parameters m\ncoordinates r phi x\nvelocities r phi x\nfunction forward_dynamics\n"
      "  0 = parameter m\n  1 = coordinate r\n  2 = constant 1\n  3 = velocity r\n"
      "  4 = multiply 0 1\n  5 = multiply 4 1\n  6 = constant 2\n  7 = divide 3 1\n"
      "  result acceleration 3 1 = 7 7 7\n  result relative_pivots 3 1 = 2 2 2\n"
      "  result diagonal 3 1 = 0 5 6\n");
}

std::vector<double> pivots_at(double r) {
  Program program = polar();
  Function& function = program.functions[0];
  function = with_guarded_pivots(function, program.constants);
  CHECK(check_invariants(program).empty());
  REQUIRE(function.fields.size() == 2);
  Arguments<double> at;
  at.parameters = {3};
  at.q = {r, 1, 1};
  at.v = {1, 1, 1};
  const std::vector<double> entries = evaluate(program, function, at);
  return {entries.begin() + 3, entries.end()};
}

}  // namespace

TEST_CASE("pivots are what they were where the diagonal is not 0") {
  CHECK(pivots_at(2) == std::vector<double>{1, 1, 1});
  CHECK(pivots_at(1e-150) == std::vector<double>{1, 1, 1});
}

TEST_CASE("the pivot of a vanishing diagonal entry is not a number") {
  const std::vector<double> pivots = pivots_at(0);
  CHECK(pivots[0] == 1);
  CHECK(std::isnan(pivots[1]));
  CHECK(pivots[2] == 1);
}

TEST_CASE("a pivot that M_ii divides stays as it is") {
  Program program = polar();
  Function& function = program.functions[0];
  function.instructions.push_back({.opcode = Opcode::divide, .a = 4, .b = 5});
  function.names.emplace_back();
  function.fields[1].entries[1] = 8;
  function = with_guarded_pivots(function, program.constants);
  const Instruction pivot = function.instructions[function.fields[1].entries[1]];
  CHECK(pivot.opcode == Opcode::divide);
}

TEST_CASE("without the diagonal nothing of it is left") {
  Program program = polar();
  Function& function = program.functions[0];
  function.sampled_zeros = {1, 7};
  function = without_diagonal(function);
  CHECK(check_invariants(program).empty());
  CHECK(function.fields.size() == 2);
  CHECK(function.sampled_zeros == std::vector<std::uint32_t>{1});
  CHECK(dump(program).find("multiply") == std::string::npos);
}
