// The key table as JSON Schema.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "elgen/syntax.hpp"

using namespace elgen;

namespace {

using Json = nlohmann::json;

Json properties_of(FileKind kind) { return Json::parse(file_schema(kind)).at("properties"); }

}  // namespace

TEST_CASE("the schema lists required keys and forbids unknown keys") {
  CHECK(file_schema(FileKind::model)
            .starts_with("{\n  \"$schema\": \"http://json-schema.org/draft-07/schema#\",\n  "
                         "\"title\": \"model of elgen\",\n"));
  const Json model = Json::parse(file_schema(FileKind::model));
  CHECK(model.at("required") == Json{"format", "model", "coordinate"});
  CHECK(model.at("additionalProperties") == false);
  const Json scene = Json::parse(file_schema(FileKind::scene));
  CHECK(scene.at("required") == Json{"format", "model", "name"});
}

TEST_CASE("repeated entries are arrays, other entries are objects") {
  const Json model = properties_of(FileKind::model);
  CHECK(model.at("coordinate").at("type") == "array");
  CHECK(model.at("gravity").at("type") == "object");
  CHECK(model.at("gravity").at("required") == Json{"vector"});
}

TEST_CASE("keys that are not supported yet are left out") {
  CHECK_FALSE(properties_of(FileKind::scene).at("numeric").at("properties").contains("check"));
}

TEST_CASE("keys with free names have the schema of the row `*`") {
  const Json model = properties_of(FileKind::model);
  const Json& parameter = model.at("parameters").at("additionalProperties");
  CHECK(parameter.at("description") ==
        "a constant with its value. The struct of parameters in the code has a member of this name "
        "with this value.");
  CHECK(parameter.at("anyOf").at(0).at("type") == Json{"number", "string"});
  const Json& table = parameter.at("anyOf").at(1);
  CHECK(table.at("required") == Json{"value"});
  CHECK(table.at("properties").at("assume").at("enum") == Json{"positive", "nonnegative"});
  CHECK(model.at("define").at("additionalProperties").at("type") == Json{"number", "string"});
}

TEST_CASE("defaults that are TOML values become defaults of the schema") {
  const Json model = properties_of(FileKind::model);
  const Json& coordinate = model.at("coordinate").at("items").at("properties");
  CHECK(coordinate.at("kind").at("default") == "scalar");
  CHECK(coordinate.at("wrap").at("default") == false);
  CHECK(coordinate.at("armature").at("default") == 0);
  CHECK_FALSE(coordinate.at("range").contains("default"));
  CHECK(model.at("expect").at("items").at("properties").at("within").at("default") == 1e-12);
}

TEST_CASE("scenes list the outputs by name") {
  const Json choices = properties_of(FileKind::scene).at("outputs").at("anyOf");
  const Json& outputs = choices.at(0);
  const Json& mass = outputs.at("properties").at("mass_matrix");
  CHECK(mass.at("description") == "Mass matrix, symmetric.");
  CHECK(mass.at("allOf").at(0).at("$ref") == "#/properties/outputs/anyOf/0/additionalProperties");
  CHECK(outputs.at("additionalProperties").at("anyOf").at(0).at("type") == "boolean");
  CHECK(choices.at(1).at("type") == "array");
}
