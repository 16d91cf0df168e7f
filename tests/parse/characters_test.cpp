// What to write instead of characters of other alphabets and of typography.
#include "parse/characters.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("look-alikes have a replacement", "[parse]") {
  CHECK(replacement_hint(0x03C0) == "write `pi` instead of the Greek letter");
  CHECK(replacement_hint(0x0445) == "write `x` instead of the Cyrillic letter");
  CHECK(replacement_hint(0x00B7) == "write `*` instead of this character");
  CHECK(replacement_hint(0x2212) == "write `-` instead of this character");
  CHECK(replacement_hint(0x00B2) == "write `^2` instead of this character");
  CHECK(replacement_hint(0x00A0) == "write a plain space");
  CHECK(replacement_hint(U'\'') == "write `dot(x)`");
}

TEST_CASE("full-width forms are their ASCII", "[parse]") {
  CHECK(replacement_hint(0xFF08) == "write `(`");
  CHECK(replacement_hint(0xFF1D) == "write `=`");
}

TEST_CASE("a character that resembles nothing has none", "[parse]") {
  CHECK(replacement_hint(0x4E2D).empty());
  CHECK(replacement_hint(0x1F600).empty());
}
