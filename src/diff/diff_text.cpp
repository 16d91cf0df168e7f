// SPDX-License-Identifier: GPL-3.0-or-later
// diff_text: a report in lines with labels, as text and as Markdown. Lines that systems share are
// said once. Equations stand in blocks of code, in which no sign is a mark of Markdown.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "diff/change_words.hpp"
#include "elgen/diff.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

struct SummaryLine {
  std::string label = {};  ///< "changed"; "" where it goes on
  std::string text = {};
};
using SummaryLines = std::vector<SummaryLine>;

constexpr std::size_t most_keys = 5;       ///< and the others counted
constexpr std::size_t most_interface = 6;  ///< likewise
constexpr std::size_t most_operations = 3;
constexpr std::size_t most_named = 4;  ///< of expectations

/// Lines of one label, each text once.
class Section {
 public:
  Section(SummaryLines& lines, std::string label) : lines_(lines), label_(std::move(label)) {}

  bool is_known(const std::string& text) { return !known_.insert(text).second; }

  void add(std::string text) { lines_.push_back({std::exchange(label_, ""), std::move(text)}); }

 private:
  SummaryLines& lines_;
  std::string label_;
  std::set<std::string> known_ = {};
};

/// The parts that the equations are made of.
struct Part {
  std::string_view symbol;
  OutputKind kind;
};
constexpr std::array parts{
    Part{"T", OutputKind::kinetic_energy}, Part{"V", OutputKind::potential_energy},
    Part{"D", OutputKind::dissipation},    Part{"Q", OutputKind::applied_force},
    Part{"B", OutputKind::input_matrix},   Part{"A", OutputKind::constraint_jacobian}};

/// "V = a -> b", "V differs", "B: 2 of 3 entries differ, 0 rewritten", "V is written differently"
std::string part_text(std::string_view symbol, const OutputChange& output) {
  VerdictCounts counts;
  counts.add(output);
  if (counts.changed() + counts.undecided == 0) {
    return fmt::format("{} is written differently", symbol);
  }
  const bool is_one = counts.different == 1 && counts.all == 1;
  if (!is_one) return fmt::format("{}: {}", symbol, counts.text());
  const std::string change = change_text(output.entries.front());
  return change.empty() ? fmt::format("{} differs", symbol)
                        : fmt::format("{} = {}", symbol, change);
}

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
    } else {
      changed += (changed.empty() ? "" : ";  ") + part_text(symbol, *output);
    }
  }
  if (identical.empty()) return changed;
  return fmt::format("{}{}{} identical", changed, changed.empty() ? "" : ";  ", identical);
}

/// The system in which most follows from the changes.
const SystemChange* most_changed(const DiffReport& report) {
  const auto most = std::ranges::max_element(report.systems, {}, [](const SystemChange& system) {
    const VerdictCounts counts = counts_of(system);
    return std::pair(counts.different, counts.undecided);
  });
  return most == report.systems.end() ? nullptr : &*most;
}

/// The shortest of the entries that differ, where one can be read; else of those that may.
const EntryChange* example(const SystemChange& system) {
  const EntryChange* best = nullptr;
  const auto rank = [](const EntryChange& entry) {
    const std::size_t read = change_text(entry).size();
    return std::pair(entry.verdict != EntryVerdict::different, read == 0 ? SIZE_MAX : read);
  };
  for (const OutputChange& output : system.outputs) {
    for (const EntryChange& entry : output.entries) {
      const bool may_differ =
          entry.verdict == EntryVerdict::different || entry.verdict == EntryVerdict::not_told_apart;
      if (!may_differ) continue;
      if (best == nullptr || rank(entry) < rank(*best)) best = &entry;
    }
  }
  return best;
}

/// Causes first, then what follows, one entry in full, what callers see, and the verdict; where
/// callers break, what they see stands before the causes. At most about a dozen unless `lists_all`.
class Summary {
 public:
  Summary(const DiffReport& report, bool lists_all) : report_(report), lists_all_(lists_all) {}

  SummaryLines operator()() {
    const Impact impact = impact_of(report_);
    add_files();
    if (std::ranges::any_of(report_.systems, has_changes)) {
      if (impact == Impact::breaks) add_interface();
      add_keys();
      if (const SystemChange* const system = most_changed(report_)) add_consequences(*system);
      if (impact != Impact::breaks) add_interface();
      add_operations();
    }
    const bool is_told_apart = std::ranges::all_of(report_.systems, &SystemChange::is_told_apart);
    lines_.push_back({std::string(impact_row(impact).word), meaning(impact, is_told_apart)});
    return std::move(lines_);
  }

 private:
  void add(std::string label, std::string text) {
    if (!text.empty()) lines_.push_back({std::move(label), std::move(text)});
  }

  void add_files() {
    for (const std::string& path : report_.added) add("added", path);
    for (const std::string& path : report_.removed) add("removed", path);
  }

  void add_keys() {
    Section section(lines_, "changed");
    std::size_t count = 0;
    for (const bool are_expectations : {false, true}) {
      for (const SystemChange& system : report_.systems) {
        for (const KeyChange& key : system.keys) {
          if ((key.table == "expect") != are_expectations) continue;
          const std::string text = place_text(key) + text_of(key);
          if (section.is_known(text) || (++count > most_keys && !lists_all_)) continue;
          section.add(text);
        }
      }
    }
    if (count > most_keys && !lists_all_) {
      section.add(fmt::format("{} more (--list)", counted(count - most_keys, "key")));
    }
  }

  void add_consequences(const SystemChange& system) {
    if (!system.keys.empty()) add("", parts_text(system));
    add_expectations();
    add_warnings();
    add_counts();
    add("", system.extension);
    if (const EntryChange* const entry = example(system)) {
      add("for one", text_of(*entry));
      add("", witness_text(*entry));
    }
  }

  void add_expectations() {
    std::set<std::string> broken;
    for (const SystemChange& system : report_.systems) {
      broken.insert(system.broken_expectations.begin(), system.broken_expectations.end());
    }
    if (broken.empty()) return;
    std::vector<std::string> some(broken.begin(), broken.end());
    const bool are_all = some.size() <= most_named;
    some.resize(std::min(some.size(), most_named));
    add("", fmt::format("[[expect]] is not changed with it: {} no longer {} ({}{})",
                        broken.size() == 1 ? "1 entry" : fmt::format("{} entries", broken.size()),
                        broken.size() == 1 ? "holds" : "hold", fmt::join(some, ", "),
                        are_all ? "" : ", ..."));
  }

  void add_warnings() {
    Section section(lines_, "warns");
    for (const SystemChange& system : report_.systems) {
      for (const Diagnostic& warning : system.warnings) {
        const std::string text =
            fmt::format("{}: {}", code_row(warning.code).name, warning.message);
        if (!section.is_known(text)) section.add(text);
      }
    }
  }

  void add_counts() {
    VerdictCounts all;
    std::string systems;
    for (const SystemChange& system : report_.systems) {
      const VerdictCounts counts = counts_of(system);
      for (const OutputChange& output : system.outputs) all.add(output);
      if (counts.changed() == 0) continue;
      systems += fmt::format("{}{} {} of {}", systems.empty() ? "" : ", ", system.name,
                             counts.changed(), counts.all);
    }
    if (all.all > 0) add("follows", all.text());
    if (report_.systems.size() > 1) add("", systems);
  }

  void add_interface() {
    Section section(lines_, "interface");
    std::vector<const InterfaceChange*> changes;
    for (const SystemChange& system : report_.systems) {
      for (const InterfaceChange& change : system.interface) {
        if (!section.is_known(change.text)) changes.push_back(&change);
      }
    }
    if (changes.empty()) return section.add("unchanged");
    std::ranges::stable_sort(changes, std::greater(), [](const InterfaceChange* change) {
      return std::pair(change->impact, change->is_silent);
    });
    const std::size_t shown =
        lists_all_ ? changes.size() : std::min(changes.size(), most_interface);
    for (std::size_t i = 0; i < shown; ++i) {
      section.add(fmt::format("{}: {}", impact_row(changes[i]->impact).word, changes[i]->text));
    }
    if (shown < changes.size()) {
      section.add(fmt::format("{} more (--list)", changes.size() - shown));
    }
  }

  /// Of all systems, or of none: a part of them would be taken for all.
  void add_operations() {
    Section section(lines_, "operations");
    std::vector<std::string> changes;
    for (const SystemChange& system : report_.systems) {
      if (!system.operations) return;
      const std::string owner = report_.systems.size() > 1 ? system.name + "::" : std::string();
      for (const OperationsChange& change : *system.operations) {
        changes.push_back(owner + text_of(change));
      }
    }
    if (report_.systems.empty()) return;
    if (changes.empty()) return section.add("unchanged");
    const std::size_t shown =
        lists_all_ ? changes.size() : std::min(changes.size(), most_operations);
    for (std::size_t i = 0; i < shown; ++i) section.add(changes[i]);
    if (shown < changes.size()) {
      section.add(fmt::format("{} more (--list)", counted(changes.size() - shown, "function")));
    }
  }

  const DiffReport& report_;
  bool lists_all_;
  SummaryLines lines_ = {};
};

void add_lines(const OutputChange& output, std::vector<std::string>& lines) {
  for (const EntryChange& entry : output.entries) {
    lines.push_back(text_of(entry));
    std::string witness = witness_text(entry);
    if (!witness.empty()) lines.push_back(std::move(witness));
  }
}

/// Labels in a column of their own.
std::string text_of(const SummaryLines& lines) {
  std::string text;
  for (const auto& [label, words] : lines) text += fmt::format("{:<13}{}\n", label, words);
  return text;
}

/// The entries of one system that are not identical.
struct EntryList {
  std::string system = {};
  std::vector<std::string> lines = {};
};

std::vector<EntryList> entry_lists(const DiffReport& report) {
  std::vector<EntryList> lists;
  for (const SystemChange& system : report.systems) {
    EntryList list{system.name, {}};
    for (const OutputChange& output : system.outputs) add_lines(output, list.lines);
    if (!list.lines.empty()) lists.push_back(std::move(list));
  }
  return lists;
}

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

Impact impact_of(const DiffReport& report) {
  Impact worst = report.added.empty() ? Impact::equal : Impact::extended;
  if (!report.removed.empty()) worst = Impact::breaks;
  for (const SystemChange& system : report.systems) worst = std::max(worst, system.impact);
  return worst;
}

std::string to_text(const DiffReport& report, bool lists_all) {
  std::string text = text_of(Summary(report, lists_all)());
  if (!lists_all) return text;
  for (const auto& [system, entries] : entry_lists(report)) {
    SummaryLines lines;
    for (const std::string& entry : entries) lines.push_back({"", entry});
    text += "\n" + system + "\n" + text_of(lines);
  }
  return text;
}

std::string to_markdown(const DiffReport& report) {
  SummaryLines lines = Summary(report, false)();
  const SummaryLine verdict = lines.back();
  lines.pop_back();
  std::string text = fmt::format("### elgen diff: {} ({})\n", verdict.label, verdict.text);
  if (!lines.empty()) text += "\n" + code_block(text_of(lines));
  for (const EntryList& list : entry_lists(report)) text += "\n" + folded(list);
  return text;
}

}  // namespace elgen
