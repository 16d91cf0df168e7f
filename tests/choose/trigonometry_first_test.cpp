// trigonometry_first: an order by hand, and that nothing else changes.
#include "choose/trigonometry_first.hpp"

#include <catch2/catch.hpp>

#include "lower/read_program.hpp"

using namespace elgen;

namespace {

std::string ordered(const std::string& text) {
  Program program = testing::read_program(text);
  program.functions[0] = trigonometry_first(program.functions[0]);
  CHECK(check_invariants(program).empty());
  return dump(program);
}

}  // namespace

TEST_CASE("sines and cosines come first, with what they need, the two of an angle together") {
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
