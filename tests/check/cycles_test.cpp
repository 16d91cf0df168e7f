// Cycles, printed from their first entry, and long chains without one.
#include <catch2/catch.hpp>
#include <utility>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

TEST_CASE("cycles are printed from the entry that stands first") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"[define]\na = \"a + 1\"\n", "E206 13:1 `a` is defined by itself: a -> a\n"},
      {"[define]\nb = \"c\"\nc = \"d\"\nd = \"c + b\"\n",
       "E206 14:1 `c` is defined by itself: c -> d -> c\n"},
      {"[[point]]\nname = \"p\"\nat = [\"x(r)\", \"0\"]\n[[point]]\nname = \"r\"\nat = [\"y(p)\", "
       "\"0\"]\n",
       "E206 13:9 `p` is defined by itself: p -> r -> p\n"},
      {"[define]\na = \"x(p)\"\n[[point]]\nname = \"p\"\nat = [\"a\", \"0\"]\n",
       "E206 13:1 `a` is defined by itself: a -> p -> a\n"},
      {"[define]\na = \"h\"\n[[prescribed]]\nname = \"h\"\nvalue = \"a\"\n",
       "E206 13:1 `a` is defined by itself: a -> h -> a\n"},
  };
  for (const auto& [entries, expected] : rows) {
    INFO(entries);
    CHECK(messages(block(entries)) == expected);
  }
}

TEST_CASE("a chain of definitions may be as long as the limit allows") {
  std::string text = block("[define]\nd0 = \"k*0.5\"\n");
  for (int i = 1; i < 19'000; ++i) {
    text += "d" + std::to_string(i) + " = \"d" + std::to_string(i - 1) + "\"\n";
  }
  Wanted wanted;
  CHECK(messages(text, wanted).empty());
}

TEST_CASE("a definition may use one that stands below it") {
  CHECK(messages(block("V = \"a*x\"\n[define]\na = \"b\"\nb = \"k*x\"\n")).empty());
  // Its unit is known all the same.
  CHECK(messages(block("V = \"a*x\"\n[define]\na = \"b\"\nb = \"k\"\n")) ==
        "E403 12:6 `a*x` is in N, but V is in J\n");
}

}  // namespace
}  // namespace elgen::test
