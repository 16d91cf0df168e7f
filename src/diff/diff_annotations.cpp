// SPDX-License-Identifier: GPL-3.0-or-later
// diff_annotations: systems that fail, then causes; what follows from these has no place in a file.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/diagnostic_words.hpp"
#include "base/workflow_command.hpp"
#include "diff/change_words.hpp"
#include "elgen/diff.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

/// The number of annotations that GitHub shows of one step at one level.
constexpr std::size_t most_annotations = 10;

/// All that breaks it, at the first key that is there.
WorkflowCommand broken_system(const SystemChange& system) {
  std::string reasons;
  for (const InterfaceChange& change : system.interface) {
    if (change.impact != Impact::breaks) continue;
    reasons += (reasons.empty() ? "" : "; ") + change.text;
  }
  const auto key = std::ranges::find_if(
      system.keys, [](const KeyChange& change) { return !change.after.empty(); });
  return {"error", key == system.keys.end() ? Span{} : key->new_at, "elgen diff: breaks",
          fmt::format("{}: {}", system.name, reasons)};
}

/// One for every system that breaks, is gone or cannot be read.
std::vector<WorkflowCommand> failures(const DiffReport& report) {
  std::vector<WorkflowCommand> commands;
  for (const SystemChange& system : report.systems) {
    if (system.impact == Impact::breaks) commands.push_back(broken_system(system));
  }
  for (const std::string& path : report.removed) {
    commands.push_back({"error", {}, "elgen diff: breaks", path + " is gone"});
  }
  for (const auto& [path, error] : report.unreadable) {
    commands.push_back(
        {"error", error.span, "elgen diff: unreadable",
         fmt::format("{}: {}: {}", path, code_row(error.code).name, sentence(error))});
  }
  return commands;
}

std::vector<WorkflowCommand> causes(const DiffReport& report) {
  const Impact impact = impact_of(report);
  const ImpactRow& row = impact_row(impact);
  const std::string title = fmt::format("elgen diff: {} ({})", row.word, row.doc);
  const std::string_view level = impact < Impact::different ? "notice" : "warning";
  std::vector<WorkflowCommand> commands;
  std::set<std::string> known;
  for (const SystemChange& system : report.systems) {
    for (const KeyChange& key : system.keys) {
      if (!known.insert(place_text(key) + text_of(key)).second) continue;
      // A removed key has no place in the newer version.
      const Span place = key.after.empty() ? Span{} : key.new_at;
      commands.push_back({level, place, title, text_of(key)});
    }
  }
  if (commands.size() > most_annotations) {
    const std::size_t left = commands.size() - (most_annotations - 1);
    commands.resize(most_annotations - 1);
    commands.push_back({level, {}, title, fmt::format("{} more changed", counted(left, "key"))});
  }
  return commands;
}

}  // namespace

std::string to_annotations(const DiffReport& report) {
  std::string text;
  for (const WorkflowCommand& command : failures(report)) text += text_of(command);
  for (const WorkflowCommand& command : causes(report)) text += text_of(command);
  return text;
}

}  // namespace elgen
