// What is zero by its closed form.
#include "present/proved_zeros.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

std::vector<bool> proved(const std::string& code, const PresentBudget& budget = {}) {
  const Program program =
      *parse_program(make_source("test.program",
                                 "parameters m\ncoordinates x\nfunction gravity\n"
                                 "  0 = parameter m\n  1 = coordinate x\n" +
                                     code));
  return proved_zeros(program, program.functions[0], budget);
}

const std::string circle =
    "  2 = sin 1\n  3 = cos 1\n  4 = multiply 2 2\n  5 = multiply 3 3\n  6 = add 4 5\n"
    "  7 = constant 1\n  8 = subtract 6 7\n  result 2 1 = 8 6\n";

}  // namespace

TEST_CASE("the empty sum is proved, anything else is not") {
  CHECK(proved(circle) == std::vector<bool>{true, false});
}

TEST_CASE("a form that is given up proves nothing") {
  CHECK(proved(circle, {.products_per_function = 1, .products = 1, .terms = 1}) ==
        std::vector<bool>{false, false});
}
