#include <catch2/catch.hpp>

#include "elgen/closed_forms.hpp"
#include "lower/read_program.hpp"

using namespace elgen;

TEST_CASE("atoms, factors and sums are listed") {
  const ClosedForms forms = present(testing::read_program(
      "parameters m\ncoordinates x\nfunction bias\n  0 = parameter m\n  1 = coordinate x\n"
      "  2 = add 0 1\n  3 = divide 0 2\n  4 = cos 1\n  5 = multiply 3 4\n  result 1 1 = 5\n"));
  const std::string text = dump(forms);
  CHECK(text.find("#0 = leaf") == 0);
  CHECK(text.find("= exp i [(1) #1^1] / 12\n") != std::string::npos);
  CHECK(text.find("factor 0 = ") != std::string::npos);
  CHECK(text.find(" / factor 0^1\n") != std::string::npos);
}
