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

TEST_CASE("a system that breaks, is gone or cannot be read is one line, with the reason") {
  const std::string reversed = edited(edited(spring(), "k = 3\n", ""), "m = {", "k = 3\nm = {");
  const DiffReport report{.systems = {compared(spring(), reversed)},
                          .removed = {"old.toml"},
                          .unreadable = {{"new.toml", {Code::E201, {}, "unknown name `z`"}}}};
  const std::string text = to_annotations(report);
  CHECK(count(text, "::error ") == 3);
  CHECK(starts_with(text, "::error file=model.toml,"));
  CHECK(mentions(text,
                 ",title=elgen diff%3A breaks::spring: members of Parameters are in another order: "
                 "m, k -> k, m; callers compile and mean something else\n"));
  CHECK(mentions(text, "::error title=elgen diff%3A breaks::old.toml is gone\n"));
  CHECK(
      mentions(text, "::error title=elgen diff%3A unreadable::new.toml: E201: unknown name `z`\n"));
}

TEST_CASE("ten causes are shown, the last one counts the others") {
  SystemChange system{.impact = Impact::different};
  for (int i = 0; i < 12; ++i) {
    system.keys.push_back({.entry = "[model]", .path = {{std::to_string(i)}}, .after = "1"});
  }
  const std::string text = to_annotations({.systems = {system, system}});
  CHECK(count(text, "\n") == 10);
  CHECK(mentions(text, "::3 keys more changed\n"));
}
