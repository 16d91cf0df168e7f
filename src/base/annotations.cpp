// GitHub has words of its own for severities.
#include "base/annotations.hpp"

#include <fmt/format.h>

#include <array>

#include "base/diagnostic_words.hpp"
#include "base/workflow_command.hpp"

namespace elgen {
namespace {

// In the order of Severity.
constexpr std::array<std::string_view, 3> github_words{"notice", "warning", "error"};

}  // namespace

std::string github_command(const Diagnostic& diagnostic) {
  const CodeRow& row = code_row(diagnostic.code);
  return text_of(WorkflowCommand{github_words.at(static_cast<std::size_t>(row.severity)),
                                 points_into_file(diagnostic.span) ? diagnostic.span : Span{},
                                 fmt::format("{} {}", row.name, row.title), sentence(diagnostic)});
}

}  // namespace elgen
