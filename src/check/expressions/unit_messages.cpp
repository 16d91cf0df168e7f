// Hints and notes about units.
#include <algorithm>
#include <vector>

#include "check/expressions/units.hpp"
#include "elgen/wording.hpp"

namespace elgen {

namespace {

/// The expression and its subexpressions, in the order of the file. Names are not expanded, and
/// arguments of open functions are skipped.
std::vector<ExpressionId> subexpressions(const Model& model, ExpressionId expression) {
  std::vector<ExpressionId> parts{expression};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Expression& part = model.expressions[parts[i]];
    if (part.kind == ExpressionKind::leaf) continue;
    parts.insert(parts.end(), part.operands.begin(), part.operands.end());
  }
  std::ranges::stable_sort(parts, [&](ExpressionId a, ExpressionId b) {
    return model.expressions[a].span.begin < model.expressions[b].span.begin;
  });
  return parts;
}

/// `unit` is the declared text: rad, not 1.
UnitDeclaration declaration_with_unit(const std::string& name, const std::string& unit,
                                      const Span& span) {
  return {span, quote_text(name) + " is declared here, in " + unit};
}

std::optional<UnitDeclaration> parameter_declaration(const Model& model, const Expression& node) {
  if (!is_leaf(node, Opcode::parameter)) return std::nullopt;
  const Parameter& parameter = model.parameters[node.index];
  const ParameterArray& array = model.parameter_arrays[parameter.array];
  return parameter.unit
             ? std::optional(declaration_with_unit(array.name, array.unit_text, array.span))
             : std::nullopt;
}

std::optional<UnitDeclaration> variable_declaration(const Model& model, const Expression& node) {
  const auto of = [](const auto& row) {
    return row.unit_text.empty()
               ? std::nullopt
               : std::optional(declaration_with_unit(row.name, row.unit_text, row.span));
  };
  if (node.kind != ExpressionKind::leaf) return std::nullopt;
  switch (leaf_row(node.leaf).owner) {
    case LeafOwner::coordinates:
      return of(model.coordinates[node.index]);
    case LeafOwner::velocities:
      return of(model.coordinates[model.velocities[node.index].coordinate]);
    case LeafOwner::inputs:
      return of(model.inputs[node.index]);
    case LeafOwner::open_values:
      return of(model.functions[model.open_values[node.index].function]);
    case LeafOwner::parameters:
    case LeafOwner::constraints:
    case LeafOwner::system:
      break;
  }
  return std::nullopt;
}

}  // namespace

std::string role_unit_text(const ExpressionRole& place, const Unit& unit) {
  return place.is_force ? force_unit_text(unit) : to_string(unit);
}

std::string unnamed_number_hint(const Model& model, ExpressionId expression) {
  for (const ExpressionId id : subexpressions(model, expression)) {
    const Expression& node = model.expressions[id];
    if (node.kind != ExpressionKind::number || cln::zerop(node.number)) continue;
    return in_backticks(node.span) +
           " has no unit in an expression: give it a name and a unit in `[parameters]`";
  }
  return "";
}

std::optional<UnitDeclaration> unit_declaration(const Model& model, ExpressionId expression) {
  const std::vector<ExpressionId> parts = subexpressions(model, expression);
  for (const auto of : {parameter_declaration, variable_declaration}) {
    for (const ExpressionId id : parts) {
      if (auto found = of(model, model.expressions[id])) return found;
    }
  }
  return std::nullopt;
}

void report_plain_numbers(Context& context) {
  const Model& model = context.model;
  const WrittenExpression* first = nullptr;
  std::size_t count = 0;
  for (const WrittenExpression& root : context.roots) {
    const Expression& value = model.expressions[root.value];
    const bool is_zero = value.kind == ExpressionKind::number && cln::zerop(value.number);
    const bool is_of_model = value.span.source == model.source.get();
    if (!root.is_in_role_unit || root.unit.value_or(Unit{}) == Unit{}) continue;
    if (is_zero || !is_of_model) continue;
    ++count;
    if (first == nullptr || value.span.begin < model.expressions[first->value].span.begin) {
      first = &root;
    }
  }
  if (first == nullptr) return;
  const Span& span = model.expressions[first->value].span;
  std::string others;
  if (count > 1) others = "; the same holds for " + count_text(count - 1, "other value");
  context.report.add(Code::E405, span,
                     in_backticks(span) + " contains no name, so it is in " +
                         role_unit_text(first->role, *first->unit) + ", the SI unit of its key" +
                         others);
}

void report_missing_units(Context& context) {
  const Model& model = context.model;
  std::vector<std::string> names;
  std::optional<Span> first;
  const auto note = [&](const std::string& name, const Span& span) {
    names.push_back(name);
    if (!first || span.begin < first->begin) first = span;
  };
  const auto note_rows = [&](const auto& rows) {
    for (const auto& row : rows) {
      if (!row.unit && row.unit_text.empty()) note(row.name, row.span);
    }
  };
  note_rows(model.coordinates);
  const std::size_t others = names.size();
  for (const ParameterArray& array : model.parameter_arrays) {
    const Parameter& parameter = model.parameters[array.first];
    const bool is_silent = !parameter.unit && array.unit_text.empty();
    const bool is_momentum =
        std::ranges::count(model.reduction.cyclic, array.first, &CyclicCoordinate::parameter) > 0;
    if (is_silent && !is_momentum) note(array.name, array.span);
  }
  const std::size_t parameters = names.size() - others;
  note_rows(model.inputs);
  note_rows(model.functions);
  if (names.empty()) return;
  std::string list;
  for (std::size_t i = 0; i < std::min<std::size_t>(names.size(), 8); ++i) {
    list += (i == 0 ? "" : ", ") + quote_text(names[i]);
  }
  list += names.size() > 8 ? " and others" : "";
  context.report.add(Code::E520, *first, list + ": no unit, so expressions with it are not checked",
                     names.size() == parameters ? "a pure number has `unit = \"1\"`" : "");
}

}  // namespace elgen
