// Words that all formats share.
#include "base/diagnostic_words.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("a severity is one word") {
  CHECK(severity_word(Severity::note) == "note");
  CHECK(severity_word(Severity::error) == "error");
}

TEST_CASE("only what stands in back-ticks is cut") {
  const std::string name(300, 'x');
  CHECK(shortened("unknown name `" + name + "`") ==
        "unknown name `" + std::string(200, 'x') + "…`");
  CHECK(shortened(name) == name);
}

TEST_CASE("a sentence is the message with its hint") {
  CHECK(sentence({Code::E201, {}, "unknown name `x`"}) == "unknown name `x`");
  CHECK(sentence({Code::E201, {}, "unknown name `x`", "write `y`"}) ==
        "unknown name `x`; write `y`");
}

TEST_CASE("paths are as given, and words of the command line are no file") {
  const SourcePointer file = make_source("./a/b.toml", "x");
  const SourcePointer words = make_source("command line", "elgen x");
  CHECK(path_of({file.get(), 0, 1}) == "a/b.toml");
  CHECK(points_into_file({file.get(), 0, 1}));
  CHECK_FALSE(points_into_file({words.get(), 0, 1}));
  CHECK_FALSE(points_into_file({}));
  CHECK(path_of({}) == "elgen");
}
