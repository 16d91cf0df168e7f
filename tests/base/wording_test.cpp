// Text for TOML files and for messages: escapes, alignment, line breaks, quotes and suggestions.
#include "elgen/wording.hpp"

#include <catch2/catch.hpp>

#include "base/toml_text.hpp"
#include "elgen/diagnostic.hpp"

using namespace elgen;

TEST_CASE("a string is escaped") {
  CHECK(toml_string("a") == "\"a\"");
  CHECK(toml_string("a\"\\\n") == R"("a\"\\\u000A")");
  CHECK(toml_string("a\u202eb\x01") == R"("aU+202EbU+0001")");
}

TEST_CASE("an integer too wide for TOML is written as a string") {
  CHECK(toml_number("123") == "123");
  CHECK(toml_number("1234567890123456789") == "\"1234567890123456789\"");
  CHECK(toml_number("0.1234567890123456789") == "0.1234567890123456789");
}

TEST_CASE("a key that is a word needs no quotes") {
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

TEST_CASE("equals signs are aligned") {
  TomlTable table("[[frame]]");
  table.add("name", "\"a\"");
  table.add("parent", "\"b\"");
  CHECK(table.text() == "[[frame]]\nname   = \"a\"\nparent = \"b\"\n");
}

TEST_CASE("a column is as wide as its widest cell, and lines have no trailing blanks") {
  CHECK(align_columns({{"a", " 1"}, {"bcd", " 2"}, {"e", ""}}) ==
        std::vector<std::string>{"a   1", "bcd 2", "e"});
}

TEST_CASE("the last cell of a row may be longer than its column") {
  CHECK(align_columns({{"a  ", "b  ", "c"}, {"d  ", "long enough"}}) ==
        std::vector<std::string>{"a  b  c", "d  long enough"});
}

TEST_CASE("lines break at blanks, and a word longer than the line gets its own line") {
  CHECK(break_lines("a bc de", 4, "  ") == "a bc\n  de");
  CHECK(break_lines("a longer word", 4, "") == "a\nlonger\nword");
  CHECK(break_lines("", 4, "  ").empty());
}

TEST_CASE("user text is escaped and joined to one line for messages") {
  CHECK(quote_text("m") == "`m`");
  CHECK(quote_text(std::string_view("\0", 1)) == "`U+0000`");
  CHECK(quote_text("\x7F") == "`U+007F`");
  CHECK(quote_text("a\u202Eb\u2028") == "`aU+202EbU+2028`");
  CHECK(quote_text("a\n\t  + b") == "`a + b`");
  CHECK(quote_text("a\r\nb") == "`a b`");
}

TEST_CASE("long text is cut between characters, and at invalid UTF-8") {
  CHECK(quote_text(std::string(60, 'a')) == "`" + std::string(60, 'a') + "`");
  CHECK(quote_text(std::string(61, 'a')) == "`" + std::string(60, 'a') + "…`");
  CHECK(quote_text(std::string(59, 'a') + "éé") == "`" + std::string(59, 'a') + "é…`");
  CHECK(quote_text("a\xFF") == "`a…`");
}

TEST_CASE("a span is quoted by the text that it covers") {
  const SourcePointer source = make_source("m.toml", "a +\n b");
  CHECK(in_backticks(Span{source.get(), 0, 6}) == "`a + b`");
}

TEST_CASE("nouns are counted") {
  CHECK(count_text(1, "component") == "1 component");
  CHECK(count_text(0, "component") == "0 components");
}

TEST_CASE("a suggestion is a question or empty") {
  CHECK(suggestion("mas", {"mass", "force"}) == "did you mean `mass`?");
  CHECK(suggestion("zzz", {"mass"}).empty());
}

TEST_CASE("the nearest candidate is suggested") {
  const std::vector<std::string> names{"theta", "mass_matrix", "m", "omega", "coordinate"};
  CHECK(nearest_word("thta", names) == "theta");
  CHECK(nearest_word("theat", names) == "theta");  // a transposition is one edit
  CHECK(nearest_word("mas_matrx", names) == "mass_matrix");
  CHECK(nearest_word("mq", names) == "m");
  CHECK(nearest_word("coordinates", names) == "coordinate");
}

TEST_CASE("nothing is suggested if no candidate is near") {
  CHECK(nearest_word("velocity", {"theta", "m"}).empty());
  CHECK(nearest_word("q", {"x", "y"}).empty());
  CHECK(nearest_word("", {"a"}).empty());
  CHECK(nearest_word(std::string(100, 'a'), {std::string(99, 'a')}).empty());
}

TEST_CASE("the first of equally near candidates is suggested") {
  CHECK(nearest_word("ac", {"ab", "ad"}) == "ab");
}
