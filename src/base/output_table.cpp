// output_table: functions that look up the table of outputs.
#include <algorithm>

#include "elgen/outputs.hpp"

namespace elgen {

std::string_view name_of(Form form) { return form == Form::closed ? "closed" : "recursive"; }

bool is_in_dynamics(OutputKind kind, LeafSet takes) {
  const OutputRow& row = output_row(kind);
  const LeafSet repeated =
      std::ranges::find(output_table(), true, &OutputRow::is_summary)->argument_kinds;
  const bool is_function = !row.is_summary && !row.takes_parameters_alone;
  return (repeated | row.argument_kinds | takes) == repeated && is_function &&
         row.fields.size() == 1;
}

const FieldRow& field_row(OutputKind kind, std::string_view name) {
  static constexpr FieldRow number{};
  const std::span<const FieldRow> fields = output_row(kind).fields;
  const auto found = std::ranges::find(fields, name, &FieldRow::name);
  if (found != fields.end()) return *found;
  return fields.empty() ? number : fields.front();
}

const Notation& equation_of(const OutputRow& output, const EquationSetting& setting) {
  if (setting.has_constraints && !output.constrained_equation.text.empty()) {
    return output.constrained_equation;
  }
  const bool has_turning_equation = setting.has_rotations && !output.rotation_equation.text.empty();
  return has_turning_equation ? output.rotation_equation : output.equation;
}

const OutputRow* find_output(std::string_view name) {
  for (const OutputRow& output : output_table()) {
    if (output.name == name && !output.is_user_output) return &output;
  }
  return nullptr;
}

}  // namespace elgen
