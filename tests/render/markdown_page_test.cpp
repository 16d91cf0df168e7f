#include <catch2/catch.hpp>

#include "render/small_sheet.hpp"

using namespace elgen;
using namespace elgen::testing;

TEST_CASE("what Markdown reads as markup is escaped") {
  const std::string markdown = markdown_page(small_sheet());
  CHECK(has(markdown, "# A \\& B\\_1\n"));
  CHECK(has(markdown, "| $m_{1}$ | `m1` | 0.5 | kg | mass \\| of \\*one\\* |"));
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

TEST_CASE("vectors are columns") {
  CHECK(has(markdown_page(small_sheet()),
            "$$\ng = \\begin{pmatrix}\n0 \\\\\nm_{1} g\n\\end{pmatrix}\n$$"));
}
