// Causes, as GitHub shows them.
#include <catch2/catch.hpp>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("a cause stands at its place") {
  CHECK(to_annotations({.systems = {compared(cart, edited(cart, "\"-g\"", "\"g\""))}}) ==
        "::warning file=model.toml,line=55,col=17,title=elgen diff%3A different (the equations "
        "differ)::[gravity] vector[2]: -g -> g\n");
  CHECK(starts_with(
      to_annotations({.systems = {compared(spring("k*(1 - cos(x))"), spring("2*k*sin(x/2)^2"))}}),
      "::notice file="));
}

TEST_CASE("ten are shown, the last one counts the others") {
  SystemChange system{.impact = Impact::different};
  for (int i = 0; i < 12; ++i) {
    system.keys.push_back({.entry = "[model]", .path = {{std::to_string(i)}}, .after = "1"});
  }
  const std::string text = to_annotations({.systems = {system, system}});
  CHECK(count(text, "\n") == 10);
  CHECK(mentions(text, "::3 keys more changed\n"));
}
