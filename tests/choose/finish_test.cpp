// The last passes over a function: pivots at zero diagonal entries become NaN, quaternions of any
// length are normalised, and sines and cosines are moved to the front.
#include "choose/finish.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "elgen/evaluate.hpp"
#include "program/read_program.hpp"
#include "support/text.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Forward dynamics with M = diag(m, m r^2, 2); all relative pivots are 1.
Program polar() {
  return read_program(
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
  CHECK(find_invariant_violation(program).empty());
  REQUIRE(function.fields.size() == 2);
  Arguments<double> at;
  at.parameters = {3};
  at.q = {r, 1, 1};
  at.v = {1, 1, 1};
  const std::vector<double> entries = evaluate(program, function, at);
  return {entries.begin() + 3, entries.end()};
}

/// A program with the result x, w/r, i/r, j/r and k/r; r = sqrt(w^2 + i^2 + j^2 + k^2).
Program quaternion() {
  const std::string text =
      "coordinates x w i j k\nfunction normalized\n  0 = coordinate x\n  1 = coordinate w\n"
      "  2 = coordinate i\n  3 = coordinate j\n  4 = coordinate k\n  5 = multiply 1 1\n"
      "  6 = multiply 2 2\n  7 = multiply 3 3\n  8 = multiply 4 4\n  9 = add 5 6\n"
      "  10 = add 9 7\n  11 = add 10 8\n  12 = square_root 11\n  13 = divide 1 12\n"
      "  14 = divide 2 12\n  15 = divide 3 12\n  16 = divide 4 12\n"
      "  result 5 1 = 0 13 14 15 16\n";
  return read_program(text);
}

std::string ordered(const std::string& text) {
  Program program = read_program(text);
  program.functions[0] = with_trigonometry_first(program.functions[0]);
  CHECK(find_invariant_violation(program).empty());
  return dump(program);
}

}  // namespace

TEST_CASE("guards do not change pivots if the diagonal is not 0") {
  CHECK(pivots_at(2) == std::vector<double>{1, 1, 1});
  CHECK(pivots_at(1e-150) == std::vector<double>{1, 1, 1});
}

TEST_CASE("the pivot of a zero diagonal entry is NaN") {
  const std::vector<double> pivots = pivots_at(0);
  CHECK(pivots[0] == 1);
  CHECK(std::isnan(pivots[1]));
  CHECK(pivots[2] == 1);
}

TEST_CASE("a pivot that is already divided by M_ii needs no guard") {
  Program program = polar();
  Function& function = program.functions[0];
  function.instructions.push_back({.opcode = Opcode::divide, .a = 4, .b = 5});
  function.names.emplace_back();
  function.fields[1].entries[1] = 8;
  function = with_guarded_pivots(function, program.constants);
  const Instruction pivot = function.instructions[function.fields[1].entries[1]];
  CHECK(pivot.opcode == Opcode::divide);
}

TEST_CASE("a pivot is guarded by an existing reciprocal of M_ii, or by a new division") {
  Program program = polar();
  Function& function = program.functions[0];
  function.instructions.push_back({.opcode = Opcode::divide, .a = 2, .b = 5});
  function.names.emplace_back();
  function.fields[0].entries[1] = 8;
  function = with_guarded_pivots(function, program.constants);
  CHECK(find_invariant_violation(program).empty());
  const auto guard_of = [&](std::size_t i) {
    return function.instructions[function.instructions[function.fields[1].entries[i]].b];
  };
  CHECK(guard_of(1).opcode == Opcode::multiply);
  CHECK(function.instructions[guard_of(1).b].opcode == Opcode::divide);
  CHECK(guard_of(0).opcode == Opcode::divide);
  Arguments<double> at;
  at.parameters = {3};
  at.v = {1, 1, 1};
  at.q = {2, 1, 1};
  CHECK(evaluate(program, function, at)[4] == 1);
  at.q = {0, 1, 1};
  CHECK(std::isnan(evaluate(program, function, at)[4]));
}

TEST_CASE("without the diagonal no instruction for it remains") {
  Program program = polar();
  Function& function = program.functions[0];
  function.sampled_zeros = {1, 7};
  function = without_diagonal(function);
  CHECK(find_invariant_violation(program).empty());
  CHECK(function.fields.size() == 2);
  CHECK(function.sampled_zeros == std::vector<std::uint32_t>{1});
  CHECK_FALSE(mentions(dump(program), "multiply"));
}

TEST_CASE("a quaternion is normalised for every length in the range of double") {
  Program scaled = quaternion();
  scaled.functions[0] = with_scaled_lengths(scaled.functions[0], "normalized");
  CHECK(find_invariant_violation(scaled).empty());
  const auto at = [&scaled](double size) {
    Arguments<double> arguments;
    arguments.q = {7, size, -2 * size, 2 * size, 4 * size};
    return evaluate(scaled, scaled.functions[0], arguments);
  };
  for (const double size : {1e-300, 1e-160, 1e-3, 1.0, 1e160, 1e300}) {
    CAPTURE(size);
    const std::vector<double> e = at(size);
    CHECK(e[0] == 7);
    CHECK(e[1] == Approx(0.2).epsilon(1e-15));
    CHECK(e[2] == Approx(-0.4).epsilon(1e-15));
    CHECK(e[4] == Approx(0.8).epsilon(1e-15));
  }
  CHECK(std::isnan(at(0)[1]));  // the zero quaternion has no direction
}

TEST_CASE("in `dynamics` only the field of this name is normalised") {
  Program scaled = quaternion();
  Function& function = scaled.functions[0];
  function.kind = OutputKind::dynamics;
  function.fields.push_back({"unit", 5, 1, function.fields[0].entries});
  function = with_scaled_lengths(function, "unit");
  CHECK(find_invariant_violation(scaled).empty());
  Arguments<double> at;
  at.q = {7, 1e-200, 0, 0, 0};
  const std::vector<double> e = evaluate(scaled, function, at);
  CHECK(std::isinf(e[1]));
  CHECK(e[6] == 1);
}

TEST_CASE("sines and cosines come first, after their operands, in pairs of one angle") {
  CHECK(ordered("parameters m\ncoordinates x y\nfunction bias\n"
                "  0 = parameter m\n"
                "  1 = multiply 0 0  ; square\n"
                "  2 = coordinate x\n"
                "  3 = coordinate y\n"
                "  4 = add 2 3\n"
                "  5 = cos 4\n"
                "  6 = multiply 1 5\n"
                "  7 = sin 2\n"
                "  8 = sin 4\n"
                "  9 = sin 5\n"
                "  result 4 1 = 6 7 8 9\n") ==
        "parameters m\ncoordinates x y\nfunction bias\n"
        "  0 = coordinate x\n"
        "  1 = coordinate y\n"
        "  2 = add 0 1\n"
        "  3 = sin 2\n"
        "  4 = cos 2\n"
        "  5 = sin 0\n"
        "  6 = sin 4\n"
        "  7 = parameter m\n"
        "  8 = multiply 7 7  ; square\n"
        "  9 = multiply 8 4\n"
        "  result 4 1 = 9 5 3 6\n");
}

TEST_CASE("a function without sines keeps its order") {
  const std::string text =
      "parameters m\ncoordinates x\nfunction bias\n  0 = parameter m\n  1 = coordinate x\n"
      "  2 = exp 1\n  3 = multiply 0 2\n  result 1 1 = 3\n";
  CHECK(ordered(text) == text);
}
