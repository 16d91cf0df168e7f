#include "lower/constants/constant_formula.hpp"

#include <catch2/catch.hpp>

#include "support/constant_reader.hpp"

using namespace elgen;

namespace {

struct Notations {
  const char* text;
  const char* latex;
};

}  // namespace

TEST_CASE("exact constants in both notations") {
  const Notations row =
      GENERATE(values<Notations>({{"1/2", "\\frac{1}{2}"},
                                  {"981/100", "9.81"},
                                  {"200000000000000000/3", "\\frac{200000000000000000}{3}"},
                                  {"sqrt(2)", "\\sqrt{2}"},
                                  {"pi", "\\pi"},
                                  {"1/2*pi", "\\frac{1}{2} \\pi"},
                                  {"1 - cos(1)", "1 - \\cos 1"},
                                  {"2*(1 + pi)^2", "2 (1 + \\pi)^{2}"},
                                  {"sqrt(3)^(-1)", "\\frac{1}{\\sqrt{3}}"},
                                  {"exp(-1 - pi)", "\\exp(-1 - \\pi)"}}));
  const auto constant = test::read_constant(row.text);
  REQUIRE(constant);
  CHECK(constant_formula(model_spelling(), constant->form).text() == row.text);
  CHECK(constant_formula(latex_spelling(), constant->form).text() == row.latex);
}

TEST_CASE("a constant sum is bracketed as a factor") {
  const auto sum = test::read_constant("1 + pi");
  REQUIRE(sum);
  const Spelling& n = model_spelling();
  const Formula written = product(n, {constant_formula(n, sum->form), {"x"}});
  CHECK(written.text() == "(1 + pi)*x");
}
