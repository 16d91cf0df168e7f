// The sums of a program that may stay unexpanded, and closed forms with these sums as atoms.
#include <catch2/catch.hpp>

#include "elgen/closed_forms.hpp"
#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Entries: sqrt((x - m)^2 + y)/(x + m), x - m, and (x + m) + (x - m).
Program distance() {
  return read_program(
      "parameters m\ncoordinates x y\nfunction gravity\n"
      "  0 = coordinate x\n  1 = parameter m\n  2 = subtract 0 1\n  3 = multiply 2 2\n"
      "  4 = coordinate y\n  5 = add 3 4\n  6 = square_root 5\n  7 = add 0 1\n"
      "  8 = divide 6 7\n  9 = add 7 2\n  result 3 1 = 8 2 9\n");
}

/// sin(x - m)/(1 + m): an angle, and a sum without coordinates.
Program angle() {
  return read_program(
      "parameters m\ncoordinates x\nfunction gravity\n"
      "  0 = coordinate x\n  1 = parameter m\n  2 = subtract 0 1\n  3 = sin 2\n"
      "  4 = constant 1\n  5 = add 4 1\n  6 = divide 3 5\n  result 1 1 = 6\n");
}

std::size_t terms_of(const ClosedForms& forms, std::size_t entry) {
  return forms.functions[0].fields[0].entries.at(entry)->numerator.size();
}

}  // namespace

TEST_CASE("typed sums are bases of powers, and arguments of roots and quotients") {
  CHECK(unexpanded_sums(distance()).functions.size() == 3);
  CHECK(unexpanded_sums(angle()).functions.empty());
}

TEST_CASE("typed sums are atoms, except in sums that are shorter without these atoms") {
  const Program program = distance();
  const ClosedForms whole = present(program, unexpanded_sums(program));
  CHECK(terms_of(whole, 0) == 1);
  CHECK(terms_of(whole, 1) == 1);
  CHECK(terms_of(whole, 2) == 1);  // 2 x
  const ClosedForms plain = present(program, Program{});
  CHECK(terms_of(plain, 1) == 2);
}
