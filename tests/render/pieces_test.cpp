#include "render/pieces.hpp"

#include <catch2/catch.hpp>

using namespace elgen;
using namespace elgen::rendering;

namespace {

const Piece a{"a"};
const Piece b{"b"};
const Piece c{"c"};

}  // namespace

TEST_CASE("brackets stand only where precedence asks for them, in the model language") {
  const Notation& n = text_notation();
  CHECK(sum(n, a, difference(n, b, c)).text() == "a + (b - c)");
  CHECK(sum(n, sum(n, a, b), c).text() == "a + b + c");
  CHECK(product(n, {{sum(n, a, b)}, {c, 2}}).text() == "(a + b)*c^2");
  CHECK(quotient(n, a, product(n, {{b}, {c}})).text() == "a/(b*c)");
  CHECK(negated(n, sum(n, a, b)).text() == "-(a + b)");
  CHECK(square_root(n, sum(n, a, b)).text() == "sqrt(a + b)");
  CHECK(product(n, {{call(n, FunctionId::sin, {a}), 2}}).text() == "sin(a)^2");
}

TEST_CASE("LaTeX stacks fractions and puts exponents on functions") {
  const Notation& n = latex_notation();
  CHECK(quotient(n, sum(n, a, b), c).text() == "\\frac{a + b}{c}");
  CHECK(product(n, {{call(n, FunctionId::sin, {a}), 2}}).text() == "\\sin^{2} a");
  CHECK(call(n, FunctionId::cos, {sum(n, a, b)}).text() == "\\cos(a + b)");
  CHECK(square_root(n, a).text() == "\\sqrt{a}");
}
