// Pages of small sheets: what is escaped, and how formulas are laid out.
#include <catch2/catch.hpp>

#include "elgen/render.hpp"
#include "render/display.hpp"
#include "render/latex_tree.hpp"

using namespace elgen;

namespace {

Sheet small_sheet() {
  Sheet sheet;
  sheet.title = "A & B_1";
  sheet.description = "100 % of x < y";
  sheet.equation_of_motion = "M \\ddot{q} = 0";
  sheet.parameters = {{"m_{1}", "m1", "kg", "0.5", "mass | of *one*"}};
  sheet.outputs = {{"gravity", "Slope.", "", {{"g", 2, 1, {"0", "m_{1} g"}}}}};
  return sheet;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("text is escaped for each notation") {
  const std::string latex = latex_document(small_sheet());
  CHECK(has(latex, "A \\& B\\_1"));
  CHECK(has(latex, "100 \\% of x < y"));
  const std::string html = html_page(small_sheet());
  CHECK(has(html, "<title>A &amp; B_1</title>"));
  CHECK(has(html, "100 % of x &lt; y"));
  const std::string markdown = markdown_page(small_sheet());
  CHECK(has(markdown, "# A & B\\_1\n"));
  CHECK(has(markdown, "| $m_{1}$ | `m1` | 0.5 | kg | mass \\| of \\*one\\* |"));
}

TEST_CASE("vectors are columns") {
  CHECK(has(markdown_page(small_sheet()),
            "$$\ng = \\begin{pmatrix}\n0 \\\\\nm_{1} g\n\\end{pmatrix}\n$$"));
  CHECK(has(html_page(small_sheet()), "<mtr><mtd><mrow><mn>0</mn></mrow></mtd></mtr>"));
}

TEST_CASE("a fraction wider than the page is written in three lines") {
  std::string wide = "x";
  for (int i = 0; i < 60; ++i) wide += " + x";
  const auto displays = rendering::displays({"a", 1, 1, {"-\\frac{" + wide + "}{m + l}"}});
  REQUIRE(displays.size() == 3);
  CHECK(displays[0].texts[0] == "-\\frac{\\mathrm{numerator}}{\\mathrm{denominator}}");
  CHECK(displays[1].left == "\\mathrm{numerator}");
  CHECK(displays[1].texts.size() > 1);
  CHECK(displays[2].texts[0] == "m + l");
}

TEST_CASE("what does not fit as a matrix is written entry by entry, without zeros") {
  std::string wide = "x";
  for (int i = 0; i < 30; ++i) wide += " + x";
  const auto displays = rendering::displays({"M", 2, 2, {wide, "0", "0", "m"}});
  REQUIRE(displays.size() == 2);
  CHECK(displays[0].left == "M_{1, 1}");
  CHECK(displays[1].left == "M_{2, 2}");
}

TEST_CASE("LaTeX becomes MathML") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"m l^{2}", "<mi>m</mi><msup><mi>l</mi><mn>2</mn></msup>"},
      {"\\frac{1}{2} x", "<mfrac><mn>1</mn><mn>2</mn></mfrac><mi>x</mi>"},
      {"\\sqrt{x}", "<msqrt><mi>x</mi></msqrt>"},
      {"a - b", "<mi>a</mi><mo>−</mo><mi>b</mi>"},
      {"\\theta", "<mi>θ</mi>"},
  };
  for (const auto& [latex, expected] : rows) {
    INFO(latex);
    CHECK(rendering::mathml(rendering::read_latex(latex)) == expected);
  }
}
