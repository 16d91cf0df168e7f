// Lines and columns of toml++ to bytes.
#include "parse/toml_positions.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("columns count code points", "[parse]") {
  const SourcePointer source = make_source("test", "ab\n\u03C0=\u2212x\r\ny");
  const TomlPositions positions(*source);
  CHECK(positions.offset(1, 1) == 0);
  CHECK(positions.offset(2, 1) == 3);
  CHECK(positions.offset(2, 2) == 5);
  CHECK(positions.offset(2, 4) == 9);
  CHECK(positions.offset(3, 1) == 12);
}

TEST_CASE("a byte order mark is no column", "[parse]") {
  const SourcePointer source = make_source("test",
                                           "\xEF\xBB\xBF"
                                           "a\nb");
  const TomlPositions positions(*source);
  CHECK(positions.offset(1, 1) == 3);
  CHECK(positions.offset(2, 1) == 5);
}

TEST_CASE("what lies beyond the file is its end", "[parse]") {
  const SourcePointer source = make_source("test", "a");
  const TomlPositions positions(*source);
  CHECK(positions.offset(1, 2) == 1);
  CHECK(positions.offset(1, 9) == 1);
  CHECK(positions.offset(7, 1) == 1);
  CHECK(positions.offset(0, 0) == 1);
}
