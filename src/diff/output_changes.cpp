// output_changes: joins both versions of each output, and examines the entries that are computed
// differently. Closed forms, and a state at which the values differ, explain a difference.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "choose/finish.hpp"
#include "diff/joint_program.hpp"
#include "diff/renamed.hpp"
#include "diff/zeros.hpp"
#include "elgen/choose.hpp"
#include "elgen/diff.hpp"
#include "elgen/page.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"
#include "program/network/instructions.hpp"
#include "sample/states.hpp"

namespace elgen {
namespace {

const Function* find_function_named(const Program& program, const std::string& name) {
  const auto found = std::ranges::find(program.functions, name, &Function::name);
  return found == program.functions.end() ? nullptr : &*found;
}

/// Closed forms of more characters are not printed.
constexpr std::size_t longest_read = 100;

/// A form beyond this budget would not fit into a line.
constexpr ClosedFormBudget texts_budget{
    .products_per_function = 2'000, .products = 60'000, .terms = 300};
/// A form of more instructions would not fit into a line.
constexpr std::size_t most_instructions = 400;

/// A function whose only entry is instruction `at`; empty if longer than `most_instructions`.
Function single_entry(const Function& function, std::uint32_t at) {
  Function one = with_entries(function, {at});
  if (one.instructions.size() <= most_instructions) return one;
  return {.kind = function.kind, .name = function.name};
}

/// The closed form of each of `instructions`, as pages show it; "" if the form is too long or
/// exceeds the budget. Each instruction becomes a separate function with a small budget, so that
/// one failure does not affect the others.
std::vector<std::string> closed_form_texts(const Program& program, const Function& function,
                                           const std::vector<std::uint32_t>& instructions) {
  Program each{program.leaves, program.constants, {}};
  for (const std::uint32_t at : instructions) {
    each.functions.push_back(single_entry(function, at));
  }
  const Program read = with_closed_forms(std::move(each), Audience::people, texts_budget);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < read.functions.size(); ++i) {
    const bool is_known = !read.readable[i].fields.empty();
    std::string text = is_known ? text_of(equations(read, i).entries[0][0]) : "";
    texts.push_back(text.size() <= longest_read ? std::move(text) : "");
  }
  return texts;
}

/// Number of states from which a witness is selected. decide_zeros() evaluates all states, to
/// find differences at roots and kinks.
constexpr std::size_t witness_count = 16;
constexpr std::size_t state_count = zero_sample_count;
constexpr std::uint64_t seed_of_witnesses = 16;

/// x as it is printed, with three significant digits.
double round_to_text(double x) { return std::stod(fmt::format("{:.3g}", x)); }

/// Appends the leaves that only the older version has, in the order of `joint`, with their values
/// in `values`.
void append_old_leaves(const LeafNames& joint, const LeafNames& olds,
                       const Arguments<double>& values, Arguments<double>& state) {
#define ELGEN_LEAVES(kind, member, ...)                                                     \
  while (state.member.size() < joint.member.size()) {                                       \
    const auto old = std::ranges::find(olds.member, joint.member[state.member.size()]);     \
    const bool is_known = old != olds.member.end();                                         \
    state.member.push_back(                                                                 \
        is_known ? values.member[static_cast<std::size_t>(old - olds.member.begin())] : 1); \
  }
#define ELGEN_LEAF(kind, member, ...)
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
}

/// The instructions of two matching entries, and of their difference.
struct InstructionPair {
  std::size_t number = 0;  ///< index in OutputChange::entries
  std::uint32_t before = 0;
  std::uint32_t after = 0;
  std::uint32_t difference = 0;
};

/// States over the leaves of both versions, inside the ranges of the newer version. A parameter has
/// its value, or a random value if its value is 0. Leaves that only the older version has are drawn
/// in the ranges of the older version. In the last state all leaves except parameters are 0,
/// because many functions have kinks at 0.
class WitnessStates {
 public:
  WitnessStates(const Version& before, const Version& after, const Program& joint);

  [[nodiscard]] const std::vector<Arguments<double>>& states() const { return states_; }

  /// Sets `relative_change` and the witness of `change`, at the state with the largest difference.
  /// Sets nothing if no state shows a difference.
  void set_witness(const Function& function, const InstructionPair& pair,
                   EntryChange& change) const;

 private:
  const Program& joint_;
  std::vector<Arguments<double>> states_ = {};
  LeafValues<double> known_ = {};  ///< nominal values of parameters, which a witness omits
};

WitnessStates::WitnessStates(const Version& before, const Version& after, const Program& joint)
    : joint_(joint) {
  const SystemUnderTest olds{before.checked.model, before.checked.scene, before.program};
  const SystemUnderTest news{after.checked.model, after.checked.scene, after.program};
  const LeafValues<Range> old_ranges = ranges_of(olds);
  const LeafValues<Range> new_ranges = ranges_of(news);
  Sampler draw(seed_of_witnesses);
  for (std::size_t i = 0; i < state_count; ++i) {
    const Arguments<double> old = draw_in_ranges(olds, old_ranges, draw);
    Arguments<double> state = draw_in_ranges(news, new_ranges, draw);
    if (i == 0) known_ = state;
    for (std::size_t k = 0; k < state.parameters.size(); ++k) {
      double& value = state.parameters[k];
      if (value != 0) continue;
      const Range range = new_ranges.parameters[k];
      value = range.low < range.high ? draw.uniform(range) : draw.random_fraction();
    }
    append_old_leaves(joint.leaves, before.program.leaves, old, state);
    if (i == 0) append_old_leaves(joint.leaves, before.program.leaves, old, known_);
    states_.push_back(map_leaves(round_to_text, state));
  }
  const auto rest = [](Opcode kind, std::uint32_t, double& value) {
    if (kind != Opcode::parameter) value = 0;
  };
  for_each_leaf(rest, states_.emplace_back(states_.front()));
}

void WitnessStates::set_witness(const Function& function, const InstructionPair& pair,
                                EntryChange& change) const {
  const Function both = with_entries(function, {pair.before, pair.after});
  double largest = 0;
  double largest_change = 0;
  const Arguments<double>* best = nullptr;
  std::vector<double> values_there;
  for (const Arguments<double>& state : std::span(states_).first(witness_count)) {
    const std::vector<double> values = evaluate(joint_, both, state);
    const double difference = std::abs(values[1] - values[0]);
    if (!std::isfinite(difference)) continue;
    largest = std::max({largest, std::abs(values[0]), std::abs(values[1])});
    if (difference <= largest_change && best != nullptr) continue;
    largest_change = difference;
    best = &state;
    values_there = values;
  }
  // Two doubles may differ by rounding alone, so the difference is checked in 64 digits.
  const Function difference = with_entries(function, {pair.difference});
  if (largest_change == 0 || vanishes_at(joint_, difference, *best)) return;
  change.witness = Witness{{}, values_there[0], values_there[1]};
  change.relative_change = largest_change / largest;
  std::string& at = change.witness->state_text;
  for (const Instruction& i : both.instructions) {
    if (!is_leaf(i.opcode)) continue;
    const double value = leaf_of(*best, i.opcode, i.a);
    const bool is_at_value =
        i.opcode == Opcode::parameter && value == round_to_text(leaf_of(known_, i.opcode, i.a));
    if (is_at_value) continue;
    at += fmt::format("{}{} = {:.3g}", at.empty() ? "" : ", ",
                      leaf_text(joint_.leaves, i.opcode, i.a), value);
  }
}

/// The parameters that `fixing` fixes but `free` does not, if the fixed number is rational and is
/// the value in `free`. Both renames lead to names of the newer version.
ParameterValues equivalently_fixed_values(const CheckedModel& free, const Renames& free_renames,
                                          const CheckedModel& fixing, const Renames& renames) {
  ParameterValues values;
  for (const auto& [other, fixed] : fixing.scene.specialisation.fixed) {
    const std::string name = apply_renames(fixing.model.parameters[other].name, renames);
    for (std::uint32_t i = 0; i < free.model.parameters.size(); ++i) {
      const Parameter& parameter = free.model.parameters[i];
      const bool is_free = free.scene.specialisation.fixed.count(i) == 0;
      const bool is_it = is_free && apply_renames(parameter.name, free_renames) == name;
      if (!is_it || !is_rational(fixed.number) || fixed.number != parameter.value) continue;
      values.emplace(parameter.name, rational_constant(cln::the<cln::cl_RA>(fixed.number)));
    }
  }
  return values;
}

/// Number of entries per output that get closed forms and a witness; further entries get only a
/// verdict.
constexpr std::size_t max_explained_entries = 20;

class OutputComparison {
 public:
  OutputComparison(const Version& before, const Version& after, const Renames& renames,
                   const ParameterValues& values)
      : before_(before),
        after_(after),
        renames_(renames),
        values_{equivalently_fixed_values(before.checked, renames, after.checked, {}), values},
        joint_(before.program, after.program, renames) {
    values_.after.merge(equivalently_fixed_values(after.checked, {}, before.checked, renames));
  }

  std::vector<OutputChange> operator()() {
    std::vector<OutputChange> all;
    for (const Function& after : after_.program.functions) {
      if (output_row(after.kind).is_summary) continue;
      const Function* const before = find_function_named(before_.program, after.name);
      all.push_back(before != nullptr
                        ? compare_functions(without_diagonal(*before), without_diagonal(after))
                        : one_sided_output(after_, {}, without_diagonal(after)));
    }
    for (const Function& before : before_.program.functions) {
      const bool is_gone = find_function_named(after_.program, before.name) == nullptr;
      if (!is_gone || output_row(before.kind).is_summary) continue;
      all.push_back(one_sided_output(before_, without_diagonal(before), {}));
    }
    return all;
  }

 private:
  /// An entry with the verdict `added` or `removed`; if both versions have it, `different` until it
  /// is shown to be equal.
  static EntryChange initial_change(const MatchedEntry& entry) {
    const EntryVerdict lone = entry.after ? EntryVerdict::added : EntryVerdict::removed;
    const bool is_in_both = entry.before && entry.after;
    return {.place = entry.place,
            .unit = entry.unit,
            .verdict = is_in_both ? EntryVerdict::different : lone};
  }

  /// The changes of an output that only one version has; the other function is empty.
  static OutputChange one_sided_output(const Version& version, const Function& before,
                                       const Function& after) {
    const Model& model = version.checked.model;
    OutputChange change{before.name + after.name, entry_count(before) + entry_count(after), {}};
    for (const MatchedEntry& entry : match_entries(model, before, model, after, {})) {
      change.entries.push_back(initial_change(entry));
    }
    return change;
  }

  OutputChange compare_functions(const Function& before, const Function& after) {
    OutputChange change{after.name, std::max(entry_count(before), entry_count(after)), {}};
    JointFunction joint = joint_.join(before, after, values_);
    InstructionBuilder instructions(joint.function);
    std::vector<InstructionPair> open;
    for (const MatchedEntry& entry :
         match_entries(before_.checked.model, before, after_.checked.model, after, renames_)) {
      if (entry.before && entry.after) {
        const std::uint32_t x = joint.before[*entry.before];
        const std::uint32_t y = joint.after[*entry.after];
        if (x == y) continue;
        open.push_back({change.entries.size(), x, y, instructions.add(Opcode::subtract, y, x)});
      }
      change.entries.push_back(initial_change(entry));
    }
    decide_entries(joint.function, open, change);
    return change;
  }

  void decide_entries(const Function& function, const std::vector<InstructionPair>& open,
                      OutputChange& change) {
    if (open.empty()) return;
    std::vector<std::uint32_t> differences;
    for (const InstructionPair& pair : open) differences.push_back(pair.difference);
    const std::vector<ZeroVerdict> found = decide_zeros(
        joint_.program(), with_entries(function, differences), witness_states().states());
    std::vector<InstructionPair> different;
    std::vector<InstructionPair> undecided;
    for (std::size_t i = 0; i < open.size(); ++i) {
      EntryChange& entry = change.entries[open[i].number];
      if (found[i] == ZeroVerdict::nonzero) {
        different.push_back(open[i]);
        continue;
      }
      const bool is_decided = found[i] != ZeroVerdict::undecided;
      entry.verdict = is_decided ? EntryVerdict::equal : EntryVerdict::undecided;
      entry.is_proved = found[i] == ZeroVerdict::proved;
      entry.is_certain = is_decided;
      if (!is_decided) undecided.push_back(open[i]);
    }
    different.insert(different.end(), undecided.begin(), undecided.end());
    if (different.size() > max_explained_entries) different.resize(max_explained_entries);
    explain_entries(function, different, change);
  }

  void explain_entries(const Function& function, const std::vector<InstructionPair>& different,
                       OutputChange& change) {
    if (different.empty()) return;
    std::vector<std::uint32_t> places;
    for (const InstructionPair& pair : different) {
      places.insert(places.end(), {pair.before, pair.after, pair.difference});
    }
    const std::vector<std::string> texts = closed_form_texts(joint_.program(), function, places);
    for (std::size_t i = 0; i < different.size(); ++i) {
      EntryChange& entry = change.entries[different[i].number];
      entry.before = texts[3 * i];
      entry.after = texts[3 * i + 1];
      entry.difference = texts[3 * i + 2];
      if (entry.verdict == EntryVerdict::different)
        witness_states().set_witness(function, different[i], entry);
    }
  }

  const WitnessStates& witness_states() {
    if (!states_) states_.emplace(before_, after_, joint_.program());
    return *states_;
  }

  const Version& before_;
  const Version& after_;
  const Renames& renames_;
  JointParameterValues values_;
  JointProgram joint_;
  std::optional<WitnessStates> states_ = {};  ///< drawn on first use
};

}  // namespace

std::vector<OutputChange> output_changes(const Version& before, const Version& after,
                                         const Renames& renames, const ParameterValues& values) {
  return OutputComparison(before, after, renames, values)();
}

}  // namespace elgen
