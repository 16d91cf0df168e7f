// Diagnostics as GitHub and GitLab read them.
#include "base/annotations.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

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

TEST_CASE("an issue of GitLab has path, line, code, severity and fingerprint") {
  CHECK(gitlab_issue(unknown_name(), "1234") ==
        R"({"description":"unknown name `mq`; did you mean `m`?","check_name":"E201",)"
        R"("fingerprint":"1234","severity":"major",)"
        R"("location":{"path":"models/a, b.toml","lines":{"begin":2}}})");
  const auto nowhere = nlohmann::json::parse(gitlab_issue({Code::E913, {}, "say \"\n\xff\""}, "5"));
  CHECK(nowhere.at("location").at("path") == "elgen");
  CHECK(nowhere.at("location").at("lines").at("begin") == 1);
}
