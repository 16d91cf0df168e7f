// Entries that vanish, and entries that only seem to vanish.
#include "forms/cancel/vanishing.hpp"

#include <catch2/catch.hpp>

#include "forms/cancel/gravity_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using Places = std::vector<std::uint32_t>;

/// The indices of the instructions whose values vanish at the first random point.
Places vanishing_places(const std::string& instructions) {
  const Program program = gravity_program(instructions);
  return find_vanishing_values(program, program.functions[0]);
}

/// For each entry: true if the entry vanishes at all other random points.
std::vector<bool> vanishes_elsewhere(const std::string& instructions) {
  const Program program = gravity_program(instructions);
  return find_vanishing_entries(program, program.functions[0]);
}

/// 4 = (x + y)(x - y), 8 = (x + y)(x - y) - (x^2 - y^2)
const std::string difference_of_squares =
    "  0 = coordinate x\n  1 = coordinate y\n  2 = add 0 1\n  3 = subtract 0 1\n"
    "  4 = multiply 2 3\n  5 = multiply 0 0\n  6 = multiply 1 1\n  7 = subtract 5 6\n"
    "  8 = subtract 4 7\n";

}  // namespace

TEST_CASE("an expression that cancels algebraically vanishes, and so do its products") {
  CHECK(vanishing_places(difference_of_squares +
                         "  9 = multiply 8 0\n  10 = add 9 1\n  result 1 1 = 10\n") ==
        Places{8, 9});
  CHECK(vanishes_elsewhere(difference_of_squares + "  result 2 1 = 8 7\n") ==
        std::vector<bool>{true, false});
}

TEST_CASE("a small value does not vanish") {
  CHECK(vanishing_places(
            "  0 = coordinate x\n  1 = constant 1/1000000000000000000000000000000\n"
            "  2 = multiply 0 1\n  3 = multiply 2 2\n  4 = multiply 3 3\n  result 1 1 = 4\n")
            .empty());
}

TEST_CASE("an error bound raised by products is no zero") {
  // (((x + 1e15) - 1e15)^2)^2
  CHECK(vanishing_places(
            "  0 = coordinate x\n  1 = constant 1000000000000000\n  2 = add 0 1\n"
            "  3 = subtract 2 1\n  4 = multiply 3 3\n  5 = multiply 4 4\n  result 1 1 = 5\n")
            .empty());
}

TEST_CASE("a difference hidden by 64 digits is not zero") {
  const std::string zeros(70, '0');
  // 1 - tanh(1000 x)^2 and (1 + 1e-70 x) - 1
  CHECK(vanishing_places(
            "  0 = coordinate x\n  1 = constant 1000\n  2 = multiply 1 0\n  3 = tanh 2\n"
            "  4 = multiply 3 3\n  5 = constant 1\n  6 = subtract 5 4\n  result 1 1 = 6\n")
            .empty());
  CHECK(vanishing_places("  0 = coordinate x\n  1 = constant 1/1" + zeros +
                         "\n  2 = multiply 0 1\n"
                         "  3 = constant 1\n  4 = add 3 2\n  5 = subtract 4 3\n  result 1 1 = 5\n")
            .empty());
}

TEST_CASE("functions of an angle that exhausts the digits do not vanish") {
  const std::string zeros(100, '0');
  CHECK(vanishing_places("  0 = coordinate x\n  1 = constant 1" + zeros +
                         "\n  2 = multiply 1 0\n  3 = tan 2\n  4 = sin 2\n  5 = add 3 4\n"
                         "  result 1 1 = 5\n")
            .empty());
}

TEST_CASE("a kinked function that is zero in a region does not vanish") {
  // max(x - 5, 0), and |x| - x
  CHECK(vanishing_places(
            "  0 = coordinate x\n  1 = constant 5\n  2 = subtract 0 1\n  3 = constant 0\n"
            "  4 = max 2 3\n  result 1 1 = 4\n")
            .empty());
  CHECK(vanishing_places("  0 = coordinate x\n  1 = abs 0\n  2 = subtract 1 0\n  result 1 1 = 2\n")
            .empty());
}

TEST_CASE("a square root or an inverse function may have another branch elsewhere") {
  // x + sqrt(x^2) and sqrt(x^2) - x; asin(sin(x)) - x
  CHECK(vanishes_elsewhere(
            "  0 = coordinate x\n  1 = multiply 0 0\n  2 = square_root 1\n  3 = add 0 2\n"
            "  4 = subtract 2 0\n  result 1 2 = 3 4\n") == std::vector<bool>{false, false});
  CHECK(vanishes_elsewhere("  0 = coordinate x\n  1 = sin 0\n  2 = asin 1\n  3 = subtract 2 0\n"
                           "  result 1 1 = 3\n") == std::vector<bool>{false});
}

TEST_CASE("another branch may lie beyond all sampled points") {
  // sqrt((x - 2)^2) + x - 2, which is 0 for x < 2
  CHECK(vanishes_elsewhere(
            "  0 = coordinate x\n  1 = constant 2\n  2 = subtract 0 1\n  3 = multiply 2 2\n"
            "  4 = square_root 3\n  5 = add 4 2\n  result 1 1 = 5\n") == std::vector<bool>{false});
}

TEST_CASE("the logarithm of a positive function is analytic") {
  // log(exp(x)) - x
  CHECK(vanishes_elsewhere("  0 = coordinate x\n  1 = exp 0\n  2 = log 1\n  3 = subtract 2 0\n"
                           "  result 1 1 = 3\n") == std::vector<bool>{true});
}

TEST_CASE("a zero used by an undefined operation is not replaced") {
  CHECK(vanishing_places(difference_of_squares + "  9 = divide 0 8\n  result 1 2 = 9 8\n").empty());
  CHECK(vanishes_elsewhere(difference_of_squares + "  9 = divide 0 8\n  result 1 2 = 9 8\n") ==
        std::vector<bool>{false, false});
}
