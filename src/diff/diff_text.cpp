// diff_text: causes first, then what follows, one entry in full, and what callers see.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "elgen/diff.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

constexpr std::size_t most_keys = 5;       ///< and the others counted
constexpr std::size_t most_interface = 6;  ///< likewise
constexpr std::size_t most_named = 4;      ///< of expectations
constexpr std::size_t longest_value = 60;  ///< of a key

/// Labels stand in a column of their own.
std::string line(std::string_view label, std::string_view text) {
  return fmt::format("{:<13}{}\n", label, text);
}

std::string where(const KeyChange& change) {
  const Span& span = change.after.empty() ? change.old_at : change.new_at;
  if (span.source == nullptr) return {};
  const LineColumn at = line_column(*span.source, span.begin);
  return fmt::format("{}:{}:{}  ", span.source->path, at.line, at.column);
}

std::string shortened(const std::string& text) {
  if (text.size() <= longest_value) return text;
  return text.substr(0, longest_value - 3) + "...";
}

std::string text_of(const KeyChange& change) {
  std::string place = change.entry;
  const std::string key = change.is_order ? "order" : elgen::text_of(change.path);
  if (!key.empty()) place += (place.empty() ? "" : " ") + key;
  if (change.before.empty()) return fmt::format("{} is new: {}", place, shortened(change.after));
  if (change.after.empty()) return fmt::format("{} is gone: {}", place, shortened(change.before));
  return fmt::format("{}: {} -> {}", place, shortened(change.before), shortened(change.after));
}

/// Entries by their verdicts.
struct VerdictCounts {
  std::size_t all = 0;
  std::size_t different = 0;
  std::size_t rewritten = 0;
  std::size_t added = 0;
  std::size_t removed = 0;

  void add(const OutputChange& output) {
    all += output.entry_count;
    for (const EntryChange& entry : output.entries) {
      different += entry.verdict == EntryVerdict::different ? 1 : 0;
      rewritten += entry.verdict == EntryVerdict::equal ? 1 : 0;
      added += entry.verdict == EntryVerdict::added ? 1 : 0;
      removed += entry.verdict == EntryVerdict::removed ? 1 : 0;
    }
  }

  [[nodiscard]] std::string text() const {
    std::string result = fmt::format("{} of {} entries {}, {} rewritten", different, all,
                                     different == 1 ? "differs" : "differ", rewritten);
    if (added > 0) result += fmt::format(", {} added", added);
    if (removed > 0) result += fmt::format(", {} removed", removed);
    return result;
  }
};

VerdictCounts counts_of(const SystemChange& system) {
  VerdictCounts counts;
  for (const OutputChange& output : system.outputs) counts.add(output);
  return counts;
}

std::string change_text(const EntryChange& entry) {
  if (entry.before.empty() || entry.after.empty()) return {};
  return fmt::format("{} -> {}", entry.before, entry.after);
}

/// What the equations are made of.
struct Part {
  std::string_view symbol;
  OutputKind kind;
};
constexpr std::array parts{Part{"T", OutputKind::kinetic_energy},
                           Part{"V", OutputKind::potential_energy},
                           Part{"D", OutputKind::dissipation}, Part{"Q", OutputKind::applied_force},
                           Part{"B", OutputKind::input_matrix}};

/// "V = a -> b;  T, D, Q, B identical"
std::string parts_text(const SystemChange& system) {
  std::string changed;
  std::string identical;
  for (const auto& [symbol, kind] : parts) {
    const auto output =
        std::ranges::find(system.outputs, output_row(kind).name, &OutputChange::name);
    if (output == system.outputs.end()) continue;
    if (output->entries.empty()) {
      identical += fmt::format("{}{}", identical.empty() ? "" : ", ", symbol);
      continue;
    }
    VerdictCounts counts;
    counts.add(*output);
    const EntryChange& first = output->entries.front();
    const bool is_one = counts.different == 1 && counts.all == 1;
    std::string text = fmt::format("{}: {}", symbol, counts.text());
    if (counts.different + counts.added + counts.removed == 0) {
      text = fmt::format("{} is written differently", symbol);
    } else if (is_one && !change_text(first).empty()) {
      text = fmt::format("{} = {}", symbol, change_text(first));
    }
    changed += (changed.empty() ? "" : ";  ") + text;
  }
  if (!identical.empty()) {
    changed += fmt::format("{}{} identical", changed.empty() ? "" : ";  ", identical);
  }
  return changed;
}

std::string key_lines(const DiffReport& report, bool lists_all) {
  std::string text;
  std::set<std::string> known;
  std::size_t count = 0;
  for (const bool are_expectations : {false, true}) {
    for (const SystemChange& system : report.systems) {
      for (const KeyChange& key : system.keys) {
        if ((key.table == "expect") != are_expectations) continue;
        const std::string one = where(key) + text_of(key);
        if (!known.insert(one).second || (++count > most_keys && !lists_all)) continue;
        text += line(text.empty() ? "changed" : "", one);
      }
    }
  }
  if (count > most_keys && !lists_all) {
    text += line("", fmt::format("{} more (--list)", counted(count - most_keys, "key")));
  }
  return text;
}

std::string warning_lines(const DiffReport& report) {
  std::set<std::string> known;
  std::string text;
  for (const SystemChange& system : report.systems) {
    for (const Diagnostic& warning : system.warnings) {
      const std::string one = fmt::format("{}: {}", code_row(warning.code).name, warning.message);
      if (known.insert(one).second) text += line(text.empty() ? "warns" : "", one);
    }
  }
  return text;
}

std::string expectation_lines(const DiffReport& report) {
  std::set<std::string> broken;
  for (const SystemChange& system : report.systems) {
    broken.insert(system.broken_expectations.begin(), system.broken_expectations.end());
  }
  if (broken.empty()) return {};
  std::vector<std::string> some(broken.begin(), broken.end());
  const bool are_all = some.size() <= most_named;
  some.resize(std::min(some.size(), most_named));
  return line("",
              fmt::format("[[expect]] is not changed with it: {} no longer {} ({}{})",
                          broken.size() == 1 ? "1 entry" : fmt::format("{} entries", broken.size()),
                          broken.size() == 1 ? "holds" : "hold", fmt::join(some, ", "),
                          are_all ? "" : ", ..."));
}

std::string proposal_line(const SystemChange& system) {
  if (system.proposal.empty()) return {};
  std::string options;
  for (const auto& [old, now] : system.proposal)
    options += fmt::format(" --rename {}={}", old, now);
  return line("renamed?", fmt::format("with{} all entries are equal", options));
}

std::string file_lines(const DiffReport& report) {
  std::string text;
  for (const std::string& path : report.added) text += line("added", path);
  for (const std::string& path : report.removed) text += line("removed", path);
  return text;
}

/// The system in which most follows from the changes.
const SystemChange* most_changed(const DiffReport& report) {
  const auto most = std::ranges::max_element(
      report.systems, {}, [](const SystemChange& system) { return counts_of(system).different; });
  return most == report.systems.end() ? nullptr : &*most;
}

std::string follow_lines(const DiffReport& report) {
  VerdictCounts all;
  std::string systems;
  for (const SystemChange& system : report.systems) {
    const VerdictCounts counts = counts_of(system);
    for (const OutputChange& output : system.outputs) all.add(output);
    if (counts.different + counts.added + counts.removed == 0) continue;
    systems += fmt::format("{}{} {} of {}", systems.empty() ? "" : ", ", system.name,
                           counts.different + counts.added + counts.removed, counts.all);
  }
  if (all.all == 0) return {};
  std::string text = line("follows", all.text());
  if (report.systems.size() > 1 && !systems.empty()) text += line("", systems);
  return text;
}

/// The unit where it has one.
std::string with_unit(const EntryChange& entry) {
  return entry.unit.empty() || entry.unit == "1" ? "" : " " + entry.unit;
}

std::string entry_lines(std::string_view label, const EntryChange& entry) {
  std::string text = change_text(entry);
  text = text.empty() ? " differs" : " = " + text;
  if (!entry.difference.empty()) text += fmt::format(", difference {}", entry.difference);
  std::string lines = line(label, entry.place + text);
  if (entry.witness) {
    const auto& [at, before, after] = *entry.witness;
    const std::string share =
        entry.share > 0 ? fmt::format(", {:.2g} of the largest", entry.share) : std::string();
    lines += line("", fmt::format("{}{:.3g} -> {:.3g}{}{}", at.empty() ? "" : "at " + at + ": ",
                                  before, after, with_unit(entry), share));
  }
  return lines;
}

/// The shortest of the entries that differ, where one can be read.
std::string example(const SystemChange& system) {
  const EntryChange* best = nullptr;
  const auto length = [](const EntryChange& entry) {
    const std::size_t read = change_text(entry).size();
    return read == 0 ? SIZE_MAX : read;
  };
  for (const OutputChange& output : system.outputs) {
    for (const EntryChange& entry : output.entries) {
      if (entry.verdict != EntryVerdict::different) continue;
      if (best == nullptr || length(entry) < length(*best)) best = &entry;
    }
  }
  return best == nullptr ? "" : entry_lines("for one", *best);
}

std::string verdict_text(const EntryChange& entry) {
  switch (entry.verdict) {
    case EntryVerdict::equal:
      return entry.is_proved ? "equal, written differently (proved)"
                             : "equal, written differently (at 64 random points)";
    case EntryVerdict::added:
      return "is new";
    case EntryVerdict::removed:
      return "is gone";
    default:
      return "identical";
  }
}

std::string all_entries(const DiffReport& report) {
  std::string text;
  for (const SystemChange& system : report.systems) {
    std::string entries;
    for (const OutputChange& output : system.outputs) {
      for (const EntryChange& entry : output.entries) {
        entries += entry.verdict == EntryVerdict::different
                       ? entry_lines("", entry)
                       : line("", entry.place + ": " + verdict_text(entry));
      }
    }
    if (!entries.empty()) text += "\n" + line(system.name, "") + entries;
  }
  return text;
}

std::string interface_lines(const DiffReport& report, bool lists_all) {
  std::vector<const InterfaceChange*> changes;
  std::set<std::string> known;
  for (const SystemChange& system : report.systems) {
    for (const InterfaceChange& change : system.interface) {
      if (known.insert(change.text).second) changes.push_back(&change);
    }
  }
  if (changes.empty()) return line("interface", "unchanged");
  std::ranges::stable_sort(changes, std::greater(), &InterfaceChange::impact);
  std::string text;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (i >= most_interface && !lists_all) {
      return text + line("", fmt::format("{} more (--list)", changes.size() - i));
    }
    text += line(i == 0 ? "interface" : "",
                 fmt::format("{}: {}", impact_row(changes[i]->impact).word, changes[i]->text));
  }
  return text;
}

}  // namespace

Impact impact_of(const DiffReport& report) {
  Impact worst = Impact::none;
  if (!report.added.empty()) worst = Impact::extended;
  if (!report.removed.empty()) worst = Impact::incompatible;
  for (const SystemChange& system : report.systems) worst = std::max(worst, system.impact);
  return worst;
}

std::string to_text(const DiffReport& report, bool lists_all) {
  const Impact impact = impact_of(report);
  const ImpactRow& row = impact_row(impact);
  const std::string verdict = line(row.word, row.doc);
  if (impact == Impact::none || impact == Impact::text) return verdict;
  const std::string interface = interface_lines(report, lists_all);
  std::string text;
  if (impact == Impact::misleading) text += interface;
  text += file_lines(report) + key_lines(report, lists_all);
  if (const SystemChange* const system = most_changed(report)) {
    if (const std::string told = parts_text(*system); !told.empty()) text += line("", told);
    text += expectation_lines(report) + warning_lines(report) + proposal_line(*system);
    text += follow_lines(report);
    if (!system->extension.empty()) text += line("", system->extension);
    text += example(*system);
  }
  if (impact != Impact::misleading) text += interface;
  return text + verdict + (lists_all ? all_entries(report) : "");
}

}  // namespace elgen
