// The state of an [[expect]]: its keys `at` and `within`.
//
//     at = { theta = 0.1, "dot(theta)" = 2, m = 0.3 }   ->   coordinate 0: 1/10, velocity 0: 2, …
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "base/reason.hpp"
#include "check/expressions/values.hpp"
#include "check/judge/judge.hpp"
#include "elgen/leaf_names.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

/// Every leaf that a function may take, with its name in models and without a value.
std::vector<std::pair<std::string, LeafAssignment>> stated_leaves(const Model& model) {
  LeafNames names = leaf_names(model);
  name_optional_leaves(Opcode::momentum, names);
  std::vector<std::pair<std::string, LeafAssignment>> leaves;
  for_each_leaf(
      [&](Opcode kind, std::uint32_t number, const std::string& name) {
        if (name.empty() || leaf_row(kind).argument_rule == ArgumentRule::never) return;
        leaves.push_back({leaf_text(names, kind, number), {kind, number}});
      },
      names);
  return leaves;
}

/// Reads NAME = value. E201 for an unknown name, E319 for a value that is not constant.
std::vector<LeafAssignment> read_leaves(Context& context, const Model& described,
                                        const std::vector<KeySyntax>& keys) {
  using Named = std::pair<std::string, LeafAssignment>;
  const std::vector<Named> known = stated_leaves(described);
  std::vector<LeafAssignment> leaves;
  for (const KeySyntax& key : keys) {
    const std::string name = component_name(described, key.key);
    const auto found = std::ranges::find(known, name, &Named::first);
    if (found == known.end()) {
      context.report.add(Reason::unknown_state_name, key.key_span,
                         "unknown name " + quote_text(key.key),
                         suggestion(key.key, column_words(known, &Named::first)));
      continue;
    }
    LeafAssignment leaf = found->second;
    const std::optional<cln::cl_R> value = ValueReader(context).read_constant(key.value);
    if (leaf.kind == Opcode::coordinate) {
      note_degrees(context.report, key.value.span, described.coordinates[leaf.number], value);
    }
    leaf.value = value.value_or(leaf.value);
    leaves.push_back(leaf);
  }
  return leaves;
}

/// True if a key of an [[expect]] names an output.
bool is_output_key(const KeySyntax& key) {
  constexpr std::array<std::string_view, 4> others{"at", "within", "conserved", "equations"};
  return std::ranges::find(others, key.key) == others.end();
}

}  // namespace

std::optional<ExpectationState> read_expected_state(Context& context, const Model& described,
                                                    const EntrySyntax& entry) {
  const KeySyntax* const at = entry.find("at");
  const KeySyntax* const within = entry.find("within");
  if (at == nullptr) {
    if (within == nullptr) return std::nullopt;
    context.report.add(Reason::within_without_state, within->key_span, "`within` without `at`",
                       "closed forms are exact; numbers are given `at` a state");
    return std::nullopt;
  }
  if (std::ranges::none_of(entry.keys, is_output_key)) {
    context.report.add(Reason::state_without_output, at->key_span,
                       "no output is given at this state",
                       "`conserved` and `equations` hold at all states");
  }
  // The default tolerance 1e-12 fits tables of doubles.
  ExpectationState state{read_leaves(context, described, at->value.entries), power_of_ten(-12)};
  if (within == nullptr) return state;
  state.tolerance = ValueReader(context).read_constant(within->value).value_or(state.tolerance);
  if (!cln::plusp(state.tolerance)) {
    context.report.add(Reason::bad_tolerance, within->value.span,
                       in_backticks(within->value.span) + " is not positive");
  }
  return state;
}

}  // namespace elgen
