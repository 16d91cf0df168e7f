// A diagnostic as programs read it.
#include "base/diagnostic_data.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace elgen;

TEST_CASE("a line has code, message, hint and places") {
  const SourcePointer source = make_source("m.toml", "a\nbc\n");
  const Diagnostic diagnostic{Code::E203,          {source.get(), 2, 4},     "duplicate name `bc`",
                              "write another one", Span{source.get(), 0, 1}, "first declared here"};
  CHECK(json_line(diagnostic) ==
        R"({"severity":"error","code":"E203","message":"duplicate name `bc`",)"
        R"("hint":"write another one",)"
        R"("position":{"file":"m.toml","line":2,"column":1,"end_line":2,"end_column":3},)"
        R"("related":{"file":"m.toml","line":1,"column":1,"end_line":1,"end_column":2,)"
        R"("message":"first declared here"}})"
        "\n");
  CHECK(json_line({Code::E913, {}, "no command given"}) ==
        R"({"severity":"error","code":"E913","message":"no command given","position":null})"
        "\n");
}

TEST_CASE("bytes that are not UTF-8 are replaced") {
  CHECK(nlohmann::json::accept(json_line({Code::E110, {}, "`\xff`"})));
}
