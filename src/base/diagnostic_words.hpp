// diagnostic_words: text functions that several formats of diagnostics share.
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

/// The text with each part in back-ticks cut to 200 bytes, because a name may be as long as a file.
/// Hidden characters, such as marks that reverse the direction of text, are replaced by their
/// names.
[[nodiscard]] std::string shorten_quotations(std::string_view text);

/// The message and its hint, separated by a semicolon.
[[nodiscard]] std::string message_with_hint(const Diagnostic& diagnostic);

/// True if the span is in a file; false for a span of the command line or without a source.
[[nodiscard]] bool is_in_file(const Span& span);

/// The path as given, without `./`; "elgen" for a span without a source.
[[nodiscard]] std::string display_path(const Span& span);

/// A line of output with which a program makes GitHub Actions show a message at a line of a file.
///
///     ::warning file=models/a.toml,line=3,col=7,title=elgen diff::[gravity] vector[2]%3A -g -> g
struct WorkflowCommand {
  std::string_view level = "notice";  ///< "notice", "warning" or "error"
  Span place = {};
  std::string title = {};
  std::string message = {};
};

/// The command with GitHub's escapes and a line end.
[[nodiscard]] std::string text_of(const WorkflowCommand& command);

}  // namespace elgen
