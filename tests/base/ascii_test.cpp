// Kinds of characters: those of ASCII, the ends of their ranges.
#include "base/ascii.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string_view>

using namespace elgen;

TEST_CASE("characters are of their kind, their neighbours are not") {
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
