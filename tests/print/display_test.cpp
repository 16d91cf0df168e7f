// Displayed formulas: their width and their line breaks.
#include "print/display.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace elgen;

namespace {

std::string sum_of(int terms) {
  std::string text = "x";
  for (int i = 1; i < terms; ++i) text += " + x";
  return text;
}

TypesetEquation equation(const std::string& left, std::uint32_t rows, std::uint32_t columns,
                         const std::vector<std::string>& entries) {
  TypesetEquation result{read_latex(left), rows, columns, {}};
  for (const std::string& entry : entries) result.entries.push_back(read_latex(entry));
  return result;
}

/// The displays of an equation a = `number`.
std::vector<DisplayedEquation> displays_of(const std::string& number) {
  return lay_out_equation(equation("a", 1, 1, {number}));
}

std::string first_line(const std::string& number) {
  return to_latex(displays_of(number).at(0).rows.at(0));
}

std::string last_line(const std::string& number) {
  return to_latex(displays_of(number).at(0).rows.back());
}

std::string left_of(const DisplayedEquation& display) { return to_latex(display.left); }

}  // namespace

TEST_CASE(
    "a fraction wider than the page becomes 1/denominator before the lines of its numerator") {
  const auto parts = displays_of("-\\frac{" + sum_of(60) + "}{m + l}");
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].rows.size() > 2);
  CHECK(to_latex(parts[0].rows[0]).starts_with("-\\frac{1}{m + l} \\left( x + x"));
  std::ptrdiff_t terms = 0;
  for (const Glyphs& row : parts[0].rows) {
    CHECK(width(row) < 78);
    terms += std::ranges::count(to_latex(row), 'x');
  }
  CHECK(terms == 60);
}

TEST_CASE("a wide fraction inside a product of a sum is split too") {
  const std::string wide = "\\frac{" + sum_of(60) + "}{m_{1} + l}";
  const std::string number = "k \\left( \\frac{1}{m} - " + wide + " \\right)";
  REQUIRE(displays_of(number).size() == 1);
  CHECK(first_line(number).starts_with(
      "k \\left( \\frac{1}{m} - \\frac{1}{m_{1} + l} \\left( x + x"));
}

TEST_CASE("factors before the last bracket of a numerator stay in the fraction") {
  const std::string sum = "(" + sum_of(60) + ")";
  const std::vector<std::pair<std::string, std::string>> rows{
      {"g l " + sum, "\\frac{g l}{m} (x + x"},
      {"g \\left( x " + sum + " \\right)", "\\frac{g}{m} \\left( x (x + x"},
      {"g \\cos" + sum, "\\frac{1}{m} g \\cos(x + x"},
      {sum + " c", "\\frac{1}{m} (x + x"}};
  for (const auto& [above, line] : rows) {
    INFO(above);
    CHECK(first_line("\\frac{" + above + "}{m}").starts_with(line));
  }
}

TEST_CASE("the reciprocal of a term wider than the page becomes a power") {
  const std::string number = "c - \\frac{1}{" + sum_of(60) + "} b";
  CHECK(first_line(number).starts_with("c - \\left( x + x"));
  CHECK(last_line(number).ends_with("+ x \\right)^{-1} b"));
  const std::vector<DisplayedEquation> displays = displays_of(number);
  for (const Glyphs& row : displays.at(0).rows) CHECK(width(row) < 78);
  CHECK(last_line("\\frac{1}{\\sqrt{" + sum_of(60) + "}}").ends_with("+ x \\right)^{-1/2}"));
}

TEST_CASE("equations are one block, aligned at their equals signs") {
  const auto blocks =
      aligned_blocks({equation("T", 1, 1, {"a"}), equation("\\dot{x}", 2, 1, {"b", "c"})});
  REQUIRE(blocks.size() == 1);
  CHECK(latex_block(blocks[0]) ==
        "\\begin{aligned}\nT &= a \\\\\n\\dot{x} &= \\begin{pmatrix}\nb \\\\\nc\n\\end{pmatrix}\n"
        "\\end{aligned}");
}

TEST_CASE("a left side that fills most of a line gets its own block and is broken") {
  const auto blocks = aligned_blocks(
      {equation("T", 1, 1, {"a"}), equation(sum_of(40), 1, 1, {"0"}), equation("V", 1, 1, {"b"})});
  REQUIRE(blocks.size() == 3);
  const std::string broken = latex_block(blocks[1]);
  CHECK(broken.starts_with("\\begin{aligned}\n& x + x"));
  CHECK(broken.ends_with("+ x = 0\n\\end{aligned}"));
  CHECK(latex_block(blocks[2]) == "V = b");
}

TEST_CASE("lines of a block leave room for its longest left side") {
  const auto blocks =
      aligned_blocks({equation("T", 1, 1, {sum_of(20)}), equation(sum_of(6), 1, 1, {"a"})});
  REQUIRE(blocks.size() == 1);
  REQUIRE(blocks[0].size() == 2);
  CHECK(blocks[0][0].rows.size() == 2);
}

TEST_CASE("vectors are bold, their components are not") {
  const auto list = lay_out_equation(equation("\\mathbf{g}", 2, 1, {sum_of(40), "m"}));
  REQUIRE(list.size() == 2);
  CHECK(left_of(list[0]) == "g_{1}");
  CHECK(left_of(lay_out_equation(equation("\\ddot{\\mathbf{q}}", 1, 1, {"x"})).at(0)) ==
        "\\ddot{q}");
  CHECK(left_of(lay_out_equation(equation("\\mathbf{bias}", 1, 1, {"x"})).at(0)) ==
        "\\mathrm{bias}");
  CHECK(left_of(lay_out_equation(equation("\\mathbf{g}", 2, 1, {"x", "y"})).at(0)) ==
        "\\mathbf{g}");
}

TEST_CASE("a fraction that fits is not split") {
  CHECK(displays_of("\\frac{x}{m + l}").size() == 1);
}

TEST_CASE("a matrix that does not fit is printed entry by entry, without zeros") {
  const auto parts = lay_out_equation(equation("M", 2, 2, {sum_of(30), "0", "0", "m"}));
  REQUIRE(parts.size() == 2);
  CHECK(left_of(parts[0]) == "M_{1, 1}");
  CHECK(left_of(parts[1]) == "M_{2, 2}");
}

TEST_CASE("a matrix that fits is printed as a matrix") {
  const auto parts = lay_out_equation(equation("M", 2, 2, {"a", "b", "b", "c"}));
  REQUIRE(parts.size() == 1);
  CHECK(latex_block(parts) == "M = \\begin{pmatrix}\na & b \\\\\nb & c\n\\end{pmatrix}");
}
