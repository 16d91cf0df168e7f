// Values at the state that options state: its leaves one kind after another, then the outputs.
#include <optional>
#include <utility>

#include "elgen/leaf_names.hpp"
#include "elgen/simulate.hpp"
#include "elgen/wording.hpp"
#include "run/values/records.hpp"

namespace elgen {
namespace {

using cln::cl_R;

Diagnostic no_value(std::string_view name, const Span& span) {
  return {Code::E521, span, in_backticks(name) + " has no value at this state"};
}

/// Takes over what `--state` says of kinds that a start does not have.
void place_stated(const Model& model, State& state) {
  constexpr LeafSet kinds = Opcode::acceleration | Opcode::momentum | Opcode::time | Opcode::step;
  const auto place = [&](Opcode kind, std::uint32_t number, cl_R& value) {
    if (!kinds.has_any(kind)) return;
    const auto found = model.stated.find(leaf_text(model, kind, number));
    if (found != model.stated.end()) value = found->second;
  };
  for_each_leaf(place, state);
}

/// The state of a model whose start is where it has to be.
Result<State> stated_state(const CheckedModel& checked, bool takes_momenta) {
  const Model& model = checked.model;
  State state = start_state(model, checked.scene);
  if (!model.rotations.empty()) {
    OracleValues q = oracle_values(model, {.kind = OutputKind::normalized}, state);
    if (q) state.q = std::move(*q);
  }
  place_stated(model, state);
  if (takes_momenta) {
    set_momenta(model, state);
    place_stated(model, state);
  }
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const Input& input = model.inputs[i];
    if (!input.law) continue;
    const std::optional<cl_R> value = oracle_expression(model, *input.law, state);
    if (!value) return no_value(input.name, model.expressions[*input.law].span);
    state.u[i] = *value;
  }
  return state;
}

}  // namespace

Result<ValueTable> state_values(const CheckedModel& checked, const StateOptions& options) {
  ValueTable table = table_of(checked, options.digits);
  State at_time = start_state(checked.model, checked.scene);
  place_stated(checked.model, at_time);
  const Result<CheckedModel> from =
      options.projects ? assembled_model(checked, at_time.t) : checked;
  if (!from) return from.diagnostics;
  const Result<State> state = stated_state(*from, takes(table, Opcode::momentum));
  if (!state) return state.diagnostics;
  Diagnostics errors;
  for (std::size_t i = 0; i < table.functions.size(); ++i) {
    std::optional<ValueRecord> record = record_at(table, i, "state", *state);
    const OutputRequest& output = table.functions[i].output;
    if (record) table.records.push_back(std::move(*record));
    if (!record) errors.push_back(no_value(output.name, output.span));
  }
  return {std::move(table), std::move(errors)};
}

}  // namespace elgen
