#include <catch2/catch.hpp>

#include "render/small_sheet.hpp"

using namespace elgen;
using namespace elgen::testing;

TEST_CASE("text is escaped, formulas are not") {
  const std::string latex = latex_document(small_sheet());
  CHECK(has(latex, "A \\& B\\_1"));
  CHECK(has(latex, "100 \\% of x \\textless{} y"));
  CHECK(has(latex, "$m_{1}$ & \\texttt{m1} & 0.5 & kg & mass \\textbar{} of *one* \\\\\n"));
  CHECK(has(latex, "\\end{document}\n"));
}
