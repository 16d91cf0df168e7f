// GitHub reads properties until `::`, and a message until the end of the line; GitLab reads JSON.
#include "base/annotations.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "base/diagnostic_words.hpp"

namespace elgen {
namespace {

using Json = nlohmann::ordered_json;

// In the order of Severity.
constexpr std::array<std::string_view, 3> github_words{"notice", "warning", "error"};
constexpr std::array<std::string_view, 3> gitlab_words{"info", "minor", "major"};

std::string_view word(const std::array<std::string_view, 3>& words, Severity severity) {
  return words.at(static_cast<std::size_t>(severity));
}

/// Each of `special` by its number: `%3A`.
std::string escaped(std::string_view text, std::string_view special) {
  std::string result;
  for (const char c : text) {
    result += special.find(c) == std::string_view::npos
                  ? std::string(1, c)
                  : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return result;
}

std::string property(std::string_view name, std::string_view value) {
  return fmt::format("{}={}", name, escaped(value, "%\r\n:,"));
}

}  // namespace

std::string github_command(const Diagnostic& diagnostic) {
  const CodeRow& row = code_row(diagnostic.code);
  std::string properties;
  if (points_into_file(diagnostic.span)) {
    const LineColumn at = line_column(*diagnostic.span.source, diagnostic.span.begin);
    properties = fmt::format("{},line={},col={},", property("file", path_of(diagnostic.span)),
                             at.line, at.column);
  }
  properties += property("title", fmt::format("{} {}", row.name, row.title));
  return fmt::format("::{} {}::{}\n", word(github_words, row.severity), properties,
                     escaped(sentence(diagnostic), "%\r\n"));
}

std::string gitlab_issue(const Diagnostic& diagnostic, const std::string& fingerprint) {
  const CodeRow& row = code_row(diagnostic.code);
  const bool has_place = diagnostic.span.source != nullptr;
  const std::size_t line =
      has_place ? line_column(*diagnostic.span.source, diagnostic.span.begin).line : 1;
  const Json json{{"description", sentence(diagnostic)},
                  {"check_name", row.name},
                  {"fingerprint", fingerprint},
                  {"severity", word(gitlab_words, row.severity)},
                  {"location", {{"path", path_of(diagnostic.span)}, {"lines", {{"begin", line}}}}}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace elgen
