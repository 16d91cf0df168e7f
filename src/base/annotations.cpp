// GitHub reads commands, GitLab JSON.
#include "base/annotations.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "base/diagnostic_words.hpp"
#include "base/workflow_command.hpp"

namespace elgen {
namespace {

using Json = nlohmann::ordered_json;

// In the order of Severity.
constexpr std::array<std::string_view, 3> github_words{"notice", "warning", "error"};
constexpr std::array<std::string_view, 3> gitlab_words{"info", "minor", "major"};

std::string_view word(const std::array<std::string_view, 3>& words, Severity severity) {
  return words.at(static_cast<std::size_t>(severity));
}

}  // namespace

std::string github_command(const Diagnostic& diagnostic) {
  const CodeRow& row = code_row(diagnostic.code);
  return text_of(WorkflowCommand{word(github_words, row.severity),
                                 points_into_file(diagnostic.span) ? diagnostic.span : Span{},
                                 fmt::format("{} {}", row.name, row.title), sentence(diagnostic)});
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
