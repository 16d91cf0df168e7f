// diff_annotations: annotations for failing systems, then for changed keys. Changed entries have no
// place in a file, so they get no annotations.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostic_words.hpp"
#include "diff/change_words.hpp"
#include "elgen/diff.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

/// The number of annotations that GitHub shows per step and level.
constexpr std::size_t most_annotations = 10;

/// One error with all reasons why the system breaks. The place of the error is the first key that
/// breaks the system and exists in the newer version.
WorkflowCommand broken_system_annotation(const DiffReport& report, const SystemChange& system) {
  std::string reasons;
  for (const InterfaceChange& change : system.interface) {
    if (change.impact != Impact::breaks) continue;
    reasons += (reasons.empty() ? "" : "; ") + change.text;
  }
  const auto key = std::ranges::find_if(system.keys, [](const KeyChange& change) {
    return !change.after.empty() && change.impact == Impact::breaks;
  });
  return {"error", key == system.keys.end() ? Span{} : key->new_span, "elgen diff: breaks",
          fmt::format("{}: {}", label_of(report, system), reasons)};
}

/// An error for each system that breaks, was removed, or cannot be read.
std::vector<WorkflowCommand> failure_annotations(const DiffReport& report) {
  std::vector<WorkflowCommand> commands;
  for (const SystemChange& system : report.systems) {
    if (system.impact == Impact::breaks)
      commands.push_back(broken_system_annotation(report, system));
  }
  for (const std::string& path : report.removed) {
    commands.push_back({"error", {}, "elgen diff: breaks", path + " is removed"});
  }
  for (const UnreadableSystem& system : report.unreadable) {
    commands.push_back({"error", system.error.span, "elgen diff: unreadable", text_of(system)});
  }
  return commands;
}

/// A changed key, and its impact on each system.
struct KeyImpact {
  const KeyChange* key = nullptr;
  Impact impact = Impact::equal;  ///< the worst impact on a system
  bool is_certain = true;
  std::string systems = {};  ///< impacts: "cart_pole: different, cart_pole_balance: values"
};

/// All changed keys, sorted by impact, the worst first.
std::vector<KeyImpact> collect_key_impacts(const DiffReport& report) {
  std::vector<KeyImpact> found;
  std::map<std::string, std::size_t> known;
  for (const SystemChange& system : report.systems) {
    for (const KeyChange& key : system.keys) {
      const auto at = known.emplace(place_text(key) + text_of(key), found.size()).first;
      if (at->second == found.size()) found.push_back({&key});
      KeyImpact& cause = found[at->second];
      cause.impact = std::max(cause.impact, key.impact);
      cause.is_certain = cause.is_certain && system.is_certain;
      cause.systems += fmt::format("{}{}: {}", cause.systems.empty() ? "" : ", ",
                                   label_of(report, system), impact_row(key.impact).word);
    }
  }
  std::ranges::stable_sort(found, std::greater(), &KeyImpact::impact);
  return found;
}

WorkflowCommand key_annotation(const KeyImpact& cause, const Span& place, std::string message) {
  const std::string_view level = cause.impact < Impact::different ? "notice" : "warning";
  return {level, place,
          fmt::format("elgen diff: {} ({})", impact_row(cause.impact).word,
                      impact_meaning(cause.impact, cause.is_certain)),
          std::move(message)};
}

std::vector<WorkflowCommand> key_annotations(const DiffReport& report) {
  const std::vector<KeyImpact> all = collect_key_impacts(report);
  const std::size_t shown = all.size() > most_annotations ? most_annotations - 1 : all.size();
  std::vector<WorkflowCommand> commands;
  for (std::size_t i = 0; i < shown; ++i) {
    const KeyChange& key = *all[i].key;
    const std::string systems =
        has_several_systems(report) ? fmt::format(" ({})", all[i].systems) : "";
    // A removed key has no place in the newer version.
    const Span place = key.after.empty() ? Span{} : key.new_span;
    commands.push_back(key_annotation(all[i], place, text_of(key) + systems));
  }
  if (shown < all.size()) {
    const std::string rest = count_text(all.size() - shown, "key");
    commands.push_back(key_annotation(all[shown], {}, fmt::format("{} more changed", rest)));
  }
  return commands;
}

}  // namespace

std::string to_annotations(const DiffReport& report) {
  std::string text;
  for (const WorkflowCommand& command : failure_annotations(report)) text += text_of(command);
  for (const WorkflowCommand& command : key_annotations(report)) text += text_of(command);
  return text;
}

}  // namespace elgen
