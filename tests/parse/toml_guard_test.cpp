// Keys of too many parts, which would end in a stack overflow inside toml++.
#include "parse/toml_guard.hpp"

#include <catch2/catch.hpp>

#include "parse_testing.hpp"

using namespace elgen;

using elgen::testing::repeated;

TEST_CASE("keys may have as many parts as the limit says, not one more", "[parse]") {
  CHECK_FALSE(find_endless_key(repeated("a.", most_key_parts - 1) + "a = 1"));
  CHECK(find_endless_key(repeated("a.", most_key_parts) + "a = 1") == 2 * most_key_parts - 1);
}

TEST_CASE("quotes and spaces do not hide a part", "[parse]") {
  CHECK(find_endless_key("[" + repeated("a . ", 200) + "a]"));
  CHECK(find_endless_key("x = {" + repeated("\"=,\\\"\".", 200) + "a = 1}"));
  CHECK(find_endless_key(repeated("'\"'.", 200) + "a = 1"));
}

TEST_CASE("what is no key is left alone", "[parse]") {
  CHECK_FALSE(find_endless_key("# " + repeated(".", 1000)));
  CHECK_FALSE(find_endless_key(repeated("1.5, ", 1000)));
  CHECK_FALSE(find_endless_key(repeated("a.b = 1\n", 1000)));
  CHECK_FALSE(find_endless_key("doc = \"" + repeated("A sentence. ", 1000)));
}

TEST_CASE("an endless key in a file is an error with a place", "[parse]") {
  CHECK(elgen::testing::model_answer(repeated("a.", 400'000) + "a = 1") == "E101 1:200");
}
