// Records: fields by the output table, and values with digits that are right to the last.
#include "run/values/records.hpp"

#include <cln/float.h>

#include <algorithm>
#include <utility>

#include "emit/interface/code_interface.hpp"
#include "model/output_units.hpp"
#include "model/requests.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/more_digits.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// Floats of a state get zeros behind their digits, more than the oracle computes with.
cl_R lengthened(const cl_R& x) {
  constexpr unsigned all_digits = 260;
  if (is_rational(x)) return x;
  return cln::cl_float(x, cln::float_format(all_digits));
}

/// The oracle's values with 120 digits more than its 95. One that is 1e-20 of what it was with 60
/// more, or was 0 there, is the rounding of terms that cancel: 0 in 155 digits of these.
OracleValues settled_values(const Model& model, const OutputRequest& output, const State& state) {
  static const cl_R share_of_a_zero = power_of_ten(-20);
  const auto with_more = [&](unsigned digits) {
    return with_digits(digits,
                       [&] { return oracle_values(model, output, map_leaves(lengthened, state)); });
  };
  const OracleValues before = with_more(60);
  OracleValues values = with_more(120);
  if (!before || !values) return std::nullopt;
  for (std::size_t i = 0; i < values->size(); ++i) {
    const cl_R largest_zero = cln::abs((*before)[i]) * share_of_a_zero;
    if (cln::abs((*values)[i]) <= largest_zero || cln::zerop((*before)[i])) (*values)[i] = 0;
  }
  return values;
}

std::vector<std::string> labels_of(const Model& model, const FieldLines& lines) {
  const Extent extent = lines.extent;
  const bool is_number = extent == Extent::one || extent == Extent::user || extent == Extent::task;
  if (is_number && lines.count == 1) return {""};
  std::vector<std::string> labels;
  for (const LineLabel& line : line_labels(model, lines)) labels.push_back(line.text());
  return labels;
}

ValueField field_of(const Model& model, const OutputRequest& output, const FieldRow& row) {
  const bool is_alone = output_row(output.kind).fields.size() == 1;
  const auto labels = [&](Extent extent, std::uint32_t alone) {
    const std::uint32_t count = is_alone ? alone : extent_of(model, extent, output.user);
    return labels_of(model, {extent, output.user, count});
  };
  ValueField field{std::string(row.name), labels(row.rows, output.rows),
                   labels(row.columns, output.columns)};
  for (std::size_t r = 0; r < field.rows.size(); ++r) {
    for (std::size_t c = 0; c < field.columns.size(); ++c) {
      field.units.push_back(unit_text_of_entry(model, {output.kind, row.name, r, c}));
    }
  }
  return field;
}

ValueFunction function_of(const Model& model, const OutputRequest& output) {
  ValueFunction function{output,
                         arguments_of(model, Function{.kind = output.kind, .user = output.user})};
  // Emitted functions take u whether the model has inputs or not.
  std::erase_if(function.takes,
                [&](Opcode kind) { return kind != Opcode::input && leaf_count(model, kind) == 0; });
  for (const FieldRow& row : output_row(output.kind).fields) {
    const bool is_explicit_step = output_row(output.kind).steps && output.iterations == 0;
    const bool is_left_out = (row.rows == Extent::pivots && output.without_pivots) ||
                             (row.is_remainder && is_explicit_step);
    if (!is_left_out) function.fields.push_back(field_of(model, output, row));
  }
  std::erase_if(function.fields, [](const ValueField& field) { return field.units.empty(); });
  return function;
}

}  // namespace

ValueTable table_of(const CheckedModel& checked, int digits) {
  ValueTable table{checked.model, checked.scene.base_name, digits};
  for (const OutputRequest& output : checked.scene.outputs) {
    if (output_row(output.kind).repeats) continue;
    table.functions.push_back(function_of(checked.model, output));
  }
  return table;
}

std::optional<ValueRecord> record_at(const ValueTable& table, std::size_t function,
                                     std::string place, const State& state) {
  const OutputRequest& output = table.functions[function].output;
  OracleValues values = settled_values(table.model, output, state);
  if (!values) return std::nullopt;
  if (output.without_pivots) {
    const auto pivots = values->begin() + extent_of(table.model, Extent::velocities);
    values->erase(pivots, pivots + extent_of(table.model, Extent::pivots));
  }
  return ValueRecord{function, std::move(place), state, std::move(*values)};
}

}  // namespace elgen
