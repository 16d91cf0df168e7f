// Expressions that vanish everywhere: proved, sampled, or not zero.
#include "diff/zeros.hpp"

#include <catch2/catch.hpp>

#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The verdict on the only entry of `code`. If `positive`, m is positive; x may always be negative.
ZeroVerdict zero_of(const std::string& code, bool positive = false) {
  const Program program = read_program(
      "parameters m\n" + std::string(positive ? "positive m\n" : "") +
      "coordinates x\nfunction gravity\n  0 = parameter m\n  1 = coordinate x\n" + code);
  return decide_zeros(program, program.functions[0]).at(0);
}

}  // namespace

TEST_CASE("sin^2 + cos^2 - 1 is proved to be zero") {
  CHECK(zero_of("  2 = sin 1\n  3 = cos 1\n  4 = multiply 2 2\n  5 = multiply 3 3\n  6 = add 4 5\n"
                "  7 = constant 1\n  8 = subtract 6 7\n  result 1 1 = 8\n") == ZeroVerdict::proved);
}

TEST_CASE("a coefficient of 1 + 1e-12 is no zero") {
  CHECK(zero_of("  2 = constant 1000000000001/1000000000000\n  3 = multiply 2 1\n"
                "  4 = subtract 3 1\n  result 1 1 = 4\n") == ZeroVerdict::nonzero);
}

TEST_CASE("|m x| - |m| |x| vanishes at all points, but is undecided, and |x| - x is not zero") {
  CHECK(zero_of("  2 = multiply 0 1\n  3 = abs 2\n  4 = abs 0\n  5 = abs 1\n"
                "  6 = multiply 4 5\n  7 = subtract 3 6\n  result 1 1 = 7\n") ==
        ZeroVerdict::undecided);
  CHECK(zero_of("  2 = abs 1\n  3 = subtract 2 1\n  result 1 1 = 3\n") == ZeroVerdict::nonzero);
}

TEST_CASE("sqrt(m^2) equals m only if m is positive") {
  const std::string root =
      "  2 = multiply 0 0\n  3 = square_root 2\n  4 = subtract 3 0\n"
      "  result 1 1 = 4\n";
  CHECK(zero_of(root, true) == ZeroVerdict::sampled);
  CHECK(zero_of(root, false) == ZeroVerdict::nonzero);
}

TEST_CASE("an expression without a value anywhere is not zero") {
  CHECK(zero_of("  2 = multiply 1 1\n  3 = constant -1\n  4 = subtract 3 2\n"
                "  5 = square_root 4\n  6 = subtract 5 0\n  result 1 1 = 6\n") ==
        ZeroVerdict::nonzero);
}

TEST_CASE("1/sqrt(exp(-2x)) equals exp(x), also at points with overflow to limits") {
  const std::string quotient =
      "  2 = add 1 1\n  3 = exp 1\n  4 = negate 2\n  5 = exp 4\n  6 = square_root 5\n"
      "  7 = constant 1\n  8 = divide 7 6\n";
  CHECK(zero_of(quotient + "  9 = subtract 8 3\n  result 1 1 = 9\n") == ZeroVerdict::sampled);
  CHECK(zero_of(quotient + "  9 = constant 1000000000001/1000000000000\n  10 = multiply 9 3\n"
                           "  11 = subtract 8 10\n  result 1 1 = 11\n") == ZeroVerdict::nonzero);
}

TEST_CASE("tanh(x) is proved to be (exp(2x) - 1)/(1 + 1/exp(-2x)), and not with exp(-3x)") {
  for (const auto& [factor, verdict] :
       {std::pair{"-2", ZeroVerdict::proved}, std::pair{"-3", ZeroVerdict::nonzero}}) {
    CHECK(zero_of("  2 = constant " + std::string(factor) +
                  "\n  3 = multiply 2 1\n  4 = exp 3\n  5 = constant 1\n  6 = divide 5 4\n"
                  "  7 = add 5 6\n  8 = add 1 1\n  9 = exp 8\n  10 = subtract 9 5\n"
                  "  11 = divide 10 7\n  12 = tanh 1\n  13 = subtract 12 11\n"
                  "  result 1 1 = 13\n") == verdict);
  }
}

TEST_CASE("a term hidden by rounding is not zero") {
  // (10^80 + sin x) - 10^80 is 0 in 64 digits; its closed form is sin x.
  CHECK(zero_of("  2 = sin 1\n  3 = constant 1" + std::string(80, '0') +
                "\n  4 = add 3 2\n  5 = subtract 4 3\n  6 = constant 0\n  7 = subtract 5 6\n"
                "  result 1 1 = 7\n") == ZeroVerdict::nonzero);
}

TEST_CASE("|x - 2| and 2 - x differ, although not near 0") {
  CHECK(zero_of("  2 = constant 2\n  3 = subtract 1 2\n  4 = abs 3\n  5 = negate 3\n"
                "  6 = subtract 4 5\n  result 1 1 = 6\n") == ZeroVerdict::nonzero);
}

TEST_CASE("x + 1e-50 x is not x") {
  CHECK(zero_of("  2 = constant 1/1" + std::string(50, '0') +
                "\n  3 = multiply 2 1\n  4 = add 3 1\n  5 = subtract 4 1\n"
                "  result 1 1 = 5\n") == ZeroVerdict::nonzero);
}
