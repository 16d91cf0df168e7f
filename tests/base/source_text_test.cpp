// Offsets to lines and columns.
#include "elgen/source_text.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("columns count code points, not bytes") {
  const SourcePointer source = make_source("a.toml", "x = 1\nθ = \"π\" # end\n");
  CHECK(line_column(*source, 0).line == 1);
  const auto hash = static_cast<std::uint32_t>(source->text.find('#'));
  CHECK(line_column(*source, hash).line == 2);
  CHECK(line_column(*source, hash).column == 9);
}

TEST_CASE("the end of the text, and offsets beyond, have a place") {
  const SourcePointer source = make_source("a.toml", "ab\n");
  CHECK(line_column(*source, 3).line == 2);
  CHECK(line_column(*source, 99).line == 2);
  CHECK(line_column(*source, 99).column == 1);
}

TEST_CASE("lines come without their ends, LF or CRLF") {
  const SourcePointer source = make_source("a.toml", "one\r\ntwo\nthree");
  CHECK(line_text(*source, 1) == "one");
  CHECK(line_text(*source, 2) == "two");
  CHECK(line_text(*source, 3) == "three");
}

TEST_CASE("the name of a file is the last part of its path") {
  CHECK(file_name(*make_source("models/a.toml", "")) == "a.toml");
  CHECK(file_name(*make_source("a.toml", "")) == "a.toml");
}

TEST_CASE("a span covers its bytes, and nothing without a source") {
  const SourcePointer source = make_source("a.toml", "abcdef");
  CHECK(covered_text({source.get(), 2, 4}) == "cd");
  CHECK(covered_text({}).empty());
}

TEST_CASE("a byte order mark is no column and no text of the first line") {
  const SourcePointer source = make_source("a.toml", "\xEF\xBB\xBFx = 1\ny = 2\n");
  CHECK(line_column(*source, 3).column == 1);
  CHECK(line_column(*source, 5).column == 3);
  CHECK(line_text(*source, 1) == "x = 1");
  CHECK(line_text(*source, 2) == "y = 2");
}
