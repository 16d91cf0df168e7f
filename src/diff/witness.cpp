// witness: in double, at a few states.
#include "diff/witness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random.hpp"
#include "evaluate/states.hpp"
#include "lower/graph/prune.hpp"

namespace elgen {
namespace {

constexpr std::size_t state_count = 16;
constexpr std::uint64_t seed_of_witnesses = 16;

/// To three significant digits, as it is printed.
double text_value(double x) { return std::stod(fmt::format("{:.3g}", x)); }

/// Leaves of the older version that the newer one has not, in the order in which they follow.
void append(const LeafNames& joint, const LeafNames& olds, const Arguments<double>& values,
            Arguments<double>& state) {
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

}  // namespace

WitnessStates::WitnessStates(const Version& before, const Version& after, const Program& joint)
    : joint_(joint) {
  const Subject olds{before.checked.model, before.checked.scene, before.program};
  const Subject news{after.checked.model, after.checked.scene, after.program};
  const LeafValues<Range> old_ranges = ranges_of(olds);
  const LeafValues<Range> new_ranges = ranges_of(news);
  Random random(seed_of_witnesses);
  for (std::size_t i = 0; i < state_count; ++i) {
    const Arguments<double> old = drawn_within(olds, old_ranges, random);
    Arguments<double> state = drawn_within(news, new_ranges, random);
    if (i == 0) known_ = state;
    for (std::size_t k = 0; k < state.parameters.size(); ++k) {
      double& value = state.parameters[k];
      if (value != 0) continue;
      const Range range = new_ranges.parameters[k];
      value =
          range.low < range.high ? random.uniform(range.low, range.high) : random.uniform(0.5, 1);
    }
    append(joint.leaves, before.program.leaves, old, state);
    if (i == 0) append(joint.leaves, before.program.leaves, old, known_);
    states_.push_back(map_leaves(text_value, state));
  }
}

void WitnessStates::tell(const Function& function, std::uint32_t before, std::uint32_t after,
                         EntryChange& change) const {
  const Function both = with_entries(function, {before, after});
  double largest = 0;
  double largest_change = 0;
  const Arguments<double>* best = nullptr;
  for (const Arguments<double>& state : states_) {
    const std::vector<double> values = evaluate(joint_, both, state);
    const double difference = std::abs(values[1] - values[0]);
    if (!std::isfinite(difference)) continue;
    largest = std::max({largest, std::abs(values[0]), std::abs(values[1])});
    if (difference <= largest_change && best != nullptr) continue;
    largest_change = difference;
    best = &state;
    change.witness = Witness{{}, values[0], values[1]};
  }
  if (best == nullptr || largest == 0) return;
  change.share = largest_change / largest;
  std::string& at = change.witness->at;
  for (const Instruction& i : both.instructions) {
    if (!is_leaf(i.opcode)) continue;
    const double value = leaf_of(*best, i.opcode, i.a);
    const bool is_at_value =
        i.opcode == Opcode::parameter && value == text_value(leaf_of(known_, i.opcode, i.a));
    if (is_at_value) continue;
    at += fmt::format("{}{} = {:.3g}", at.empty() ? "" : ", ",
                      leaf_text(joint_.leaves, i.opcode, i.a), value);
  }
}

}  // namespace elgen
