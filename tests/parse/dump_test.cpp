// The text of a syntax tree.
#include <catch2/catch.hpp>

#include "parse_testing.hpp"

using namespace elgen;

TEST_CASE("a model prints in file order with the places of its headers", "[parse]") {
  CHECK(testing::model_answer("format = 1\n\n[model]\nname = \"m\"\ntitle = \"a \\\"b\\\"\\nc\"\n"
                              "[[coordinate]]\nname = \"q[i]\"\nfor = \"i in 1..2\"\nwrap = true\n"
                              "start = {value = \"pi/4\"}\n") ==
        "1:1 []\n  format = 1\n3:1 [model]\n  name = m\n  title = \"a \\\"b\\\"\\nc\"\n"
        "6:1 [coordinate]\n  name = q[i]\n  for = [{index = i, low = 1, high = 2}]\n"
        "  wrap = true\n  start = {value = (pi / 4)}\n");
}

TEST_CASE("a scene prints likewise", "[parse]") {
  CHECK(testing::scene_answer("format = 1\nmodel = \"../m.toml\"\nname = \"s\"\n[outputs]\n"
                              "bias = true\ngravity = {rename = \"g\"}\n[sizes]\nn = 3\n") ==
        "1:1 []\n  format = 1\n  model = \"../m.toml\"\n  name = s\n4:1 [outputs]\n"
        "  bias = true\n  gravity = {rename = g}\n7:1 [sizes]\n  n = 3\n");
}

TEST_CASE("expressions print fully bracketed", "[parse]") {
  CHECK(testing::expression_answer("a-b*c/d^2") == "(a + (-((b * c) / (d^2))))");
  CHECK(testing::expression_answer("sum(i, 1, n, m[i])") == "sum(i, 1, n, m[i])");
}
