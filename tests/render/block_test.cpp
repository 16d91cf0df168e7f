#include "render/block.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

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
