// A kind of notes: one code, and (of what is not imported) one message.
#include "cli/note_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "elgen/wording.hpp"

namespace elgen::cli {

namespace {

using Kind = std::pair<Code, std::string>;

/// What E815 says differs from kind to kind; the others name what they are about.
Kind kind_of(const Diagnostic& note) {
  return {note.code, note.code == Code::E815 ? note.message : std::string()};
}

Diagnostic summary_of(const Diagnostic& first, std::size_t count) {
  const std::size_t line = line_column(*first.span.source, first.span.begin).line;
  const std::string times = first.code == Code::E815
                                ? fmt::format("{} times", count)
                                : fmt::format("and so for {}", counted(count - 1, "other"));
  return {first.code, {}, fmt::format("{}, {}, from line {} on", first.message, times, line)};
}

bool is_note(const Diagnostic& diagnostic) {
  return code_row(diagnostic.code).severity == Severity::note && diagnostic.span.source != nullptr;
}

}  // namespace

Diagnostics one_per_kind(const Diagnostics& diagnostics) {
  std::map<Kind, std::size_t> counts;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (is_note(diagnostic)) ++counts[kind_of(diagnostic)];
  }
  Diagnostics kept;
  std::set<Kind> said;
  for (const Diagnostic& diagnostic : diagnostics) {
    const std::size_t count = is_note(diagnostic) ? counts[kind_of(diagnostic)] : 1;
    if (count == 1) {
      kept.push_back(diagnostic);
    } else if (said.insert(kind_of(diagnostic)).second) {
      kept.push_back(summary_of(diagnostic, count));
    }
  }
  return kept;
}

}  // namespace elgen::cli
