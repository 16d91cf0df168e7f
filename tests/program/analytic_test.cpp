// Values that are analytic in the leaves, and values treated as independent variables (unknowns).
#include "program/network/analytic.hpp"

#include <catch2/catch.hpp>

#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// True if the value of an instruction is an unknown. The leaves are 0 = p (positive), 1 = k (no
/// assumption), 2 = x, 3 = y.
bool has_unknown(const std::string& code) {
  const Program program = read_program(
      "parameters p k\npositive p\ncoordinates x y\nfunction gravity\n"
      "  0 = parameter p\n  1 = parameter k\n  2 = coordinate x\n  3 = coordinate y\n" +
      code);
  const std::vector<bool> marks = mark_unknown_values(program, program.functions[0]);
  return std::find(marks.begin(), marks.end(), true) != marks.end();
}

}  // namespace

TEST_CASE("the root of a square is an unknown") {
  CHECK(
      has_unknown("  4 = multiply 2 2\n  5 = square_root 4\n  6 = subtract 5 2\n"
                  "  result 1 1 = 6\n"));
}

TEST_CASE("roots, logarithms and angles of positive values are analytic") {
  const std::string squares = "  4 = multiply 2 2\n  5 = constant 2\n  6 = add 4 5\n";
  CHECK_FALSE(has_unknown(squares + "  7 = square_root 6\n  result 1 1 = 7\n"));
  CHECK_FALSE(has_unknown(squares + "  7 = log 6\n  result 1 1 = 7\n"));
  CHECK_FALSE(has_unknown(squares + "  7 = atan2 3 6\n  result 1 1 = 7\n"));
  CHECK(has_unknown(squares + "  7 = atan2 6 3\n  result 1 1 = 7\n"));
  CHECK_FALSE(has_unknown(squares + "  7 = log1p 6\n  8 = hypot 3 6\n  9 = add 7 8\n"
                                    "  result 1 1 = 9\n"));
  CHECK(has_unknown(squares + "  7 = log1p 3\n  8 = multiply 7 6\n  result 1 1 = 8\n"));
  CHECK(has_unknown(squares + "  7 = hypot 2 3\n  8 = multiply 7 6\n  result 1 1 = 8\n"));
  CHECK_FALSE(has_unknown(squares + "  7 = expm1 3\n  8 = stumpff 3 5\n  9 = add 7 8\n"
                                    "  10 = multiply 9 6\n  result 1 1 = 10\n"));
  // sqrt((p + p)^2), sqrt(p/(2 + x^2)), sqrt(cosh(x)), log(exp(y)), sqrt(p + p x^4)
  CHECK_FALSE(
      has_unknown("  4 = add 0 0\n  5 = multiply 4 4\n  6 = square_root 5\n"
                  "  result 1 1 = 6\n"));
  CHECK_FALSE(has_unknown(squares + "  7 = divide 0 6\n  8 = square_root 7\n  result 1 1 = 8\n"));
  CHECK_FALSE(has_unknown("  4 = cosh 2\n  5 = square_root 4\n  result 1 1 = 5\n"));
  CHECK_FALSE(has_unknown("  4 = exp 3\n  5 = log 4\n  result 1 1 = 5\n"));
  CHECK_FALSE(
      has_unknown("  4 = multiply 2 2\n  5 = multiply 4 4\n  6 = multiply 0 5\n"
                  "  7 = add 0 6\n  8 = square_root 7\n  result 1 1 = 8\n"));
}

TEST_CASE("squares are found in products of any order") {
  // sqrt(1 + x y x y) and sqrt(1 + x y x)
  const std::string product = "  4 = multiply 2 3\n  5 = multiply 4 2\n  6 = constant 1\n";
  CHECK_FALSE(has_unknown(product + "  7 = multiply 5 3\n  8 = add 6 7\n  9 = square_root 8\n"
                                    "  result 1 1 = 9\n"));
  CHECK(has_unknown(product + "  7 = add 5 6\n  8 = square_root 7\n  result 1 1 = 8\n"));
}

TEST_CASE("a parameter is positive only if assumed") {
  CHECK_FALSE(has_unknown("  4 = square_root 0\n  result 1 1 = 4\n"));
  CHECK(has_unknown("  4 = square_root 1\n  result 1 1 = 4\n"));
  CHECK(has_unknown("  4 = multiply 1 1\n  5 = square_root 4\n  result 1 1 = 5\n"));
}

TEST_CASE("values with poles are analytic, but roots, logarithms and atan of them are unknowns") {
  const std::string inverse = "  4 = constant 1\n  5 = divide 4 2\n";
  CHECK_FALSE(has_unknown(inverse + "  6 = exp 5\n  7 = tan 6\n  result 1 1 = 7\n"));
  CHECK(has_unknown(inverse + "  6 = atan 5\n  result 1 1 = 6\n"));
  CHECK(has_unknown(inverse + "  6 = multiply 5 5\n  7 = add 4 6\n  8 = square_root 7\n"
                              "  result 1 1 = 8\n"));
  CHECK(has_unknown("  4 = tan 2\n  5 = atan 4\n  result 1 1 = 5\n"));
  CHECK_FALSE(has_unknown("  4 = atan 2\n  5 = tan 4\n  result 1 1 = 5\n"));
}

TEST_CASE("kinked functions, asin and acos are unknowns, functions of them are not") {
  for (const char* const name : {"abs", "sign", "asin", "acos"}) {
    INFO(name);
    CHECK(has_unknown("  4 = " + std::string(name) + " 2\n  result 1 1 = 4\n"));
  }
  CHECK(has_unknown("  4 = max 2 3\n  result 1 1 = 4\n"));
  const Program program = read_program(
      "coordinates x\nfunction gravity\n  0 = coordinate x\n  1 = abs 0\n  2 = atan 1\n"
      "  result 1 1 = 2\n");
  CHECK(mark_unknown_values(program, program.functions[0]) ==
        std::vector<bool>{false, true, false});
}
