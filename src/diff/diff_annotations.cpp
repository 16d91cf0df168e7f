// diff_annotations: causes alone; what follows from them has no place in a file.
#include <fmt/format.h>

#include <set>

#include "base/workflow_command.hpp"
#include "diff/change_words.hpp"
#include "elgen/diff.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

/// What GitHub shows of one step.
constexpr std::size_t most_annotations = 10;

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
      // What is gone has no place in the newer version.
      const Span place = key.after.empty() ? Span{} : key.new_at;
      commands.push_back({level, place, title, text_of(key)});
    }
  }
  return commands;
}

}  // namespace

std::string to_annotations(const DiffReport& report) {
  std::vector<WorkflowCommand> commands = causes(report);
  if (commands.size() > most_annotations) {
    const std::size_t left = commands.size() - (most_annotations - 1);
    commands.resize(most_annotations - 1);
    commands.push_back({commands.front().level,
                        {},
                        commands.front().title,
                        fmt::format("{} more changed", counted(left, "key"))});
  }
  std::string text;
  for (const WorkflowCommand& command : commands) text += text_of(command);
  return text;
}

}  // namespace elgen
