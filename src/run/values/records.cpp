// Makes tables of values: the fields of each output from the output table, and the oracle's values
// with correct digits only.
#include "run/values/records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "elgen/wording.hpp"
#include "emit/interface/code_interface.hpp"
#include "model/output_units.hpp"
#include "model/requests.hpp"

namespace elgen {
namespace {

std::vector<std::string> labels_of(const Model& model, Extent extent, std::uint32_t user) {
  std::vector<std::string> labels;
  for (const FieldLine& line : extent_lines(model, extent, user)) labels.push_back(line.text());
  return labels;
}

ValueField make_value_field(const Model& model, const OutputRequest& output, const FieldRow& row) {
  ValueField field{std::string(row.name), labels_of(model, row.rows, output.user),
                   labels_of(model, row.columns, output.user)};
  for (std::size_t r = 0; r < field.rows.size(); ++r) {
    for (std::size_t c = 0; c < field.columns.size(); ++c) {
      field.units.push_back(unit_text_of_entry(model, {output.kind, row.name, r, c}));
    }
  }
  return field;
}

ValueFunction make_value_function(const Model& model, const OutputRequest& output) {
  ValueFunction function{output,
                         arguments_of(model, Function{.kind = output.kind, .user = output.user})};
  // Emitted functions have an argument u even if the model has no inputs.
  std::erase_if(function.takes,
                [&](Opcode kind) { return kind != Opcode::input && leaf_count(model, kind) == 0; });
  for (const FieldRow& row : output_row(output.kind).fields) {
    const bool is_left_out = row.rows == Extent::pivots && output.omits_pivots;
    if (!is_left_out && has_field(output, row))
      function.fields.push_back(make_value_field(model, output, row));
  }
  std::erase_if(function.fields, [](const ValueField& field) { return field.units.empty(); });
  return function;
}

}  // namespace

ValueTable make_value_table(const CheckedModel& checked, int digits) {
  ValueTable table{checked.model, checked.scene.base_name, digits};
  for (const OutputRequest& output : checked.scene.outputs) {
    if (output_row(output.kind).is_summary) continue;
    table.functions.push_back(make_value_function(checked.model, output));
  }
  return table;
}

Diagnostic no_value_error(std::string_view name, const Span& span, const StableValues& settled) {
  const std::string text = settled.is_decided
                               ? "has no value at this state"
                               : fmt::format(
                                     "is undecided at this state: {} digits do not distinguish its "
                                     "values from 0, or a number in them is too large",
                                     max_stable_digits);
  return {Code::E521, span, quote_text(name) + " " + text};
}

Result<ValueRecord> make_value_record(const ValueTable& table, std::size_t function,
                                      std::string place, const State& state) {
  const OutputRequest& output = table.functions[function].output;
  StableValues settled = stable_values(table.model, output, state);
  OracleValues& values = settled.values;
  if (!values) return no_value_error(output.name, output.span, settled);
  if (output.omits_pivots) {
    const auto pivots = values->begin() + extent_size(table.model, Extent::velocities);
    values->erase(pivots, pivots + extent_size(table.model, Extent::pivots));
  }
  return ValueRecord{function, std::move(place), state, std::move(*values)};
}

}  // namespace elgen
