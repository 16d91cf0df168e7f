#include <catch2/catch.hpp>

#include "render/latex_tree.hpp"

using namespace elgen;

TEST_CASE("a short formula is one line") {
  CHECK(latex_lines("a + b - c", 40) == std::vector<std::string>{"a + b - c"});
}

TEST_CASE("a long one is broken before signs, at the outermost brackets") {
  const auto lines = latex_lines("aaaaaaaa + bbbbbbbb (c + d) - eeeeeeee", 16);
  REQUIRE(lines.size() > 1);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    CHECK((lines[i][0] == '+' || lines[i][0] == '-'));
  }
}

TEST_CASE("tall brackets are completed on both sides of a break") {
  const auto lines = latex_lines("\\left( aaaaaaaaaaaa + bbbbbbbbbbbb \\right) c", 14);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].find("\\right.") != std::string::npos);
  CHECK(lines[1].find("\\left.") == 0);
}
