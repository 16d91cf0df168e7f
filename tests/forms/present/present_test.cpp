// Tests the canonical sums of a program, and proofs that an entry is zero.
#include <catch2/catch.hpp>

#include "elgen/closed_forms.hpp"
#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const std::string leaves = "parameters m\ncoordinates x y\n";

using Proofs = std::vector<ZeroProof>;

Proofs proved(const std::string& code, const ClosedFormBudget& budget = {}) {
  const Program program = read_program(
      "parameters m\ncoordinates x\nfunction gravity\n"
      "  0 = parameter m\n  1 = coordinate x\n" +
      code);
  return prove_zeros(program, program.functions[0], budget);
}

const std::string circle =
    "  2 = sin 1\n  3 = cos 1\n  4 = multiply 2 2\n  5 = multiply 3 3\n  6 = add 4 5\n"
    "  7 = constant 1\n  8 = subtract 6 7\n  result 2 1 = 8 6\n";

}  // namespace

TEST_CASE("sin^2 + cos^2 is 1") {
  const ClosedForms forms = present(read_program(
      leaves +
      "function bias\n  0 = coordinate x\n  1 = sin 0\n  2 = multiply 1 1\n  3 = cos 0\n"
      "  4 = multiply 3 3\n  5 = add 2 4\n  result 1 1 = 5\n"));
  const auto& entry = forms.functions.at(0).fields.at(0).entries.at(0);
  REQUIRE(entry);
  CHECK(entry->numerator.size() == 1);
  CHECK(entry->numerator.begin()->first.empty());
}

TEST_CASE("every operation of a program") {
  const ClosedForms forms = present(read_program(
      leaves +
      "function bias\n  0 = parameter m\n  1 = velocity x\n  2 = time\n  3 = negate 1\n"
      "  4 = subtract 0 3\n  5 = divide 4 0\n  6 = square_root 0\n  7 = atan2 2 6\n"
      "  8 = multiply 5 7\n  result 1 1 = 8\n"));
  const auto& entry = forms.functions[0].fields[0].entries[0];
  REQUIRE(entry);
  CHECK(entry->numerator.size() == 2);
}

TEST_CASE("a form that exceeds its budget is abandoned") {
  const Program program =
      read_program(leaves +
                   "function bias\n  0 = coordinate x\n  1 = coordinate y\n  2 = add 0 1\n"
                   "  3 = multiply 2 2\n  4 = multiply 3 3\n  result 1 1 = 4\n");
  CHECK(present(program).functions[0].fields[0].entries[0]);
  CHECK_FALSE(present(program, {5, 5, 100}).functions[0].fields[0].entries[0]);
  CHECK_FALSE(present(program, {500, 500, 3}).functions[0].fields[0].entries[0]);
}

TEST_CASE("the empty sum is 0, another sum of leaves, sines and cosines is not") {
  CHECK(proved(circle) == Proofs{ZeroProof::zero, ZeroProof::not_zero});
}

TEST_CASE("x + 1e-50 x is not x, although 64 digits cannot distinguish them") {
  CHECK(proved("  2 = constant 1/1" + std::string(50, '0') +
               "\n  3 = multiply 2 1\n  4 = add 3 1\n  5 = subtract 4 1\n  result 1 1 = 5\n") ==
        Proofs{ZeroProof::not_zero});
}

TEST_CASE("possibly dependent atoms prove nothing") {
  // sqrt(x^2) - x and 2 cos(x/24)^2 - 1 - cos(x/12)
  CHECK(proved("  2 = multiply 1 1\n  3 = square_root 2\n  4 = subtract 3 1\n  result 1 1 = 4\n") ==
        Proofs{ZeroProof::undecided});
  CHECK(proved("  2 = constant 1/24\n  3 = multiply 2 1\n  4 = cos 3\n  5 = multiply 4 4\n"
               "  6 = add 5 5\n  7 = constant 1/12\n  8 = multiply 7 1\n  9 = cos 8\n"
               "  10 = constant 1\n  11 = add 10 9\n  12 = subtract 6 11\n  result 1 1 = 12\n") ==
        Proofs{ZeroProof::undecided});
  // sin(2 y) - 2 sin(y) cos(y) for y = x/(x + m)
  CHECK(proved("  2 = add 0 1\n  3 = divide 1 2\n  4 = add 3 3\n  5 = sin 4\n  6 = sin 3\n"
               "  7 = cos 3\n  8 = multiply 6 7\n  9 = add 8 8\n  10 = subtract 5 9\n"
               "  result 1 1 = 10\n") == Proofs{ZeroProof::undecided});
}

TEST_CASE("exp(x + m) is proved equal to exp(x)*exp(m), and closed forms keep both") {
  const std::string code =
      "  2 = add 0 1\n  3 = exp 2\n  4 = exp 0\n  5 = exp 1\n  6 = multiply 4 5\n"
      "  7 = subtract 3 6\n  8 = subtract 3 5\n  9 = expm1 2\n  10 = subtract 9 6\n"
      "  11 = constant 1\n  12 = add 10 11\n  result 3 1 = 7 8 12\n";
  CHECK(proved(code) == Proofs{ZeroProof::zero, ZeroProof::undecided, ZeroProof::zero});
  const ClosedForms forms =
      present(read_program("parameters m\ncoordinates x\nfunction gravity\n"
                           "  0 = parameter m\n  1 = coordinate x\n" +
                           code));
  const auto& entry = forms.functions[0].fields[0].entries[0];
  REQUIRE(entry);
  CHECK(entry->numerator.size() == 2);
}

TEST_CASE("an abandoned form proves nothing") {
  CHECK(proved(circle, {.products_per_function = 1, .products = 1, .terms = 1}) ==
        Proofs{ZeroProof::undecided, ZeroProof::undecided});
}
