// Columns are counted in code points, the end of a region is behind it, and braces of texts are
// doubled, for single ones hold places of arguments (SARIF 2.1.0, 3.11.5).
#include "base/sarif.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/ascii.hpp"
#include "base/diagnostic_words.hpp"

namespace elgen {
namespace {

using Json = nlohmann::ordered_json;

Json message(std::string_view text) {
  std::string doubled;
  for (const char c : text) doubled += std::string(c == '{' || c == '}' ? 2 : 1, c);
  return {{"text", doubled}};
}

constexpr std::size_t npos = std::string_view::npos;

/// A relative path stays relative; what a URI has no letters for is written by its number.
std::string uri_of(const std::string& path) {
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    const bool is_plain = is_word_character(c) || std::string_view("-.~/").find(c) != npos;
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

/// What is no file has a name alone.
Json location(const Span& span) {
  if (!points_into_file(span)) {
    return {{"logicalLocations", Json::array({Json{{"name", path_of(span)}}})}};
  }
  const LineColumn begin = line_column(*span.source, span.begin);
  const LineColumn end = line_column(*span.source, span.end);
  return {{"physicalLocation",
           {{"artifactLocation", {{"uri", uri_of(path_of(span))}}},
            {"region",
             {{"startLine", begin.line},
              {"startColumn", begin.column},
              {"endLine", end.line},
              {"endColumn", end.column}}}}}};
}

Json rule(const CodeRow& row) {
  return {{"id", row.name},
          {"shortDescription", message(row.title)},
          {"fullDescription", message(row.explanation)},
          {"defaultConfiguration", {{"level", severity_word(row.severity)}}}};
}

std::string on_one_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string sarif_start() {
  Json rules = Json::array();
  for (const CodeRow& row : code_table()) rules.push_back(rule(row));
  const Json driver{{"name", "elgen"}, {"version", ELGEN_VERSION}, {"rules", std::move(rules)}};
  return fmt::format(
      R"({{"$schema":"https://json.schemastore.org/sarif-2.1.0.json","version":"2.1.0","runs":[)"
      R"({{"tool":{{"driver":{}}},"columnKind":"unicodeCodePoints","results":[)"
      "\n",
      on_one_line(driver));
}

std::string sarif_result(const Diagnostic& diagnostic, const std::string& fingerprint) {
  const CodeRow& row = code_row(diagnostic.code);
  Json json{{"ruleId", row.name},
            {"ruleIndex", static_cast<std::size_t>(row.code)},
            {"level", severity_word(row.severity)},
            {"message", message(sentence(diagnostic))},
            {"locations", Json::array({location(diagnostic.span)})}};
  if (diagnostic.related) {
    Json related = location(*diagnostic.related);
    related["message"] = message(shortened(diagnostic.related_message));
    json["relatedLocations"] = Json::array({std::move(related)});
  }
  json["partialFingerprints"] = {{"elgen/v1", fingerprint}};
  return on_one_line(json);
}

}  // namespace elgen
