// elgen schema: the schemas hold for what the program reads.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/cli_testing.hpp"
#include "cli/judged.hpp"
#include "elgen/syntax.hpp"

namespace elgen::test {

TEST_CASE("all models and scenes satisfy their schemas") {
  Judged(schema_of("model"))
      .accepts(models + "/*.toml " ELGEN_SOURCE_DIR "/tests/urdf/golden/*.toml");
  Judged(schema_of("scene")).accepts(models + "/scenes/*.toml");
}

TEST_CASE("an unknown key, a missing one and a wrong word do not satisfy the schema of models") {
  const Judged workspace(schema_of("model"));
  const std::string cart = read_text(models + "/cart_pole.toml");
  const auto edited = [&](const std::string& part, const std::string& other) {
    std::string text = cart;
    const std::size_t at = text.find(part);
    REQUIRE(at != std::string::npos);
    write_text(workspace.path() / "m.toml", text.replace(at, part.size(), other));
  };
  edited("format = 1", "fromat = 1");
  workspace.refuses("m.toml", "$");
  edited("name        = \"cart_pole\"", "");
  workspace.refuses("m.toml", "$.model");
  edited("[gravity]", "[[gravity]]");
  workspace.refuses("m.toml", "$.gravity");
  edited("[[coordinate]]", "[[coordinate]]\nkind = \"angle\"");
  workspace.refuses("m.toml", "$.coordinate[0].kind");
}

TEST_CASE("editors find every key that is read, with its words and documentation") {
  const auto model = nlohmann::json::parse(schema_of("model"));
  const auto& frame = model.at("properties").at("frame").at("items").at("properties");
  for (const KeyRow& row : key_table()) {
    if (row.entry != "frame") continue;
    INFO(row.key);
    CHECK(frame.at(std::string(row.key)).at("description") == row.doc);
  }
  CHECK(frame.at("dh").at("properties").at("convention").at("enum") ==
        nlohmann::json{"standard", "modified"});
  const auto scene = nlohmann::json::parse(schema_of("scene"));
  CHECK(scene.at("properties").at("outputs").at("properties").contains("mass_matrix"));
  CHECK_FALSE(scene.at("properties").at("numeric").at("properties").contains("check"));
}

TEST_CASE("a schema that is not there is refused") {
  const Workspace workspace;
  const Outcome outcome = shell("elgen schema modle", workspace.path());
  CHECK(outcome.status == 2);
  CHECK(outcome.output.empty());
}

}  // namespace elgen::test
