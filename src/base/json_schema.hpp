// json_schema: what a JSON text has to look like, as draft 7 of JSON Schema. Editors and validators
// read it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

/// One key of an object.
struct SchemaKey {
  std::string_view name;
  nlohmann::ordered_json value;  ///< its schema
  bool required = true;
};

/// A value of this type of JSON: "string", "integer".
[[nodiscard]] nlohmann::ordered_json value_schema(std::string_view type);

/// One of these words.
[[nodiscard]] nlohmann::ordered_json word_schema(const std::vector<std::string_view>& words);

[[nodiscard]] nlohmann::ordered_json list_schema(nlohmann::ordered_json item,
                                                 std::string_view doc = {});

/// Any one of these.
[[nodiscard]] nlohmann::ordered_json choice_schema(std::vector<nlohmann::ordered_json> choices);

/// These keys; any other is refused, or is as `others` says.
[[nodiscard]] nlohmann::ordered_json object_schema(std::vector<SchemaKey> keys,
                                                   std::string_view doc = {},
                                                   nlohmann::ordered_json others = false);

/// The file: `schema` under a title.
[[nodiscard]] std::string schema_text(std::string_view title, const nlohmann::ordered_json& schema);

}  // namespace elgen
