// LaTeX as text: fractions, sums and prose in it.
#include <catch2/catch.hpp>

#include "render/latex.hpp"

using namespace elgen;

namespace {

using Texts = std::vector<std::string>;

/// Prose in quotes, formulas without.
Texts pieces_in(const std::string& latex) {
  Texts all;
  for (const LatexPiece& piece : pieces(latex)) {
    all.push_back(piece.is_prose ? "'" + piece.text + "'" : piece.text);
  }
  return all;
}

}  // namespace

TEST_CASE("fractions stand outside of braces") {
  const std::string latex =
      "a \\left( \\frac{b}{c_{1}} \\right) + \\sqrt{\\frac{d}{e}} \\frac{f}{g}";
  const std::vector<FractionPlace> all = fractions(latex);
  REQUIRE(all.size() == 2);
  CHECK(all[0].above == "b");
  CHECK(all[0].below == "c_{1}");
  CHECK(latex.substr(all[1].begin, all[1].end - all[1].begin) == "\\frac{f}{g}");
  CHECK(fractions("\\frac{a").empty());
  CHECK(fractions("\\frac{a}").empty());
}

TEST_CASE("a sum has a sign outside of brackets, or in front") {
  for (const char* sum : {"a + b", "a - b", "-a", "\\frac{a + b}{c} \\mp d"}) CHECK(is_sum(sum));
  for (const char* product : {"a", "a (b + c)", "\\frac{a + b}{c}", "\\left( a - b \\right) c"}) {
    CHECK_FALSE(is_sum(product));
  }
}

TEST_CASE("the last factor of a product in brackets") {
  CHECK(last_bracket("g l (a + b)") == 4);
  CHECK(last_bracket("g \\left( a (b + c) \\right)") == 2);
  CHECK(last_bracket("g \\cos(a + b)") == 0);
  CHECK(last_bracket("(a + b) c") == 0);
}

TEST_CASE("prose and formulas in turn") {
  CHECK(pieces_in("x = 1") == Texts{"x = 1"});
  CHECK(pieces_in("L \\text{ lacks } x \\text{, so } p_{x} \\text{ stays}") ==
        Texts{"L", "' lacks '", "x", "', so '", "p_{x}", "' stays'"});
  CHECK(pieces_in("a, \\text{turns } b") == Texts{"a", "', '", "'turns '", "b"});
  CHECK(pieces_in("\\frac{a}{\\text{b}}") == Texts{"\\frac{a}{\\text{b}}"});
  CHECK(pieces_in("\\left( \\text{b} \\right)") == Texts{"\\left( \\text{b} \\right)"});
  CHECK(pieces_in("").empty());
}

TEST_CASE("letters lose their bold, words become upright") {
  CHECK(without_bold("\\dot{\\mathbf{q}}_{\\boldsymbol{\\tau}}") == "\\dot{q}_{\\tau}");
  CHECK(without_bold("\\mathbf{bias}") == "\\mathrm{bias}");
  CHECK(without_bold("\\mathbf{q") == "\\mathbf{q");
}
