// A place has lines and columns from 1; its end is behind it.
#include "base/diagnostic_data.hpp"

#include <nlohmann/json.hpp>

#include "base/diagnostic_words.hpp"

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

}  // namespace elgen
