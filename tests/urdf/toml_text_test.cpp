// TOML: quoting, numbers and tables.
#include "urdf/toml_text.hpp"

#include <catch2/catch.hpp>

namespace elgen::test {

TEST_CASE("a string is escaped") {
  CHECK(urdf::toml_string("a") == "\"a\"");
  CHECK(urdf::toml_string("a\"\\\n") == R"("a\"\\\u000A")");
  CHECK(urdf::toml_string("a\u202eb\x01") == R"("aU+202EbU+0001")");
}

TEST_CASE("an integer wider than TOML's is a string") {
  CHECK(urdf::toml_number("123") == "123");
  CHECK(urdf::toml_number("1234567890123456789") == "\"1234567890123456789\"");
  CHECK(urdf::toml_number("0.1234567890123456789") == "0.1234567890123456789");
}

TEST_CASE("a comment is one line") {
  CHECK(urdf::comment("a\nb") == "# a?b\n");
  CHECK(urdf::comment("") == "#\n");
}

TEST_CASE("equals signs stand in a column") {
  urdf::Table table("[[frame]]");
  table.add("name", "\"a\"");
  table.add("parent", "\"b\"");
  CHECK(table.text() == "[[frame]]\nname   = \"a\"\nparent = \"b\"\n");
  CHECK(urdf::toml_list({"1", "2"}) == "[1, 2]");
}

}  // namespace elgen::test
