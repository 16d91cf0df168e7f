#include "render/symbols.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("names become symbols") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"x", "x"},        {"theta", "\\theta"}, {"theta1", "\\theta_{1}"},
      {"l[2]", "l_{2}"}, {"Omega", "\\Omega"}, {"mass", "\\mathrm{mass}"},
  };
  for (const auto& [name, expected] : rows) {
    INFO(name);
    CHECK(latex_symbol(name).text() == expected);
  }
}

TEST_CASE("a model's own LaTeX is taken") {
  CHECK(latex_symbol("phi", "\\varphi").text() == "\\varphi");
}

TEST_CASE("Greek letters by their command") {
  CHECK(greek_letter("theta") == "θ");
  CHECK(greek_letter("cart").empty());
}
