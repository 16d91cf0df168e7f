// Diagnostics as GitHub reads them.
#include "base/annotations.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

const SourcePointer source = make_source("./models/a, b.toml", "format = 1\nT = \"mq*v\"\n");

Diagnostic unknown_name(Code code = Code::E201) {
  return {code, {source.get(), 16, 18}, "unknown name `mq`", "did you mean `m`?"};
}

}  // namespace

TEST_CASE("a command of a workflow has its place, its title and the sentence") {
  CHECK(github_command(unknown_name()) ==
        "::error file=models/a%2C b.toml,line=2,col=6,title=E201 unknown name::"
        "unknown name `mq`; did you mean `m`?\n");
  CHECK(github_command({Code::E520, {}, "100 %\r\nnext: line, ok"}) ==
        "::notice title=E520 " + std::string(code_row(Code::E520).title) +
            "::100 %25%0D%0Anext: line, ok\n");
}
