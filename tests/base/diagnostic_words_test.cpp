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
