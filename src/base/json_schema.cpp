// Schemas are composed of few words of JSON Schema, always in the same order.
#include "base/json_schema.hpp"

#include <utility>

namespace elgen {
namespace {

using Json = nlohmann::ordered_json;

Json documented(Json schema, std::string_view doc) {
  if (!doc.empty()) schema["description"] = doc;
  return schema;
}

}  // namespace

Json value_schema(std::string_view type) { return {{"type", type}}; }

Json word_schema(const std::vector<std::string_view>& words) {
  Json schema;
  schema["enum"] = words;
  return schema;
}

Json list_schema(Json item, std::string_view doc) {
  return documented({{"type", "array"}, {"items", std::move(item)}}, doc);
}

Json choice_schema(std::vector<Json> choices) {
  Json schema;
  schema["anyOf"] = std::move(choices);
  return schema;
}

Json object_schema(std::vector<SchemaKey> keys, std::string_view doc, Json others) {
  Json properties = Json::object();
  Json required = Json::array();
  for (SchemaKey& key : keys) {
    if (key.required) required.push_back(key.name);
    properties[std::string(key.name)] = std::move(key.value);
  }
  Json schema{{"type", "object"}, {"properties", std::move(properties)}};
  if (!required.empty()) schema["required"] = std::move(required);
  schema["additionalProperties"] = std::move(others);
  return documented(std::move(schema), doc);
}

std::string schema_text(std::string_view title, const Json& schema) {
  Json whole{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
  whole.update(schema);
  return whole.dump(2) + "\n";
}

}  // namespace elgen
