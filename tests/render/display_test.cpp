#include "render/display.hpp"

#include <catch2/catch.hpp>

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
