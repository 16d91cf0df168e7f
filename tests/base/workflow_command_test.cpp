// Lines for GitHub: what would end them is escaped.
#include "base/workflow_command.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("a message stands where its span does") {
  const SourcePointer source = make_source("models/a.toml", "format = 1\nname = 2\n");
  CHECK(text_of(WorkflowCommand{"warning", {source.get(), 18, 19}, "elgen", "2 -> 3"}) ==
        "::warning file=models/a.toml,line=2,col=8,title=elgen::2 -> 3\n");
}

TEST_CASE("line ends and per cent signs are escaped, in properties colons and commas too") {
  CHECK(text_of(WorkflowCommand{"notice", {}, "a: b, 5%", "5%: a,\nb"}) ==
        "::notice title=a%3A b%2C 5%25::5%25: a,%0Ab\n");
}
