// plain_text: what a compiler says cannot do anything to a terminal, or fill it.
#include "toolchain/plain_text.hpp"

#include <catch2/catch.hpp>

using elgen::plain_text;

TEST_CASE("escape sequences and control characters are left out") {
  CHECK(plain_text("a\x1b[01;31mb\x1b[K\tc\r\nd\a") == "abc\nd");
  CHECK(plain_text("a\x1b]8;;file://x\ab\x1b]0;title\x1b\\c") == "abc");
  CHECK(plain_text("a\x1b"
                   "7b\x1b") == "ab");
  CHECK(plain_text("a\x1b[31\nb") == "a\nb");
  CHECK(plain_text("a\u202eb\u200bc") == "abc");
  CHECK(plain_text("‘é’\n") == "‘é’\n");
}

TEST_CASE("long texts and binary ones are cut") {
  const std::string cut = plain_text(std::string(100'000, 'x'));
  CHECK(cut.size() < 4100);
  CHECK(cut.find("…\n") != std::string::npos);
  CHECK(plain_text("a\xff\xfe") == "a…\n");
}
