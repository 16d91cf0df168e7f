// diff_markdown: equations stand in blocks of code, in which no sign is a mark of Markdown.
#include <fmt/format.h>

#include <algorithm>

#include "diff/summary.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

/// Of one system: a comment on GitHub has at most 65 536 characters.
constexpr std::size_t most_lines = 200;

/// Longer than any row of back-ticks inside.
std::string fence(std::string_view text) {
  std::size_t longest = 2;
  std::size_t row = 0;
  for (const char c : text) {
    row = c == '`' ? row + 1 : 0;
    longest = std::max(longest, row);
  }
  return std::string(longest + 1, '`');
}

std::string code_block(const std::string& text) {
  const std::string marks = fence(text);
  return fmt::format("{}text\n{}{}\n", marks, text, marks);
}

/// "<details>" of Markdown, which a reader opens.
std::string folded(const EntryList& list) {
  std::string text;
  for (std::size_t i = 0; i < std::min(list.lines.size(), most_lines); ++i) {
    text += list.lines[i] + "\n";
  }
  if (list.lines.size() > most_lines) {
    text += fmt::format("{} more\n", counted(list.lines.size() - most_lines, "line"));
  }
  return fmt::format("<details><summary>Entries of {}</summary>\n\n{}\n</details>\n", list.system,
                     code_block(text));
}

}  // namespace

std::string to_markdown(const DiffReport& report) {
  SummaryLines lines = summary(report, false);
  const SummaryLine verdict = lines.back();
  lines.pop_back();
  std::string text = fmt::format("### elgen diff: {} ({})\n", verdict.label, verdict.text);
  if (!lines.empty()) text += "\n" + code_block(text_of(lines));
  for (const EntryList& list : entry_lists(report)) text += "\n" + folded(list);
  return text;
}

}  // namespace elgen
