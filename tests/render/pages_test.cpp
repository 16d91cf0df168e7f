// Pages: each language escapes what is its markup, formulas stay, and what is empty is absent.
#include <catch2/catch.hpp>

#include "render/small_sheet.hpp"

using namespace elgen;
using namespace elgen::testing;

TEST_CASE("text is escaped in every language, vectors are columns") {
  struct PageRow {
    std::string (*page)(const Sheet& sheet);
    std::string part;
  };
  const PageRow row = GENERATE(values<PageRow>({
      {html_page, "<title>A &amp; B_1</title>"},
      {html_page, "100 % of x &lt; y"},
      {html_page, "<mtr><mtd><mrow><mn>0</mn></mrow></mtd></mtr>"},
      {latex_document, "A \\& B\\_1"},
      {latex_document, "100 \\% of x \\textless{} y"},
      {latex_document, "$m_{1}$ & \\texttt{m1} & 0.5 & kg & mass \\textbar{} of *one* \\\\\n"},
      {latex_document, "\\end{document}\n"},
      {markdown_page, "# A \\& B\\_1\n"},
      {markdown_page, "100 % of x \\< y\n"},
      {markdown_page, "| $m_{1}$ | `m1` | 0.5 | kg | mass \\| of \\*one\\* |"},
      {markdown_page, "$$\ng = \\begin{pmatrix}\n0 \\\\\nm_{1} g\n\\end{pmatrix}\n$$"},
  }));
  INFO(row.part);
  CHECK(has(row.page(small_sheet()), row.part));
}

TEST_CASE("sections of what is empty are absent") {
  const std::string page = markdown_page(small_sheet());
  CHECK(has(page, "`gravity`"));
  CHECK(has(page, "M \\ddot{q} = 0"));
  Sheet sheet = small_sheet();
  sheet.parameters.clear();
  CHECK_FALSE(has(markdown_page(sheet), "| "));
}

TEST_CASE("text of several lines, with dollars and back-ticks, stays in its row") {
  Sheet sheet = small_sheet();
  sheet.parameters.front().doc = "one\ntwo for $5 and `six`";
  CHECK(has(markdown_page(sheet), "| kg | one two for \\$5 and \\`six\\` |\n"));
}

TEST_CASE("links and images of titles are text") {
  Sheet sheet = small_sheet();
  sheet.title = "[here](http://a) ![](http://b/c.png) <img src=x> &#33;";
  CHECK(has(markdown_page(sheet),
            "# \\[here\\](http://a) !\\[\\](http://b/c.png) \\<img src=x> \\&#33;\n"));
}
