// A comment on a pull request.
#include <catch2/catch.hpp>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("equations stand in blocks of code, all entries behind a fold") {
  const std::string text = to_markdown({.systems = {compared(spring(), spring("k*x^2"))}});
  CHECK(starts_with(text, "### elgen diff: different (the equations differ)\n\n```text\nchanged "));
  CHECK(mentions(text, "\n```\n\n<details><summary>Entries of spring</summary>\n\n```text\n"));
  CHECK(text.ends_with("\n```\n\n</details>\n"));
}

TEST_CASE("back-ticks of a text do not end its block") {
  SystemChange system{.impact = Impact::values};
  system.keys.push_back({.entry = "[model]", .path = {{"doc"}}, .after = "```"});
  CHECK(mentions(to_markdown({.systems = {system}}), "\n````text\n"));
}

TEST_CASE("where nothing differs there is a heading alone") {
  CHECK(to_markdown({}) == "### elgen diff: equal (the equations are the same)\n");
}
