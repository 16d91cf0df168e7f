#include <catch2/catch.hpp>

#include "render/latex_tree.hpp"

using namespace elgen;

TEST_CASE("LaTeX becomes MathML") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"m l^{2}", "<mi>m</mi><msup><mi>l</mi><mn>2</mn></msup>"},
      {"\\frac{1}{2} x", "<mfrac><mn>1</mn><mn>2</mn></mfrac><mi>x</mi>"},
      {"\\sqrt{x}", "<msqrt><mi>x</mi></msqrt>"},
      {"a - b", "<mi>a</mi><mo>−</mo><mi>b</mi>"},
      {"\\theta", "<mi>θ</mi>"},
      {"\u03b8_{1}", "<msub><mi>\u03b8</mi><mn>1</mn></msub>"},
      {"q_{1}", "<msub><mi>q</mi><mn>1</mn></msub>"},
  };
  for (const auto& [latex, expected] : rows) {
    INFO(latex);
    CHECK(mathml(read_latex(latex)) == expected);
  }
}
