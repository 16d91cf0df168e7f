#include "base/formula.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

const Formula a{"a"};
const Formula b{"b"};
const Formula c{"c"};
const Formula two{"2"};

}  // namespace

TEST_CASE("brackets stand only where precedence asks for them, in the model language") {
  const Spelling& n = model_spelling();
  CHECK(sum(n, {{a}, {sum(n, {{b}, {c, true}})}}).text() == "a + (b - c)");
  CHECK(sum(n, {{sum(n, {{a}, {b}})}, {c}}).text() == "a + b + c");
  CHECK(product(n, {sum(n, {{a}, {b}}), power(n, c, two)}).text() == "(a + b)*c^2");
  CHECK(quotient(n, a, product(n, {b, c})).text() == "a/(b*c)");
  CHECK(negated(n, sum(n, {{a}, {b}})).text() == "-(a + b)");
  CHECK(square_root(n, sum(n, {{a}, {b}})).text() == "sqrt(a + b)");
  CHECK(power(n, call(n, FunctionId::sin, {a}), two).text() == "sin(a)^2");
}

TEST_CASE("LaTeX stacks fractions and puts exponents on functions") {
  const Spelling& n = latex_spelling();
  CHECK(quotient(n, sum(n, {{a}, {b}}), c).text() == "\\frac{a + b}{c}");
  CHECK(power(n, call(n, FunctionId::sin, {a}), two).text() == "\\sin^{2} a");
  CHECK(call(n, FunctionId::cos, {sum(n, {{a}, {b}})}).text() == "\\cos(a + b)");
  CHECK(square_root(n, a).text() == "\\sqrt{a}");
}

TEST_CASE("a sign stands free in front of a formula only") {
  const Spelling& n = code_spelling();
  CHECK(product(n, {negated(n, a), b}).text() == "-a * b");
  CHECK(negated(n, product(n, {a, b})).text() == "-a * b");
  CHECK(product(n, {a, negated(n, b)}).text() == "a * (-b)");
  CHECK(sum(n, {{c}, {negated(n, product(n, {a, b})), true}}).text() == "c - (-a * b)");
  CHECK(negated(n, negated(n, a)).text() == "-(-a)");
}

TEST_CASE("numbers are exact") {
  const cln::cl_RA weight = cln::cl_RA(981) / 100;
  CHECK(number(model_spelling(), -weight).text() == "-981/100");
  CHECK(number(latex_spelling(), weight).text() == "9.81");
  CHECK(number(latex_spelling(), cln::cl_RA(1) / 2).text() == "\\frac{1}{2}");
}
