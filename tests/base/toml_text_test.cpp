// TOML: quoting, numbers, tables and columns.
#include "base/toml_text.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("a string is escaped") {
  CHECK(toml_string("a") == "\"a\"");
  CHECK(toml_string("a\"\\\n") == R"("a\"\\\u000A")");
  CHECK(toml_string("a\u202eb\x01") == R"("aU+202EbU+0001")");
}

TEST_CASE("an integer wider than TOML's is a string") {
  CHECK(toml_number("123") == "123");
  CHECK(toml_number("1234567890123456789") == "\"1234567890123456789\"");
  CHECK(toml_number("0.1234567890123456789") == "0.1234567890123456789");
}

TEST_CASE("a key is bare where it is a word") {
  CHECK(toml_key("theta_1") == "theta_1");
  CHECK(toml_key("dot(theta)") == "\"dot(theta)\"");
  CHECK(toml_key("") == "\"\"");
}

TEST_CASE("lists and inline tables") {
  CHECK(toml_list({"1", "2"}) == "[1, 2]");
  CHECK(toml_inline_table({"a = 1", "b = 2"}) == "{ a = 1, b = 2 }");
}

TEST_CASE("a comment is one line") {
  CHECK(toml_comment("a\nb") == "# a?b\n");
  CHECK(toml_comment("") == "#\n");
}

TEST_CASE("equals signs stand in a column") {
  TomlTable table("[[frame]]");
  table.add("name", "\"a\"");
  table.add("parent", "\"b\"");
  CHECK(table.text() == "[[frame]]\nname   = \"a\"\nparent = \"b\"\n");
}

TEST_CASE("a column is as wide as its widest cell, and no line ends with blanks") {
  CHECK(aligned({{"a", " 1"}, {"bcd", " 2"}, {"e", ""}}) ==
        std::vector<std::string>{"a   1", "bcd 2", "e"});
}

TEST_CASE("the last cell of a row may be longer than its column") {
  CHECK(aligned({{"a  ", "b  ", "c"}, {"d  ", "long enough"}}) ==
        std::vector<std::string>{"a  b  c", "d  long enough"});
}
