// Blocks of text and displays of formulas: how wide they are, and how they are broken.
#include "render/display.hpp"

#include <catch2/catch.hpp>

#include "render/block.hpp"

using namespace elgen;

namespace {

std::string sum_of(int terms) {
  std::string text = "x";
  for (int i = 1; i < terms; ++i) text += " + x";
  return text;
}

}  // namespace

TEST_CASE("a fraction wider than the page is written in three lines") {
  const auto parts = displays({"a", 1, 1, {"-\\frac{" + sum_of(60) + "}{m + l}"}});
  REQUIRE(parts.size() == 3);
  CHECK(parts[0].texts[0] == "-\\frac{\\mathrm{numerator}}{\\mathrm{denominator}}");
  CHECK(parts[1].left == "\\mathrm{numerator}");
  CHECK(parts[1].texts.size() > 1);
  CHECK(parts[2].texts[0] == "m + l");
}

TEST_CASE("a fraction wider than the page in a product of a sum is written in three lines, too") {
  const std::string wide = "\\frac{" + sum_of(60) + "}{m_{1} + l}";
  const auto parts = displays({"a", 1, 1, {"k \\left( \\frac{1}{m} - " + wide + " \\right)"}});
  REQUIRE(parts.size() == 3);
  CHECK(parts[0].texts == std::vector<std::string>{"k \\left( \\frac{1}{m} - "
                                                   "\\frac{\\mathrm{numerator}}"
                                                   "{\\mathrm{denominator}} \\right)"});
  CHECK(parts[1].left == "\\mathrm{numerator}");
  CHECK(parts[2].texts[0] == "m_{1} + l");
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
  CHECK(latex_block(parts[0]) == "M = \\begin{pmatrix}\na & b \\\\\nb & c\n\\end{pmatrix}");
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
