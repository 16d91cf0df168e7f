// Blocks of text and displays of formulas: how wide they are, and how they are broken.
#include "render/display.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "render/drawing.hpp"

using namespace elgen;

namespace {

std::string sum_of(int terms) {
  std::string text = "x";
  for (int i = 1; i < terms; ++i) text += " + x";
  return text;
}

}  // namespace

TEST_CASE("a fraction wider than the page stands in front of the lines of its numerator") {
  const auto parts = displays({"a", 1, 1, {"-\\frac{" + sum_of(60) + "}{m + l}"}});
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].texts.size() > 2);
  CHECK(parts[0].texts[0].starts_with("-\\frac{1}{m + l} \\left( x + x"));
  std::ptrdiff_t terms = 0;
  for (const std::string& text : parts[0].texts) {
    CHECK(width(read_latex(text)) < 78);
    terms += std::ranges::count(text, 'x');
  }
  CHECK(terms == 60);
}

TEST_CASE("so does one in a product of a sum") {
  const std::string wide = "\\frac{" + sum_of(60) + "}{m_{1} + l}";
  const auto parts = displays({"a", 1, 1, {"k \\left( \\frac{1}{m} - " + wide + " \\right)"}});
  REQUIRE(parts.size() == 1);
  CHECK(
      parts[0].texts[0].starts_with("k \\left( \\frac{1}{m} - \\frac{1}{m_{1} + l} \\left( x + x"));
}

TEST_CASE("the factors in front of a bracket stay above the fraction") {
  const auto parts = displays({"a", 1, 1, {"\\frac{g l (" + sum_of(60) + ")}{m}"}});
  CHECK(parts.at(0).texts.at(0).starts_with("\\frac{g l}{m} (x + x"));
}

TEST_CASE("one over what is wider than the page is a power") {
  const auto parts = displays({"a", 1, 1, {"c - \\frac{1}{" + sum_of(60) + "} b"}});
  CHECK(parts.at(0).texts.at(0).starts_with("c - \\left( x + x"));
  CHECK(parts.at(0).texts.back().ends_with("+ x \\right)^{-1} b"));
  for (const std::string& text : parts[0].texts) CHECK(width(read_latex(text)) < 78);
  const auto root = displays({"a", 1, 1, {"\\frac{1}{\\sqrt{" + sum_of(60) + "}}"}});
  CHECK(root.at(0).texts.back().ends_with("+ x \\right)^{-1/2}"));
}

TEST_CASE("equations are one block, aligned at their signs") {
  const auto blocks = aligned_blocks({{"T", 1, 1, {"a"}}, {"\\dot{x}", 2, 1, {"b", "c"}}});
  REQUIRE(blocks.size() == 1);
  CHECK(latex_block(blocks[0]) ==
        "\\begin{aligned}\nT &= a \\\\\n\\dot{x} &= \\begin{pmatrix}\nb \\\\\nc\n\\end{pmatrix}\n"
        "\\end{aligned}");
}

TEST_CASE("a left side that takes most of a line stands alone, and is broken") {
  const auto blocks =
      aligned_blocks({{"T", 1, 1, {"a"}}, {sum_of(40), 1, 1, {"0"}}, {"V", 1, 1, {"b"}}});
  REQUIRE(blocks.size() == 3);
  const std::string latex = latex_block(blocks[1]);
  CHECK(latex.starts_with("\\begin{aligned}\n& x + x"));
  CHECK(latex.ends_with("+ x = 0\n\\end{aligned}"));
  CHECK(latex_block(blocks[2]) == "V = b");
}

TEST_CASE("lines of a block have room beside its longest left side") {
  const auto blocks = aligned_blocks({{"T", 1, 1, {sum_of(20)}}, {sum_of(6), 1, 1, {"a"}}});
  REQUIRE(blocks.size() == 1);
  REQUIRE(blocks[0].size() == 2);
  CHECK(blocks[0][0].texts.size() == 2);
}

TEST_CASE("vectors are bold, their components are not") {
  const auto list = displays({"\\mathbf{g}", 2, 1, {sum_of(40), "m"}});
  REQUIRE(list.size() == 2);
  CHECK(list[0].left == "g_{1}");
  CHECK(displays({"\\ddot{\\mathbf{q}}", 1, 1, {"x"}}).at(0).left == "\\ddot{q}");
  CHECK(displays({"\\mathbf{bias}", 1, 1, {"x"}}).at(0).left == "\\mathrm{bias}");
  CHECK(displays({"\\mathbf{g}", 2, 1, {"x", "y"}}).at(0).left == "\\mathbf{g}");
}

TEST_CASE("a fraction that fits stays one") {
  CHECK(displays({"a", 1, 1, {"\\frac{x}{m + l}"}}).size() == 1);
}

TEST_CASE("what does not fit as a matrix is written entry by entry, without zeros") {
  const auto parts = displays({"M", 2, 2, {sum_of(30), "0", "0", "m"}});
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].left == "M_{1, 1}");
  CHECK(parts[1].left == "M_{2, 2}");
}

TEST_CASE("a matrix that fits is one") {
  const auto parts = displays({"M", 2, 2, {"a", "b", "b", "c"}});
  REQUIRE(parts.size() == 1);
  CHECK(latex_block(parts) == "M = \\begin{pmatrix}\na & b \\\\\nb & c\n\\end{pmatrix}");
}

TEST_CASE("accents that combine take no column") {
  CHECK(columns_of("θ̇₁") == 2);
  CHECK(columns_of("q̈") == 1);
  CHECK(columns_of("m l²") == 4);
}

TEST_CASE("blocks stand on one base line") {
  const Block half = stacked({{"1"}, 0}, {{"2"}, 0}, "-");
  const Block drawn = beside(half, {{" m"}, 0});
  CHECK(text_of(drawn, "") == "1\n- m\n2\n");
  CHECK(text_of(beside({{"m "}, 0}, half), "  ") == "    1\n  m -\n    2\n");
}

TEST_CASE("a fraction is as wide as its wider part") {
  CHECK(text_of(stacked({{"a + b"}, 0}, {{"c"}, 0}, "-"), "") == "a + b\n-----\n  c\n");
}

TEST_CASE("cells of a grid are centred, or stand at the left") {
  const std::vector<Block> cells{{{"a + b"}, 0}, {{"c"}, 0}, {{"d"}, 0}, {{"e"}, 0}};
  CHECK(text_of(grid(cells, 2), "") == "a + b   c\n  d     e\n");
  CHECK(text_of(grid(cells, 2, Alignment::left), "") == "a + b   c\nd       e\n");
}

TEST_CASE("a blank line parts the rows of a grid where cells are tall") {
  const Block half = stacked({{"1"}, 0}, {{"2"}, 0}, "-");
  CHECK(text_of(grid({half, {{"x"}, 0}}, 1), "") == "1\n-\n2\n\nx\n");
}

TEST_CASE("brackets are as high as what stands beside them") {
  const BracketPieces pieces{"(", "/", "|", "\\"};
  CHECK(text_of(stretched(pieces, {{"x"}, 0}), "") == "(\n");
  CHECK(text_of(stretched(pieces, {{"x", "y", "z"}, 1}), "") == "/\n|\n\\\n");
}
