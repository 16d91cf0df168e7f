// change_words: shortens long texts, and describes an entry without a closed form by its verdict.
#include "diff/change_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostic_words.hpp"

namespace elgen {
namespace {

constexpr std::size_t longest_value = 60;  ///< characters of a key's value

std::string shorten(const std::string& text) {
  if (text.size() <= longest_value) return text;
  return text.substr(0, longest_value - 3) + "...";
}

/// The unit of the entry after a space, " m/s"; "" if the entry has no unit or the unit 1.
std::string unit_suffix(const EntryChange& entry) {
  return entry.unit.empty() || entry.unit == "1" ? "" : " " + entry.unit;
}

std::string verdict_text(const EntryChange& entry) {
  switch (entry.verdict) {
    case EntryVerdict::equal:
      return entry.is_proved ? "equal, written differently (proved)"
                             : "equal, written differently (at 64 random points)";
    case EntryVerdict::added:
      return "is new";
    case EntryVerdict::removed:
      return "is removed";
    default:
      return "identical";
  }
}

}  // namespace

std::string place_text(const KeyChange& change) {
  const Span& span = change.after.empty() ? change.old_span : change.new_span;
  if (span.source == nullptr) return {};
  const LineColumn at = line_column(*span.source, span.begin);
  return fmt::format("{}:{}:{}  ", span.source->path, at.line, at.column);
}

std::string text_of(const KeyChange& change) {
  std::string place = change.entry;
  const std::string key = change.is_reordering ? "order" : text_of(change.path);
  if (!key.empty()) place += (place.empty() ? "" : " ") + key;
  if (change.before.empty()) return fmt::format("{} is new: {}", place, shorten(change.after));
  if (change.after.empty()) return fmt::format("{} is removed: {}", place, shorten(change.before));
  return fmt::format("{}: {} -> {}", place, shorten(change.before), shorten(change.after));
}

std::string impact_meaning(Impact impact, bool is_certain) {
  std::string words(impact_row(impact).doc);
  if (is_certain || impact >= Impact::different) return words;
  return fmt::format("{}, compared at {} points only (see --strict)", words, zero_sample_count);
}

std::string label_of(const DiffReport& report, const SystemChange& system) {
  const bool is_alone = std::ranges::count(report.systems, system.name, &SystemChange::name) < 2;
  return is_alone || system.path.empty() ? system.name
                                         : fmt::format("{} ({})", system.name, system.path);
}

bool has_several_systems(const DiffReport& report) {
  const bool has_files =
      !report.added.empty() || !report.removed.empty() || !report.unreadable.empty();
  return report.systems.size() > 1 || has_files;
}

std::string text_of(const UnreadableSystem& system) {
  return fmt::format("{}: {}: {}", system.path, code_row(system.error.code).name,
                     message_with_hint(system.error));
}

bool may_differ(const EntryChange& entry) {
  return entry.verdict == EntryVerdict::different || entry.verdict == EntryVerdict::undecided;
}

void VerdictCounts::add(const OutputChange& output) {
  all += output.entry_count;
  std::size_t news = 0;
  std::size_t olds = 0;
  for (const EntryChange& entry : output.entries) {
    different += entry.verdict == EntryVerdict::different ? 1 : 0;
    undecided += entry.verdict == EntryVerdict::undecided ? 1 : 0;
    rewritten += entry.verdict == EntryVerdict::equal ? 1 : 0;
    proved += entry.verdict == EntryVerdict::equal && entry.is_proved ? 1 : 0;
    news += entry.verdict == EntryVerdict::added ? 1 : 0;
    olds += entry.verdict == EntryVerdict::removed ? 1 : 0;
  }
  const std::size_t pairs = std::min(news, olds);
  replaced += pairs;
  added += news - pairs;
  removed += olds - pairs;
}

std::string VerdictCounts::text() const {
  std::string result = fmt::format("{} of {} entries {}, {} rewritten", different, all,
                                   different == 1 ? "differs" : "differ", rewritten);
  if (rewritten > 0) {
    result += proved == rewritten ? " (proved)" : fmt::format(" ({} proved)", proved);
  }
  if (undecided > 0) {
    result += fmt::format(", {} undecided at {} points", undecided, zero_sample_count);
  }
  if (replaced > 0) result += fmt::format(", {} replaced", replaced);
  if (added > 0) result += fmt::format(", {} added", added);
  if (removed > 0) result += fmt::format(", {} removed", removed);
  return result;
}

VerdictCounts counts_of(const SystemChange& system) {
  VerdictCounts counts;
  for (const OutputChange& output : system.outputs) counts.add(output);
  return counts;
}

std::string change_text(const EntryChange& entry) {
  if (entry.before.empty() || entry.after.empty()) return {};
  return fmt::format("{} -> {}", entry.before, entry.after);
}

std::string witness_text(const EntryChange& entry) {
  if (!entry.witness) return {};
  const auto& [at, before, after] = *entry.witness;
  const std::string share = entry.relative_change > 0 ? fmt::format(", {:.2g} of the largest entry",
                                                                    entry.relative_change)
                                                      : std::string();
  return fmt::format("{}{:.3g} -> {:.3g}{}{}", at.empty() ? "" : "at " + at + ": ", before, after,
                     unit_suffix(entry), share);
}

std::string text_of(const EntryChange& entry) {
  if (!may_differ(entry)) return entry.place + ": " + verdict_text(entry);
  const std::string change = change_text(entry);
  std::string text = entry.place;
  if (!change.empty()) {
    text += " = " + change;
  } else if (entry.is_certain) {
    text += " differs";
  }
  if (!entry.difference.empty()) text += fmt::format(", difference {}", entry.difference);
  if (!entry.is_certain) text += fmt::format(", undecided at {} points", zero_sample_count);
  return text;
}

std::string text_of(const OperationsChange& change) {
  std::string text;
  for (const auto& [name, count] : operation_columns) {
    const std::size_t before = change.before.*count;
    const std::size_t after = change.after.*count;
    if (before == after) continue;
    text += fmt::format("{}{} {} -> {}", text.empty() ? "" : ", ", name, before, after);
  }
  return fmt::format("{}: {}", change.function, text);
}

}  // namespace elgen
