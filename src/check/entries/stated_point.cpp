// Points of rest: the variables that a key names, and its value in their unit.
#include "check/entries/stated_point.hpp"

#include <string_view>

namespace elgen {
namespace {

/// "q" and "q[2]" both name q[2].
bool is_named(const std::string& full_name, std::string_view name) {
  return full_name == name || full_name.substr(0, full_name.find('[')) == name;
}

template <class Entries>
std::vector<std::uint32_t> entries_named(const Entries& entries, std::string_view name) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    if (is_named(entries[i].name, name)) found.push_back(i);
  }
  return found;
}

bool is_of_rotation(const Context& context, const std::string& name) {
  const DeclaredName* symbol = context.symbols.find(name.substr(0, name.find('[')));
  return symbol != nullptr &&
         (symbol->kind == SymbolKind::rotation || symbol->kind == SymbolKind::quaternion_component);
}

void report_unknown_variable(Context& context, const PointTable& table, const std::string& name,
                             const Span& span) {
  std::vector<SymbolKind> kinds;
  if (table.takes_coordinates) kinds.push_back(SymbolKind::coordinate);
  if (table.takes_inputs) kinds.push_back(SymbolKind::input);
  std::string nouns;
  for (const SymbolKind kind : kinds) {
    nouns += (nouns.empty() ? "" : " or ") + std::string(noun(kind));
  }
  context.report.add(table.otherwise, span, in_backticks(name) + " is no " + nouns,
                     context.symbols.suggest(name, context.symbols.names(kinds)));
}

}  // namespace

Variables find_variables(Context& context, const PointTable& table, const std::string& name,
                         const Span& span) {
  if (is_of_rotation(context, name)) {
    context.report.add(table.otherwise, span,
                       in_backticks(name) + " is of a rotation, which has no value here",
                       "leave it out: it stays as it is");
    return {};
  }
  Variables found;
  if (table.takes_coordinates) found.coordinates = entries_named(context.model.coordinates, name);
  if (table.takes_inputs) found.inputs = entries_named(context.model.inputs, name);
  if (found.empty()) report_unknown_variable(context, table, name, span);
  return found;
}

Variables read_point_value(ValueReader& values, const PointTable& table, const KeySyntax& key,
                           StatedPoint& point) {
  Context& context = values.context();
  const Variables found = find_variables(context, table, key.key, key.key_span);
  if (found.empty()) return found;
  const Model& model = context.model;
  const RootRequest request{table.place, found.coordinates.empty()
                                             ? model.inputs[found.inputs.front()].unit
                                             : model.coordinates[found.coordinates.front()].unit};
  const ExpressionId value = values.root(key.value, request);
  for (const std::uint32_t i : found.coordinates) {
    point.coordinates[i] = value;
    note_degrees(context.report, key.value.span, model.coordinates[i], context.constants[value]);
  }
  for (const std::uint32_t i : found.inputs) point.inputs[i] = value;
  return found;
}

}  // namespace elgen
