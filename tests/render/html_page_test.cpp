#include <catch2/catch.hpp>

#include "render/small_sheet.hpp"

using namespace elgen;
using namespace elgen::testing;

TEST_CASE("text is escaped, vectors are tables of one column") {
  const std::string html = html_page(small_sheet());
  CHECK(has(html, "<title>A &amp; B_1</title>"));
  CHECK(has(html, "100 % of x &lt; y"));
  CHECK(has(html, "<mtr><mtd><mrow><mn>0</mn></mrow></mtd></mtr>"));
}
