// What is zero by its closed form.
#include "present/proved_zeros.hpp"

#include <catch2/catch.hpp>

#include "lower/read_program.hpp"

using namespace elgen;

namespace {

using Proofs = std::vector<ZeroProof>;

Proofs proved(const std::string& code, const PresentBudget& budget = {}) {
  const Program program = testing::read_program(
      "parameters m\ncoordinates x\nfunction gravity\n"
      "  0 = parameter m\n  1 = coordinate x\n" +
      code);
  return proved_zeros(program, program.functions[0], budget);
}

const std::string circle =
    "  2 = sin 1\n  3 = cos 1\n  4 = multiply 2 2\n  5 = multiply 3 3\n  6 = add 4 5\n"
    "  7 = constant 1\n  8 = subtract 6 7\n  result 2 1 = 8 6\n";

}  // namespace

TEST_CASE("the empty sum is 0, another sum of leaves, sines and cosines is not") {
  CHECK(proved(circle) == Proofs{ZeroProof::zero, ZeroProof::not_zero});
}

TEST_CASE("x + 1e-50 x is not x, though no number of 64 digits would tell") {
  CHECK(proved("  2 = constant 1/1" + std::string(50, '0') +
               "\n  3 = multiply 2 1\n  4 = add 3 1\n  5 = subtract 4 1\n  result 1 1 = 5\n") ==
        Proofs{ZeroProof::not_zero});
}

TEST_CASE("atoms that may depend on each other prove nothing") {
  // sqrt(x^2) - x and 2 cos(x/24)^2 - 1 - cos(x/12)
  CHECK(proved("  2 = multiply 1 1\n  3 = square_root 2\n  4 = subtract 3 1\n  result 1 1 = 4\n") ==
        Proofs{ZeroProof::open});
  CHECK(proved("  2 = constant 1/24\n  3 = multiply 2 1\n  4 = cos 3\n  5 = multiply 4 4\n"
               "  6 = add 5 5\n  7 = constant 1/12\n  8 = multiply 7 1\n  9 = cos 8\n"
               "  10 = constant 1\n  11 = add 10 9\n  12 = subtract 6 11\n  result 1 1 = 12\n") ==
        Proofs{ZeroProof::open});
  // x/(x + m): sin(2 y) - 2 sin(y) cos(y)
  CHECK(proved("  2 = add 0 1\n  3 = divide 1 2\n  4 = add 3 3\n  5 = sin 4\n  6 = sin 3\n"
               "  7 = cos 3\n  8 = multiply 6 7\n  9 = add 8 8\n  10 = subtract 5 9\n"
               "  result 1 1 = 10\n") == Proofs{ZeroProof::open});
}

TEST_CASE("a form that is given up proves nothing") {
  CHECK(proved(circle, {.products_per_function = 1, .products = 1, .terms = 1}) ==
        Proofs{ZeroProof::open, ZeroProof::open});
}
