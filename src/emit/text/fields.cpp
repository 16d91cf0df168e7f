// fields: small questions, answered by the output table.
#include "emit/text/fields.hpp"

#include <utility>

namespace elgen {
namespace {

Field transposed(const Field& field) {
  Field result{field.name, field.columns, field.rows, {}};
  for (std::uint32_t column = 0; column < field.columns; ++column) {
    for (std::uint32_t row = 0; row < field.rows; ++row) {
      result.entries.push_back(field.entries[row * field.columns + column]);
    }
  }
  return result;
}

}  // namespace

bool gives_struct(const Function& function) {
  return function.fields.size() != 1 || !function.fields.front().name.empty();
}

OutputKind kind_of_field(const Program& program, const Function& function, const Field& field) {
  if (!output_row(function.kind).repeats) return function.kind;
  for (const Function& candidate : program.functions) {
    if (candidate.name == field.name) return candidate.kind;
  }
  const OutputRow* row = find_output(field.name);
  return row != nullptr ? row->kind : function.kind;
}

bool is_scalar(OutputKind kind, const Field& field) {
  const FieldRow& row = field_row(kind, field.name);
  const bool may_be =
      row.columns == Extent::one && (row.rows == Extent::one || row.rows == Extent::user);
  return may_be && field.rows == 1 && field.columns == 1;
}

std::vector<bool> scalar_fields(const Program& program, const Function& function) {
  std::vector<bool> result;
  for (const Field& field : function.fields) {
    result.push_back(is_scalar(kind_of_field(program, function, field), field));
  }
  return result;
}

Function stored(const Function& function, Storage storage) {
  Function result = function;
  if (storage == Storage::row_major) return result;
  for (Field& field : result.fields) {
    if (field.rows > 1 && field.columns > 1) field = transposed(field);
  }
  return result;
}

bool is_returned(const Function& function) { return entry_count(function) <= largest_returned; }

}  // namespace elgen
