// What several systems have in common is said once; what is much is counted.
#include "diff/summary.hpp"

#include <catch2/catch.hpp>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

DiffReport twice(const SystemChange& system) {
  SystemChange other = system;
  other.name = "other";
  return {.systems = {system, other}};
}

}  // namespace

TEST_CASE("a cause that two systems share is one line") {
  const SystemChange system = compared(spring(), spring("k*x^2"));
  const std::string text = text_of(summary(twice(system), false));
  CHECK(count(text, "[energy] V: 1/2*k*x^2 -> k*x^2") == 1);
  CHECK(mentions(text, "spring 11 of 25, other 11 of 25"));
}

TEST_CASE("keys beyond five are counted") {
  SystemChange system{.impact = Impact::values};
  for (const char* const name : {"a", "b", "c", "d", "e", "f", "g"}) {
    system.keys.push_back({.table = "model", .entry = "[model]", .path = {{name}}, .after = "1"});
  }
  const DiffReport report{.systems = {system}};
  CHECK(mentions(text_of(summary(report, false)), "2 keys more (--list)\n"));
  CHECK(mentions(text_of(summary(report, true)), "[model] g is new: 1\n"));
}

TEST_CASE("operations are told where all of them are known") {
  SystemChange system{.impact = Impact::equal, .keys = {{.entry = "[energy]", .after = "1"}}};
  CHECK_FALSE(mentions(text_of(summary({.systems = {system}}, false)), "operations"));
  system.operations.emplace();
  CHECK(mentions(text_of(summary({.systems = {system}}, false)), "operations   unchanged\n"));
  system.operations->push_back({"bias", {.mul = 3}, {.mul = 4}});
  CHECK(
      mentions(text_of(summary({.systems = {system}}, false)), "operations   bias: mul 3 -> 4\n"));
}

TEST_CASE("entries are listed by their systems") {
  const auto lists = entry_lists(twice(compared(spring(), spring("k*x^2"))));
  REQUIRE(lists.size() == 2);
  CHECK(lists[1].system == "other");
  CHECK(mentions(lists[0].lines[0], "gravity = k*x -> 2*k*x, difference k*x"));
}
