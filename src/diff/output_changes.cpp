// output_changes: entries are joined output by output; only what is computed differently is looked
// at.
#include "diff/output_changes.hpp"

#include <algorithm>

#include "choose/guarded_pivots.hpp"
#include "diff/closed_texts.hpp"
#include "diff/joint_program.hpp"
#include "diff/matched_entries.hpp"
#include "diff/witness.hpp"
#include "diff/zeros.hpp"
#include "elgen/diff.hpp"
#include "lower/graph/prune.hpp"
#include "lower/network/instructions.hpp"

namespace elgen {
namespace {

const Function* find_named(const Program& program, const std::string& name) {
  const auto found = std::ranges::find(program.functions, name, &Function::name);
  return found == program.functions.end() ? nullptr : &*found;
}

/// What callers get of it.
Function visible(const Function& function) {
  return output_row(function.kind).gives_pivots ? without_diagonal(function) : function;
}

/// Of one output; more are told by their verdicts alone.
constexpr std::size_t most_told = 20;

class OutputComparison {
 public:
  OutputComparison(const Version& before, const Version& after, const Renames& renames,
                   const ParameterValues& values)
      : before_(before),
        after_(after),
        renames_(renames),
        values_(values),
        joint_(before.program, after.program, renames) {}

  std::vector<OutputChange> operator()() {
    std::vector<OutputChange> all;
    for (const Function& after : after_.program.functions) {
      if (output_row(after.kind).repeats) continue;
      const Function* const before = find_named(before_.program, after.name);
      all.push_back(before != nullptr ? compared(visible(*before), visible(after))
                                      : whole(visible(after), true));
    }
    for (const Function& before : before_.program.functions) {
      const bool is_gone = find_named(after_.program, before.name) == nullptr;
      if (is_gone && !output_row(before.kind).repeats) all.push_back(whole(visible(before), false));
    }
    return all;
  }

 private:
  static EntryChange named(const MatchedEntry& entry, EntryVerdict verdict) {
    return {.place = entry.place, .unit = entry.unit, .verdict = verdict};
  }

  /// Of an output that only one version has.
  OutputChange whole(const Function& function, bool is_new) const {
    const Model& model = (is_new ? after_ : before_).checked.model;
    OutputChange change{function.name, entry_count(function), {}};
    for (const MatchedEntry& entry : unmatched_entries(model, function, is_new)) {
      change.entries.push_back(named(entry, is_new ? EntryVerdict::added : EntryVerdict::removed));
    }
    return change;
  }

  OutputChange compared(const Function& before, const Function& after) {
    OutputChange change{after.name, std::max(entry_count(before), entry_count(after)), {}};
    JointFunction joint = joint_.joined(before, after, values_);
    Instructions instructions(joint.function);
    std::vector<Pair> open;
    for (const MatchedEntry& entry :
         matched_entries(before_.checked.model, before, after_.checked.model, after, renames_)) {
      if (!entry.before || !entry.after) {
        const EntryVerdict verdict = entry.after ? EntryVerdict::added : EntryVerdict::removed;
        change.entries.push_back(named(entry, verdict));
        continue;
      }
      const std::uint32_t x = joint.before[*entry.before];
      const std::uint32_t y = joint.after[*entry.after];
      if (x == y) continue;
      open.push_back({change.entries.size(), x, y, instructions.add(Opcode::subtract, y, x)});
      change.entries.push_back(named(entry, EntryVerdict::different));
    }
    settle(joint.function, open, change);
    return change;
  }

  /// Entries that are computed differently.
  struct Pair {
    std::size_t number = 0;  ///< among the changes
    std::uint32_t before = 0;
    std::uint32_t after = 0;
    std::uint32_t difference = 0;
  };

  void settle(const Function& function, const std::vector<Pair>& open, OutputChange& change) {
    if (open.empty()) return;
    std::vector<std::uint32_t> differences;
    for (const Pair& pair : open) differences.push_back(pair.difference);
    const Program& program = joint_.program();
    const std::vector<Zero> found = zeros(program, with_entries(function, differences));
    std::vector<Pair> different;
    for (std::size_t i = 0; i < open.size(); ++i) {
      EntryChange& entry = change.entries[open[i].number];
      if (found[i] == Zero::no || found[i] == Zero::not_decided) {
        entry.is_told_apart = found[i] == Zero::no;
        different.push_back(open[i]);
        continue;
      }
      entry.verdict = EntryVerdict::equal;
      entry.is_proved = found[i] == Zero::proved;
    }
    if (different.size() > most_told) different.resize(most_told);
    tell(function, different, change);
  }

  void tell(const Function& function, const std::vector<Pair>& different, OutputChange& change) {
    if (different.empty()) return;
    std::vector<std::uint32_t> places;
    for (const Pair& pair : different) {
      places.insert(places.end(), {pair.before, pair.after, pair.difference});
    }
    const std::vector<std::string> texts = closed_texts(joint_.program(), function, places);
    const WitnessStates states(before_, after_, joint_.program());
    for (std::size_t i = 0; i < different.size(); ++i) {
      EntryChange& entry = change.entries[different[i].number];
      entry.before = texts[3 * i];
      entry.after = texts[3 * i + 1];
      entry.difference = texts[3 * i + 2];
      states.tell(function, different[i].before, different[i].after, entry);
    }
  }

  const Version& before_;
  const Version& after_;
  const Renames& renames_;
  const ParameterValues& values_;
  JointProgram joint_;
};

}  // namespace

std::vector<OutputChange> output_changes(const Version& before, const Version& after,
                                         const Renames& renames) {
  return output_changes_at(before, after, renames, {});
}

std::vector<OutputChange> output_changes_at(const Version& before, const Version& after,
                                            const Renames& renames, const ParameterValues& values) {
  return OutputComparison(before, after, renames, values)();
}

}  // namespace elgen
