// Formulas in LaTeX, read again: measured, broken into lines, and translated to MathML.
#include <catch2/catch.hpp>
#include <string>

#include "render/latex.hpp"

using namespace elgen;

TEST_CASE("a formula is read into its parts") {
  const LatexTree tree = read_latex("\\frac{a}{b} - \\sin^{2} x");
  REQUIRE(tree.parts.size() == 4);
  CHECK(tree.parts[0].kind == LatexKind::fraction);
  CHECK(tree.parts[1].kind == LatexKind::sign);
  CHECK(tree.parts[2].kind == LatexKind::scripts);
  CHECK(tree.parts[2].parts.at(0).kind == LatexKind::function);
  CHECK(tree.parts[3].kind == LatexKind::letter);
}

TEST_CASE("width is that of what is printed, not of its commands") {
  CHECK(width(read_latex("\\theta")) < 2);
  CHECK(width(read_latex("\\frac{abc}{d}")) < width(read_latex("abc + d")));
  CHECK(width(read_latex("")) == 0);
}

TEST_CASE("what is unknown is a word, brackets need not match") {
  CHECK(read_latex("\\unknown").parts.at(0).kind == LatexKind::word);
  CHECK(read_latex("(a").parts.size() == 2);
}

TEST_CASE("a backslash before a letter of another script keeps the letter whole") {
  const LatexTree tree = read_latex("\\é + \\😀");
  REQUIRE(tree.parts.size() == 3);
  CHECK(tree.parts[0].text == "é");
  CHECK(tree.parts[2].text == "😀");
}

TEST_CASE("a group without an end, and nothing behind it") {
  CHECK(read_latex("\\frac{a").parts.at(0).parts.size() == 2);
  CHECK(read_latex("\\mathrm").parts.at(0).text.empty());
  CHECK(read_latex("a_{\\sqrt").parts.size() == 1);
}

TEST_CASE("depth costs no square of it, and no stack") {
  for (const std::string piece : {"\\frac ", "{", "\\sqrt", "x^"}) {
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += piece;
    CHECK(width(read_latex(deep)) < 1000);
  }
}

TEST_CASE("a short formula is one line") {
  CHECK(latex_lines("a + b - c", 40) == std::vector<std::string>{"a + b - c"});
}

TEST_CASE("a long one is broken before signs, at the outermost brackets") {
  const auto lines = latex_lines("aaaaaaaa + bbbbbbbb (c + d) - eeeeeeee", 16);
  REQUIRE(lines.size() > 1);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    CHECK((lines[i][0] == '+' || lines[i][0] == '-'));
  }
}

TEST_CASE("tall brackets are completed on both sides of a break") {
  const auto lines = latex_lines("\\left( aaaaaaaaaaaa + bbbbbbbbbbbb \\right) c", 14);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].find("\\right.") != std::string::npos);
  CHECK(lines[1].find("\\left.") == 0);
}

TEST_CASE("LaTeX becomes MathML") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"m l^{2}", "<mi>m</mi><msup><mi>l</mi><mn>2</mn></msup>"},
      {"\\frac{1}{2} x", "<mfrac><mn>1</mn><mn>2</mn></mfrac><mi>x</mi>"},
      {"\\sqrt{x}", "<msqrt><mi>x</mi></msqrt>"},
      {"a - b", "<mi>a</mi><mo>−</mo><mi>b</mi>"},
      {"\\theta", "<mi>θ</mi>"},
      {"\u03b8_{1}", "<msub><mi>\u03b8</mi><mn>1</mn></msub>"},
      {"q_{1}", "<msub><mi>q</mi><mn>1</mn></msub>"},
      {"\\mathbf{q}", "<mi>𝐪</mi>"},
      {"\\mathbf{bias}", "<mi>𝐛𝐢𝐚𝐬</mi>"},
      {"\\boldsymbol{\\tau}", "<mi>𝛕</mi>"},
  };
  for (const auto& [latex, expected] : rows) {
    INFO(latex);
    CHECK(mathml(read_latex(latex)) == expected);
  }
}
