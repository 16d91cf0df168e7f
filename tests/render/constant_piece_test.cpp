#include <catch2/catch.hpp>

#include "render/equations.hpp"

using namespace elgen;
using namespace elgen::rendering;

TEST_CASE("exact constants in both notations") {
  const Constant half{cln::cl_R(cln::cl_RA(1) / 2), "1/2"};
  CHECK(constant_piece(text_notation(), half).text() == "1/2");
  CHECK(constant_piece(latex_notation(), half).text() == "\\frac{1}{2}");
  const Constant root{cln::sqrt(cln::cl_R(2)), "sqrt(2)"};
  CHECK(constant_piece(latex_notation(), root).text() == "\\sqrt{2}");
  const Constant pi{cln::pi(), "pi"};
  CHECK(constant_piece(latex_notation(), pi).text() == "\\pi");
}
