// Code points, malformed bytes, and the limits of classes of ASCII characters.
#include "base/utf8.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string_view>

#include "base/ascii.hpp"

using namespace elgen;

TEST_CASE("code points have their UTF-8 length") {
  CHECK(code_point_at("a", 0).value == U'a');
  CHECK(code_point_at("\u03C0", 0).value == 0x3C0);
  CHECK(code_point_at("\u03C0", 0).bytes == 2);
  CHECK(code_point_at("\u2212", 0).bytes == 3);
  CHECK(code_point_at("\U0001F600", 0).value == 0x1F600);
}

TEST_CASE("invalid UTF-8 is found at its first byte") {
  CHECK_FALSE(find_invalid_utf8("x + \u03C0"));
  CHECK(find_invalid_utf8("ab\xFF") == 2U);
  CHECK(find_invalid_utf8("\x80") == 0U);              // continuation without a start
  CHECK(find_invalid_utf8("a\xCF") == 1U);             // truncated
  CHECK(find_invalid_utf8("\xC0\xAF") == 0U);          // overlong encoding of /
  CHECK(find_invalid_utf8("\xED\xA0\x80") == 0U);      // surrogate
  CHECK(find_invalid_utf8("\xF4\x90\x80\x80") == 0U);  // beyond U+10FFFF
}

TEST_CASE("written code points are read back") {
  for (const char32_t value : {0x41U, 0x7FU, 0x80U, 0x7FFU, 0x800U, 0xFFFFU, 0x10000U, 0x10FFFFU}) {
    std::string text;
    append_utf8(text, value);
    CHECK(code_point_at(text, 0).value == value);
    CHECK(code_point_at(text, 0).bytes == text.size());
  }
}

TEST_CASE("code points have names") {
  CHECK(code_point_name(0x3C0) == "U+03C0");
  CHECK(code_point_name(0x1F600) == "U+1F600");
}

TEST_CASE("hidden characters are replaced by names, visible characters stay") {
  for (const char32_t value : {0x00U, 0x1BU, 0x7FU, 0x85U, 0xADU, 0x200BU, 0x200FU, 0x2028U,
                               0x202AU, 0x202EU, 0x2066U, 0x2069U, 0x3164U, 0xFEFFU, 0xE0041U}) {
    INFO(code_point_name(value));
    CHECK(is_hidden(value));
  }
  for (const char32_t value : {0x20U, 0x41U, 0xA0U, 0xE9U, 0x3C0U, 0x2212U, 0x1F600U}) {
    INFO(code_point_name(value));
    CHECK_FALSE(is_hidden(value));
  }
  CHECK(visible_text("a\tb\n\u202Eé\x01\xFF") == "a\tb\nU+202EéU+0001?");
}

TEST_CASE("hidden characters become JSON escapes, which parse to the same text") {
  CHECK(visible_json("{\n \"a\": \"\u202Eé\x7F\"}\n") == "{\n \"a\": \"\\u202eé\\u007f\"}\n");
  CHECK(visible_json("\U000E0001") == "\\udb40\\udc01");
  CHECK(visible_json("\xFF") == "\xFF");
}

TEST_CASE("character classes contain their characters, but not the neighbours") {
  const auto all = [](std::string_view text, bool (*is)(char)) {
    return std::all_of(text.begin(), text.end(), is);
  };
  const auto none = [](std::string_view text, bool (*is)(char)) {
    return std::none_of(text.begin(), text.end(), is);
  };
  CHECK(all("09", is_digit));
  CHECK(none("/:\xB2", is_digit));
  CHECK(all("azAZ", is_letter));
  CHECK(none("@[`{_\xE9", is_letter));
  CHECK(all("a9_", is_word_character));
  CHECK(none("-. ", is_word_character));
  CHECK(all(" \t\r\n", is_space));
  CHECK(none("\v\f_", is_space));
}
