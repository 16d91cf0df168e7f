// Computes the values of all outputs at the state of `--state`.
#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "elgen/inspect.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/simulate.hpp"
#include "run/values/records.hpp"
#include "sample/states.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// The leaves in `--state` that are no part of a start, such as t.
std::vector<LeafAssignment> stated_leaves(const CheckedModel& checked, const State& start) {
  const std::map<std::string, cl_R>& stated = checked.scene.state_overrides.others;
  std::vector<LeafAssignment> leaves;
  const auto add = [&](Opcode kind, std::uint32_t number, const cl_R& /*value*/) {
    if (!leaf_row(kind).is_settable) return;
    const auto found = stated.find(leaf_text(checked.model, kind, number));
    if (found != stated.end()) leaves.push_back({kind, number, found->second});
  };
  for_each_leaf(add, start);
  return leaves;
}

/// The start of the model, with the leaves of `--state`, and with inputs by their laws.
Result<State> stated_state(const CheckedModel& checked, const std::vector<LeafAssignment>& leaves) {
  const Model& model = checked.model;
  State state = with_leaves(model, start_state(model, checked.scene), leaves);
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const Input& input = model.inputs[i];
    const ExpressionId* const law = find_law(checked.scene, input);
    if (law == nullptr) continue;
    const StableValues value = stable_expression_value(model, *law, state);
    if (!value.values) return no_value_error(input.name, model.expressions[*law].span, value);
    state.u[i] = value.values->front();
  }
  return state;
}

}  // namespace

Result<ValueTable> state_values(const CheckedModel& checked, const StateOptions& options) {
  ValueTable table = make_value_table(checked, options.digits);
  const State start = start_state(checked.model, checked.scene);
  const std::vector<LeafAssignment> leaves = stated_leaves(checked, start);
  const auto time = std::ranges::find(leaves, Opcode::time, &LeafAssignment::kind);
  const cl_R& t = time == leaves.end() ? start.t : time->value;
  const Result<CheckedModel> from = options.projects ? assemble_start(checked, t) : checked;
  if (!from) return from.diagnostics;
  const Result<State> state = stated_state(*from, leaves);
  if (!state) return state.diagnostics;
  Diagnostics errors;
  for (std::size_t i = 0; i < table.functions.size(); ++i) {
    Result<ValueRecord> record = make_value_record(table, i, "state", *state);
    if (record) table.records.push_back(std::move(*record));
    std::ranges::move(record.diagnostics, std::back_inserter(errors));
  }
  if (!errors.empty()) errors.front().hint = quotient_hint(checked.model, *state);
  return {std::move(table), std::move(errors)};
}

}  // namespace elgen
