// Diagnostics as a log of SARIF.
#include "base/sarif.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace elgen;
using Json = nlohmann::json;

namespace {

Json result(const Diagnostic& diagnostic) { return Json::parse(sarif_result(diagnostic, "1234")); }

Json place(const Json& json) { return json.at("locations").at(0).at("physicalLocation"); }

}  // namespace

TEST_CASE("a log has every code as a rule, at the index that results say") {
  const Json log = Json::parse(sarif_start() + std::string(sarif_end));
  CHECK(log.at("version") == "2.1.0");
  const Json& run = log.at("runs").at(0);
  CHECK(run.at("results").empty());
  const Json& rules = run.at("tool").at("driver").at("rules");
  REQUIRE(rules.size() == code_table().size());
  const Json found = result({Code::E913, {}, "no command given"});
  CHECK(rules.at(found.at("ruleIndex").get<std::size_t>()).at("id") == "E913");
}

TEST_CASE("a region counts code points, and ends behind its last") {
  const SourcePointer source = make_source("a b.toml", "x\nθ = mq\n");
  const Json json = result({Code::E201, {source.get(), 7, 9}, "unknown name `mq`", "write `m`"});
  CHECK(json.at("level") == "error");
  CHECK(json.at("message").at("text") == "unknown name `mq`; write `m`");
  CHECK(place(json).at("artifactLocation").at("uri") == "a%20b.toml");
  CHECK(place(json).at("region") ==
        Json{{"startLine", 2}, {"startColumn", 5}, {"endLine", 2}, {"endColumn", 7}});
  CHECK(json.at("partialFingerprints").at("elgen/v1") == "1234");
}

TEST_CASE("absolute paths are URIs of files, colons of relative ones are no scheme") {
  const SourcePointer absolute = make_source("/tmp/ü.toml", "x");
  CHECK(place(result({Code::E201, {absolute.get(), 0, 1}, "x"})).at("artifactLocation").at("uri") ==
        "file:///tmp/%C3%BC.toml");
  const SourcePointer relative = make_source("c:d.toml", "x");
  CHECK(place(result({Code::E201, {relative.get(), 0, 1}, "x"})).at("artifactLocation").at("uri") ==
        "c%3Ad.toml");
}

TEST_CASE("braces are doubled, and what is no file has a name alone") {
  const SourcePointer words = make_source("command line", "elgen shwo");
  const Json json = result({Code::E913, {words.get(), 6, 10}, "`{0}`"});
  CHECK(json.at("message").at("text") == "`{{0}}`");
  CHECK(json.at("locations").at(0) ==
        Json{{"logicalLocations", Json::array({Json{{"name", "command line"}}})}});
}

TEST_CASE("a second place is related, with its message") {
  const SourcePointer source = make_source("m.toml", "a\nb\n");
  const Json json = result({Code::E203,
                            {source.get(), 2, 3},
                            "duplicate",
                            "",
                            Span{source.get(), 0, 1},
                            "first declared here"});
  const Json& related = json.at("relatedLocations").at(0);
  CHECK(related.at("message").at("text") == "first declared here");
  CHECK(related.at("physicalLocation").at("region").at("startLine") == 1);
}
