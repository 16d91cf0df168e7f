// Keys and their schema stand together.
#include "base/diagnostic_data.hpp"

#include <nlohmann/json.hpp>

#include "base/diagnostic_words.hpp"
#include "base/json_schema.hpp"

namespace elgen {
namespace {

using Json = nlohmann::ordered_json;

Json json_position(const Span& span) {
  Json json;
  if (span.source == nullptr) return json;
  const LineColumn begin = line_column(*span.source, span.begin);
  const LineColumn end = line_column(*span.source, span.end);
  json["file"] = span.source->path;
  json["line"] = begin.line;
  json["column"] = begin.column;
  json["end_line"] = end.line;
  json["end_column"] = end.column;
  return json;
}

Json place_schema(std::vector<SchemaKey> more = {}) {
  std::vector<SchemaKey> keys{{"file", value_schema("string", "its path as given")}};
  for (const char* name : {"line", "column", "end_line", "end_column"}) {
    keys.push_back({name, value_schema("integer")});
  }
  keys.insert(keys.end(), more.begin(), more.end());
  return object_schema(std::move(keys), "lines and columns from 1; the end is behind it");
}

}  // namespace

std::string json_line(const Diagnostic& diagnostic) {
  const CodeRow& row = code_row(diagnostic.code);
  Json json;
  json["severity"] = severity_word(row.severity);
  json["code"] = row.name;
  json["message"] = shortened(diagnostic.message);
  if (!diagnostic.hint.empty()) json["hint"] = shortened(diagnostic.hint);
  json["position"] = json_position(diagnostic.span);
  if (diagnostic.related) {
    json["related"] = json_position(*diagnostic.related);
    json["related"]["message"] = shortened(diagnostic.related_message);
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string diagnostic_schema() {
  std::vector<std::string_view> codes;
  for (const CodeRow& row : code_table()) codes.push_back(row.name);
  return schema_text(
      "line of what elgen --format json says",
      object_schema(
          {{"severity", word_schema({severity_words.begin(), severity_words.end()})},
           {"code", word_schema(codes, "elgen explain CODE says what it means")},
           {"message", value_schema("string")},
           {"hint", value_schema("string", "what to do instead"), false},
           {"position", choice_schema({place_schema(), value_schema("null")}, "null: of no file")},
           {"related", place_schema({{"message", value_schema("string")}}), false}}));
}

}  // namespace elgen
