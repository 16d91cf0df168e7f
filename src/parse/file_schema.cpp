// Each row of the key table becomes a key of a JSON object; each row of the entry table becomes an
// object or a list of objects. Unsupported rows are omitted, because the reader refuses them.
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/json.hpp"
#include "elgen/outputs.hpp"
#include "parse/entry_reader.hpp"

namespace elgen {
namespace {

/// One key of an object.
struct SchemaKey {
  std::string_view name;
  Json value;  ///< its schema
  bool required = true;
};

Json with_description(Json schema, std::string_view doc) {
  if (!doc.empty()) schema["description"] = doc;
  return schema;
}

/// Schema of a JSON type: "string", "integer".
Json value_schema(std::string_view type) { return {{"type", type}}; }

/// Schema of a string that is one of the words.
Json word_schema(const std::vector<std::string_view>& words) {
  Json schema;
  schema["enum"] = words;
  return schema;
}

Json list_schema(Json item, std::string_view doc = {}) {
  return with_description({{"type", "array"}, {"items", std::move(item)}}, doc);
}

/// Schema of a value that matches any of the choices.
Json any_of_schema(const std::vector<Json>& choices) {
  Json schema;
  schema["anyOf"] = choices;
  return schema;
}

/// Schema of an object with these keys. The values of all other keys must match `others`; false
/// refuses other keys.
Json object_schema(std::vector<SchemaKey> keys, std::string_view doc = {}, Json others = false) {
  Json properties = Json::object();
  Json required = Json::array();
  for (SchemaKey& key : keys) {
    if (key.required) required.push_back(key.name);
    properties[std::string(key.name)] = std::move(key.value);
  }
  Json schema{{"type", "object"}, {"properties", std::move(properties)}};
  if (!required.empty()) schema["required"] = std::move(required);
  schema["additionalProperties"] = std::move(others);
  return with_description(std::move(schema), doc);
}

/// The text of the file: `schema` with a title.
std::string schema_text(std::string_view title, const Json& schema) {
  Json whole{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
  whole.update(schema);
  return whole.dump(2) + "\n";
}

Json table_schema(const std::string& entry, std::string_view doc);

Json expression_schema() {
  Json schema;
  schema["type"] = {"number", "string"};
  return schema;
}

/// Schema of a list of `count` expressions; if `count` is 0, of a list of any length.
Json expression_list_schema(std::size_t count = 0) {
  Json schema = list_schema(expression_schema());
  if (count == 0) return schema;
  schema["maxItems"] = count;
  schema["minItems"] = count;
  return schema;
}

/// Schema of a name: a letter, then letters, digits and underscores, with an optional index.
Json name_schema() {
  Json schema = value_schema("string");
  schema["pattern"] = "^[A-Za-z][A-Za-z0-9_]*(\\s*\\[.+\\])?$";
  return schema;
}

/// Schema of [[axis, angle], ...]; an axis is a letter, or three expressions.
Json turns_schema() {
  Json axis = any_of_schema({value_schema("string"), expression_list_schema(3)});
  Json turn{{"type", "array"}};
  turn["items"] = {std::move(axis), expression_schema()};
  turn["maxItems"] = 2;
  turn["minItems"] = 2;
  return list_schema(std::move(turn));
}

Json word_list_schema(const KeyRow& row) {
  Json schema = list_schema(word_schema(choice_words(row)));
  schema["minItems"] = 1;
  return any_of_schema({word_schema(choice_words(row)), std::move(schema)});
}

Json matrix_schema() {
  return list_schema(any_of_schema({expression_schema(), expression_list_schema()}));
}

Json inner_table_schema(const KeyRow& row) {
  return table_schema(fmt::format("{}.{}", row.entry, row.key), {});
}

Json key_schema(const KeyRow& row) {
  const auto or_table = [&row](Json other) {
    return any_of_schema({std::move(other), inner_table_schema(row)});
  };
  const Json text = value_schema("string");
  switch (row.type) {
    case KeyType::expression:
      return expression_schema();
    case KeyType::expression_list:
      return expression_list_schema();
    case KeyType::expression_or_list:
      return any_of_schema({expression_schema(), expression_list_schema()});
    case KeyType::value_or_table:
      return any_of_schema(
          {expression_schema(), expression_list_schema(), inner_table_schema(row)});
    case KeyType::expression_or_table:
      return or_table(expression_schema());
    case KeyType::closed_form:
      return any_of_schema({expression_schema(), matrix_schema(), inner_table_schema(row)});
    case KeyType::name:
      return name_schema();
    case KeyType::text:
    case KeyType::latex_symbol:
    case KeyType::unit:
    case KeyType::condition:
      return text;
    case KeyType::choice:
      return word_schema(choice_words(row));
    case KeyType::choice_list:
      return word_list_schema(row);
    case KeyType::equations:
    case KeyType::repetition:
      return any_of_schema({text, list_schema(text)});
    case KeyType::integer:
      return value_schema("integer");
    case KeyType::boolean:
      return value_schema("boolean");
    case KeyType::range:
      return expression_list_schema(2);
    case KeyType::turns:
      return turns_schema();
    case KeyType::table:
      return inner_table_schema(row);
    case KeyType::output_request:
      return any_of_schema({value_schema("boolean"), text, inner_table_schema(row)});
    case KeyType::boolean_or_expression:
      return any_of_schema({value_schema("boolean"), expression_schema()});
    case KeyType::text_or_table:
      return or_table(text);
    case KeyType::names_or_table:
      return any_of_schema({text, list_schema(text), inner_table_schema(row)});
  }
  return {};
}

/// Adds the standard outputs by name, so that editors offer them. The names of [[output]]s differ
/// from model to model.
void add_output_keys(std::vector<SchemaKey>& keys) {
  const Json wanted{{"$ref", "#/properties/outputs/anyOf/0/additionalProperties"}};
  for (const OutputRow& output : output_table()) {
    if (output.is_user_output) continue;
    // Draft 7 ignores keys next to `$ref`, so `allOf` wraps the reference.
    Json schema;
    schema["allOf"] = Json::array({wanted});
    schema["description"] = output.doc;
    keys.push_back({output.name, std::move(schema), false});
  }
}

/// The keys of one entry of the key table, and the schema of its other keys (false: none).
struct TableKeys {
  std::vector<SchemaKey> named = {};
  Json additional = false;
};

/// The default as JSON; null if it is no constant.
Json default_json(const KeyRow& row) {
  return std::visit(
      []<class Value>(const Value& value) -> Json {
        if constexpr (std::same_as<Value, std::monostate> || std::same_as<Value, DefaultInWords>) {
          return nullptr;
        } else {
          return value;
        }
      },
      row.default_value);
}

/// The documentation of a key or entry, with its details.
template <class Row>
std::string description_of(const Row& row) {
  return row.details.empty() ? std::string(row.doc) : fmt::format("{}. {}", row.doc, row.details);
}

TableKeys table_keys(std::string_view entry) {
  TableKeys keys;
  for (const KeyRow& row : key_table()) {
    if (row.entry != entry || !row.supported) continue;
    Json schema = key_schema(row);
    schema["description"] = description_of(row);
    if (const Json value = default_json(row); !value.is_null()) schema["default"] = value;
    if (row.key == "*") {
      keys.additional = std::move(schema);
    } else {
      keys.named.push_back({row.key, std::move(schema), row.required});
    }
  }
  if (entry == "scene.outputs") add_output_keys(keys.named);
  return keys;
}

Json table_schema(const std::string& entry, std::string_view doc) {
  TableKeys keys = table_keys(entry);
  return object_schema(std::move(keys.named), doc, std::move(keys.additional));
}

Json entry_schema(FileKind kind, const EntryRow& row) {
  const std::string entry = qualified_entry_name(kind, row);
  if (row.repeated) return list_schema(table_schema(entry, {}), description_of(row));
  if (!row.may_be_list) return table_schema(entry, description_of(row));
  Json schema = any_of_schema({table_schema(entry, {}), list_schema(value_schema("string"))});
  return with_description(std::move(schema), description_of(row));
}

}  // namespace

std::string file_schema(FileKind kind) {
  const bool is_scene = kind == FileKind::scene;
  TableKeys keys = table_keys(is_scene ? "scene" : "");
  for (const EntryRow& row : entry_rows_of(kind)) {
    if (row.supported) keys.named.push_back({row.entry, entry_schema(kind, row), row.required});
  }
  const std::string_view title = is_scene ? "scene of elgen" : "model of elgen";
  return schema_text(title, object_schema(std::move(keys.named)));
}

}  // namespace elgen
