// Tests of the page reader: kinds of fences, comparison of output, and links.
#include "pages/page.hpp"

#include <catch2/catch.hpp>

namespace elgen::test {

namespace {

FenceKind kind_of(const std::string& info) {
  return read_page("p", "```" + info + "\n```\n").fences.front().kind;
}

}  // namespace

TEST_CASE("the info string of a fence determines its kind") {
  CHECK(kind_of("sh") == FenceKind::commands);
  CHECK(kind_of("sh not-run: it takes an hour") == FenceKind::not_run);
  CHECK(kind_of("sh not-run:") == FenceKind::unknown);
  CHECK(kind_of("console") == FenceKind::console);
  CHECK(kind_of("toml a.scene.toml") == FenceKind::file);
  CHECK(kind_of("cpp in generated/a/a.hpp") == FenceKind::excerpt);
  CHECK(kind_of("text") == FenceKind::picture);
  for (const char* unknown : {"", "cpp", "toml", "bash", "sh skip", "text a b"}) {
    INFO(unknown);
    CHECK(kind_of(unknown) == FenceKind::unknown);
  }
}

TEST_CASE("a page consists of prose and fences") {
  const Page read = read_page("p.md", "before\n```cpp in a/b.hpp\nint a;\n```\nafter\n");
  CHECK(read.prose == "before\nafter\n");
  REQUIRE(read.fences.size() == 1);
  CHECK(read.fences.front().line == 2);
  CHECK(read.fences.front().file == "a/b.hpp");
  CHECK(read.fences.front().text == "int a;\n");
}

TEST_CASE("a console consists of commands with their output") {
  const std::vector<Exchange> read = exchanges("$ a b\none\ntwo\n$ c\n");
  REQUIRE(read.size() == 2);
  CHECK(read[0].command == "a b");
  CHECK(read[0].output == "one\ntwo\n");
  CHECK(read[1].output.empty());
}

TEST_CASE("a line … matches any number of lines, all other lines must be equal") {
  CHECK(agrees("a\nb\n", "a\nb\n"));
  CHECK_FALSE(agrees("a\n", "a\nb\n"));
  CHECK(agrees("a\n…\n", "a\nb\n"));
  CHECK(agrees("…\nb\n", "a\nb\n"));
  CHECK(agrees("a\n…\nc\n…\ne\n", "a\nb\nc\nd\ne\n"));
  CHECK_FALSE(agrees("…\nc\n…\nb\n…\n", "a\nb\nc\n"));
  CHECK_FALSE(agrees("…\nb\n…\n", "a b\n"));
  CHECK_FALSE(agrees("a\n…\na\n", "a\n"));
}

TEST_CASE("links, anchors and code spans are found in prose") {
  const std::string prose =
      "# The `model` language\nsee [here](a/b.md#c) and `x/y` or `z`\n<img src=\"d.svg\">\n";
  CHECK(links(prose) == std::vector<std::string>{"a/b.md#c", "d.svg"});
  CHECK(anchors(prose) == std::vector<std::string>{"the-model-language"});
  CHECK(code_spans(prose) == std::vector<std::string>{"model", "x/y", "z"});
}

}  // namespace elgen::test
