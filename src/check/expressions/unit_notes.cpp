// What is noted of units where nothing is wrong with them.
#include "check/expressions/unit_notes.hpp"

#include <algorithm>

namespace elgen {

void note_plain_numbers(Context& context) {
  const Model& model = context.model;
  const WrittenExpression* first = nullptr;
  std::size_t count = 0;
  for (const WrittenExpression& root : context.roots) {
    const Expression& value = model.expressions[root.value];
    const bool is_zero = value.kind == ExpressionKind::number && cln::zerop(value.number);
    const bool is_of_model = value.span.source == model.source.get();
    if (!root.plain_numbers || root.unit.value_or(Unit{}) == Unit{}) continue;
    if (is_zero || !is_of_model) continue;
    ++count;
    if (first == nullptr || value.span.begin < model.expressions[first->value].span.begin) {
      first = &root;
    }
  }
  if (first == nullptr) return;
  const Span& span = model.expressions[first->value].span;
  std::string others;
  if (count > 1) others = "; the same goes for " + counted(count - 1, "other value");
  context.report.add(Code::E405, span,
                     in_backticks(span) + " names nothing, so it is in " + to_string(*first->unit) +
                         ", the SI unit of its key" + others);
}

void note_missing_units(Context& context) {
  const Model& model = context.model;
  std::vector<std::string> names;
  std::optional<Span> first;
  const auto note = [&](const std::string& name, const Span& span) {
    names.push_back(name);
    if (!first || span.begin < first->begin) {
      first = span;
    }
  };
  for (const Coordinate& coordinate : model.coordinates) {
    if (!coordinate.unit && coordinate.unit_text.empty()) note(coordinate.name, coordinate.span);
  }
  for (const ParameterArray& array : model.parameter_arrays) {
    if (!model.parameters[array.first].unit && array.unit_text.empty())
      note(array.name, array.span);
  }
  for (const Input& input : model.inputs) {
    if (!input.unit && input.unit_text.empty()) note(input.name, input.span);
  }
  if (names.empty()) {
    return;
  }
  std::string list;
  for (std::size_t i = 0; i < std::min<std::size_t>(names.size(), 8); ++i) {
    list += (i == 0 ? "" : ", ") + in_backticks(names[i]);
  }
  list += names.size() > 8 ? " and others" : "";
  context.report.add(Code::E520, *first, list + ": no unit, so what touches it is not checked");
}

}  // namespace elgen
