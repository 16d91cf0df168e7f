// diagnostic_words: what every format says of a diagnostic.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "elgen/diagnostic.hpp"

namespace elgen {

/// In the order of Severity.
inline constexpr std::array<std::string_view, 3> severity_words{"note", "warning", "error"};

[[nodiscard]] constexpr std::string_view severity_word(Severity severity) {
  return severity_words.at(static_cast<std::size_t>(severity));
}

/// A name may be as long as a file: of what stands in back-ticks the beginning is enough. It may
/// hold anything: characters that are not seen, such as those that turn the direction of what
/// follows, become their names.
[[nodiscard]] std::string shortened(std::string_view said);

/// The message and its hint.
[[nodiscard]] std::string sentence(const Diagnostic& diagnostic);

/// And not into words of the command line, or nowhere.
[[nodiscard]] bool points_into_file(const Span& span);

/// As given, `./` aside; "elgen" where a span points nowhere.
[[nodiscard]] std::string path_of(const Span& span);

/// A line by which a program tells GitHub Actions where to show a message.
///
///     ::warning file=models/a.toml,line=3,col=7,title=elgen diff::[gravity] vector[2]%3A -g -> g
struct WorkflowCommand {
  std::string_view level = "notice";  ///< "notice", "warning" or "error"
  Span place = {};
  std::string title = {};
  std::string message = {};
};

/// Escaped as GitHub wants it, with its line end.
[[nodiscard]] std::string text_of(const WorkflowCommand& command);

}  // namespace elgen
