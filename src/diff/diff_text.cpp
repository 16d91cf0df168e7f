// diff_text: writes a report as lines with labels, in plain text and in Markdown. A line that
// applies to several systems appears once. Markdown has equations in code blocks, in which no
// character is markup.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diff/change_words.hpp"
#include "elgen/diff.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

struct SummaryLine {
  std::string label = {};  ///< "changed"; "" for a further line of the same label
  std::string text = {};
  std::string systems = {};  ///< systems with this line: "cart_pole, cart_pole_balance"
};
using SummaryLines = std::vector<SummaryLine>;

constexpr std::size_t most_keys = 5;       ///< further keys are only counted
constexpr std::size_t most_interface = 6;  ///< further changes are only counted
constexpr std::size_t most_operations = 3;
constexpr std::size_t max_named_expectations = 4;  ///< number of named expectations

/// The lines under one label. A text of several systems appears once, with all these systems.
class SummarySection {
 public:
  SummarySection(SummaryLines& lines, std::string label, std::size_t most = SIZE_MAX)
      : lines_(lines), label_(std::move(label)), most_(most) {}

  void add(const std::string& text, const std::string& system) {
    if (text.empty()) return;
    const auto [known, is_new] = known_.emplace(text, lines_.size());
    if (is_new && known_.size() > most_) known->second = SIZE_MAX;
    if (known->second == SIZE_MAX) return;
    if (is_new) lines_.push_back({std::exchange(label_, ""), text});
    std::string& systems = lines_[known->second].systems;
    systems += (systems.empty() ? "" : ", ") + system;
  }

  /// Adds a line with the number of texts that were left out.
  void add_rest_count(std::string_view noun) {
    if (known_.size() <= most_) return;
    lines_.push_back(
        {"", fmt::format("{} more (--list)", count_text(known_.size() - most_, noun))});
  }

  [[nodiscard]] bool is_empty() const { return known_.empty(); }

 private:
  SummaryLines& lines_;
  std::string label_;
  std::size_t most_;
  std::map<std::string, std::size_t> known_ = {};  ///< index of the line by text; SIZE_MAX: no line
};

/// The symbol of a part of the equations of motion, and the output that contains this part.
struct EquationTerm {
  std::string_view symbol;
  OutputKind kind;
};
constexpr std::array equation_terms{EquationTerm{"T", OutputKind::kinetic_energy},
                                    EquationTerm{"V", OutputKind::potential_energy},
                                    EquationTerm{"D", OutputKind::dissipation},
                                    EquationTerm{"Q", OutputKind::applied_force},
                                    EquationTerm{"B", OutputKind::input_matrix},
                                    EquationTerm{"A", OutputKind::constraint_jacobian}};

/// A changed part in words: "V = a -> b", "V differs", "B: 2 of 3 entries differ, 0 rewritten", "V
/// is written differently".
std::string term_text(std::string_view symbol, const OutputChange& output) {
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

/// All parts in words: "V = a -> b;  T, D, Q, B identical".
std::string terms_text(const SystemChange& system) {
  std::string changed;
  std::string identical;
  for (const auto& [symbol, kind] : equation_terms) {
    const auto output =
        std::ranges::find(system.outputs, output_row(kind).name, &OutputChange::name);
    if (output == system.outputs.end()) continue;
    if (output->entries.empty()) {
      identical += fmt::format("{}{}", identical.empty() ? "" : ", ", symbol);
    } else {
      changed += (changed.empty() ? "" : ";  ") + term_text(symbol, *output);
    }
  }
  if (identical.empty()) return changed;
  return fmt::format("{}{}{} identical", changed, changed.empty() ? "" : ";  ", identical);
}

/// "[[expect]] was not updated: 1 entry no longer holds (bias[2])"; "" if all entries hold.
std::string expectations_text(const SystemChange& system) {
  std::vector<std::string> some = system.broken_expectations;
  if (some.empty()) return {};
  const std::size_t count = some.size();
  some.resize(std::min(count, max_named_expectations));
  return fmt::format("[[expect]] was not updated: {} no longer {} ({}{})",
                     count == 1 ? "1 entry" : fmt::format("{} entries", count),
                     count == 1 ? "holds" : "hold", fmt::join(some, ", "),
                     some.size() == count ? "" : ", ...");
}

/// The system with the largest number of differing entries; null if there are no systems.
const SystemChange* most_changed_system(const DiffReport& report) {
  const auto most = std::ranges::max_element(report.systems, {}, [](const SystemChange& system) {
    const VerdictCounts counts = counts_of(system);
    return std::pair(counts.different, counts.undecided);
  });
  return most == report.systems.end() ? nullptr : &*most;
}

/// The differing entry with the shortest text; if no entry differs, an undecided entry; null if
/// there is none.
const EntryChange* find_example(const SystemChange& system) {
  const EntryChange* best = nullptr;
  const auto rank = [](const EntryChange& entry) {
    const std::size_t read = change_text(entry).size();
    return std::pair(entry.verdict != EntryVerdict::different, read == 0 ? SIZE_MAX : read);
  };
  for (const OutputChange& output : system.outputs) {
    for (const EntryChange& entry : output.entries) {
      if (!may_differ(entry)) continue;
      if (best == nullptr || rank(entry) < rank(*best)) best = &entry;
    }
  }
  return best;
}

/// The lines of a report: files, changed keys, consequences, one entry as example, changes of the
/// interface, numbers of operations, verdict. If callers break, the changes of the interface come
/// before the changed keys. About a dozen lines unless `lists_all`.
class SummaryWriter {
 public:
  SummaryWriter(const DiffReport& report, bool lists_all)
      : report_(report), lists_all_(lists_all) {}

  SummaryLines operator()() {
    const Impact impact = impact_of(report_);
    add_files();
    if (std::ranges::any_of(report_.systems, has_changes)) {
      if (impact == Impact::breaks) add_interface();
      add_keys();
      add_consequences();
      if (impact != Impact::breaks) add_interface();
      add_operations();
    }
    if (has_several_systems(report_)) {
      add_text_per_system("verdict", [](const SystemChange& system) {
        return fmt::format("{}: {}", impact_row(system.impact).word,
                           impact_meaning(system.impact, system.is_certain));
      });
      for (SummaryLine& line : lines_) {
        if (!line.systems.empty()) line.text = line.systems + ": " + line.text;
      }
    }
    const bool is_certain = std::ranges::all_of(report_.systems, &SystemChange::is_certain);
    if (has_verdict(report_)) {
      lines_.push_back({std::string(impact_row(impact).word),
                        (report_.unreadable.empty() ? "" : "of the readable systems: ") +
                            impact_meaning(impact, is_certain)});
    }
    return std::move(lines_);
  }

 private:
  void add_line(std::string label, std::string text) {
    if (!text.empty()) lines_.push_back({std::move(label), std::move(text)});
  }

  [[nodiscard]] std::string label(const SystemChange& system) const {
    return label_of(report_, system);
  }

  /// Adds the text words(system) for each system, under the label `heading`.
  template <class TextOf>
  void add_text_per_system(std::string heading, const TextOf& words) {
    SummarySection section(lines_, std::move(heading));
    for (const SystemChange& system : report_.systems) section.add(words(system), label(system));
  }

  [[nodiscard]] std::size_t line_limit(std::size_t few) const {
    return lists_all_ ? SIZE_MAX : few;
  }

  void add_files() {
    for (const std::string& path : report_.added) add_line("added", path);
    for (const std::string& path : report_.removed) add_line("removed", path);
    for (const UnreadableSystem& system : report_.unreadable)
      add_line("unreadable", text_of(system));
  }

  void add_keys() {
    SummarySection section(lines_, "changed", line_limit(most_keys));
    for (const bool are_expectations : {false, true}) {
      for (const SystemChange& system : report_.systems) {
        for (const KeyChange& key : system.keys) {
          if ((key.table == "expect") != are_expectations) continue;
          section.add(place_text(key) + text_of(key), label(system));
        }
      }
    }
    section.add_rest_count("key");
  }

  void add_consequences() {
    add_text_per_system("", [](const SystemChange& system) {
      return system.keys.empty() ? "" : terms_text(system);
    });
    add_text_per_system("", [](const SystemChange& system) { return expectations_text(system); });
    add_warnings();
    add_text_per_system("follows", [](const SystemChange& system) {
      const VerdictCounts counts = counts_of(system);
      return counts.all > 0 ? counts.text() : "";
    });
    add_text_per_system("", [](const SystemChange& system) { return system.extension; });
    const SystemChange* const system = most_changed_system(report_);
    const EntryChange* const entry = system == nullptr ? nullptr : find_example(*system);
    if (entry == nullptr) return;
    SummarySection section(lines_, "example");
    section.add(text_of(*entry), label(*system));
    section.add(witness_text(*entry), label(*system));
  }

  void add_warnings() {
    SummarySection section(lines_, "warns");
    for (const SystemChange& system : report_.systems) {
      for (const Diagnostic& warning : system.warnings) {
        section.add(fmt::format("{}: {}", code_row(warning.code).name, warning.message),
                    label(system));
      }
    }
  }

  void add_interface() {
    using Change = std::pair<const InterfaceChange*, const SystemChange*>;
    std::vector<Change> changes;
    for (const SystemChange& system : report_.systems) {
      for (const InterfaceChange& change : system.interface) changes.emplace_back(&change, &system);
    }
    if (changes.empty()) return add_line("interface", "unchanged");
    std::ranges::stable_sort(changes, std::greater(), [](const Change& change) {
      return std::pair(change.first->impact, change.first->is_silent);
    });
    SummarySection section(lines_, "interface", line_limit(most_interface));
    for (const auto& [change, system] : changes) {
      section.add(fmt::format("{}: {}", impact_row(change->impact).word, change->text),
                  label(*system));
    }
    section.add_rest_count("change");
  }

  /// Adds the changed numbers of operations. Adds nothing if a system lacks its numbers, because
  /// the lines of the other systems would look complete.
  void add_operations() {
    SummarySection section(lines_, "operations", line_limit(most_operations));
    for (const SystemChange& system : report_.systems) {
      if (!system.operations) return;
    }
    for (const SystemChange& system : report_.systems) {
      for (const OperationsChange& change : *system.operations) {
        section.add(text_of(change), label(system));
      }
    }
    if (section.is_empty()) return add_line("operations", "unchanged");
    section.add_rest_count("function");
  }

  const DiffReport& report_;
  bool lists_all_;
  SummaryLines lines_ = {};
};

void append_entry_lines(const OutputChange& output, std::vector<std::string>& lines) {
  for (const EntryChange& entry : output.entries) {
    lines.push_back(text_of(entry));
    std::string witness = witness_text(entry);
    if (!witness.empty()) lines.push_back(std::move(witness));
  }
}

/// The lines with their labels in a separate column.
std::string text_of(const SummaryLines& lines) {
  std::string text;
  for (const SummaryLine& line : lines) {
    text += fmt::format("{:<13}{}\n", line.label, line.text);
  }
  return text;
}

/// The entries of one system that are not identical, in words.
struct EntryList {
  std::string system = {};
  std::vector<std::string> lines = {};
};

std::vector<EntryList> entry_lists(const DiffReport& report) {
  std::vector<EntryList> lists;
  for (const SystemChange& system : report.systems) {
    EntryList list{label_of(report, system), {}};
    for (const OutputChange& output : system.outputs) append_entry_lines(output, list.lines);
    if (!list.lines.empty()) lists.push_back(std::move(list));
  }
  return lists;
}

/// The largest number of lines per system: a comment on GitHub has at most 65 536 characters.
constexpr std::size_t most_lines = 200;

/// A fence that is longer than any sequence of backticks in the text.
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

/// A <details> element, which readers can unfold.
std::string details_element(const EntryList& list) {
  std::string text;
  for (std::size_t i = 0; i < std::min(list.lines.size(), most_lines); ++i) {
    text += list.lines[i] + "\n";
  }
  if (list.lines.size() > most_lines) {
    text += fmt::format("{} more\n", count_text(list.lines.size() - most_lines, "line"));
  }
  return fmt::format("<details><summary>Entries of {}</summary>\n\n{}\n</details>\n", list.system,
                     code_block(text));
}

}  // namespace

bool has_verdict(const DiffReport& report) {
  const bool is_anything =
      !report.systems.empty() || !report.added.empty() || !report.removed.empty();
  return is_anything || report.unreadable.empty();
}

Impact impact_of(const DiffReport& report) {
  Impact worst = report.added.empty() ? Impact::equal : Impact::extended;
  if (!report.removed.empty()) worst = Impact::breaks;
  for (const SystemChange& system : report.systems) worst = std::max(worst, system.impact);
  return worst;
}

std::string to_text(const DiffReport& report, bool lists_all) {
  std::string text = text_of(SummaryWriter(report, lists_all)());
  if (!lists_all) return text;
  for (const auto& [system, entries] : entry_lists(report)) {
    SummaryLines lines;
    for (const std::string& entry : entries) lines.push_back({"", entry});
    text += "\n" + system + "\n" + text_of(lines);
  }
  return text;
}

std::string to_markdown(const DiffReport& report) {
  SummaryLines lines = SummaryWriter(report, false)();
  std::string text = "### elgen diff: unreadable\n";
  if (has_verdict(report)) {
    text = fmt::format("### elgen diff: {} ({})\n", lines.back().label, lines.back().text);
    lines.pop_back();
  }
  if (!lines.empty()) text += "\n" + code_block(text_of(lines));
  for (const EntryList& list : entry_lists(report)) text += "\n" + details_element(list);
  return text;
}

}  // namespace elgen
