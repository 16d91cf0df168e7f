// Points of rest: finds the variables that a key names, and reads the value in their unit. An
// [[equilibrium]] may also have a condition and the squared frequencies of small oscillations.
#include "check/entries/stated_point.hpp"

#include <string_view>
#include <utility>

#include "base/reason.hpp"
#include "check/entries/entries.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"

namespace elgen {
namespace {

/// True if `name` denotes the variable `full_name`: both "q" and "q[2]" denote q[2].
bool denotes_variable(const std::string& full_name, std::string_view name) {
  return full_name == name || full_name.substr(0, full_name.find('[')) == name;
}

template <class Entries>
std::vector<std::uint32_t> find_indices_by_name(const Entries& entries, std::string_view name) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    bool is_denoted = denotes_variable(entries[i].name, name);
    if constexpr (requires { entries[i].indexed_name; })
      is_denoted = is_denoted || denotes_variable(entries[i].indexed_name, name);
    if (is_denoted) found.push_back(i);
  }
  return found;
}

bool names_rotation(const Context& context, const std::string& name) {
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
    nouns += (nouns.empty() ? "" : " or ") + std::string(symbol_noun(kind));
  }
  context.report.add(table.error_code, span, quote_text(name) + " is no " + nouns,
                     context.symbols.suggest(name, context.symbols.names(kinds)));
}

constexpr PointTable coordinate_table{
    {"a value of `at`", place::parameters_only}, true, false, Code::E612};
constexpr PointTable input_table{
    {"a value of `inputs`", place::parameters_only}, false, true, Reason::unknown_input};
constexpr ExpressionRole condition_place{"a condition", place::parameters_only};
constexpr ExpressionRole frequency_place{"a squared frequency", place::parameters_only};

/// Reads { left, sign, right } of the parser; the condition is `excess` > 0 or >= 0.
Condition read_condition(ValueReader& values, const ValueSyntax& value) {
  const ExpressionSyntax& left = value.find("left")->value.expression;
  const ExpressionSyntax& right = value.find("right")->value.expression;
  const std::string& sign = value.find("sign")->value.text;
  const bool is_left_larger = sign.front() == '>';
  Condition condition;
  condition.excess = values.read_root(is_left_larger ? difference_syntax(left, right, value.span)
                                                     : difference_syntax(right, left, value.span),
                                      {condition_place});
  condition.is_strict = sign.size() == 1;
  condition.text = collapse_blanks(value.text);
  return condition;
}

void read_frequencies(ValueReader& values, const ValueSyntax& list, Equilibrium& equilibrium) {
  Context& context = values.context();
  const Unit unit = power(*find_unit("s"), {-2, 1});
  equilibrium.frequencies_squared = values.read_roots(list, {frequency_place, unit});
  const std::size_t count = context.model.velocities.size();
  if (list.items.size() == count) return;
  context.report.add(Code::E517, list.span,
                     count_text(list.items.size(), "value") + ", but the model has " +
                         std::to_string(count) + (count == 1 ? " velocity" : " velocities"));
}

}  // namespace

NamedVariables find_variables(Context& context, const PointTable& table, const std::string& name,
                              const Span& span) {
  if (names_rotation(context, name)) {
    context.report.add(table.error_code, span,
                       quote_text(name) + " belongs to a rotation, which has no value here",
                       "omit it: the rotation keeps its orientation");
    return {};
  }
  NamedVariables found;
  if (table.takes_coordinates)
    found.coordinates = find_indices_by_name(context.model.coordinates, name);
  if (table.takes_inputs) found.inputs = find_indices_by_name(context.model.inputs, name);
  if (found.empty()) report_unknown_variable(context, table, name, span);
  return found;
}

NamedVariables read_point_value(ValueReader& values, const PointTable& table, const KeySyntax& key,
                                OperatingPoint& point) {
  Context& context = values.context();
  const NamedVariables found = find_variables(context, table, key.key, key.key_span);
  if (found.empty()) return found;
  const Model& model = context.model;
  const RootRequest request{table.role, found.coordinates.empty()
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

void read_equilibrium(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  Model& model = values.context().model;
  Equilibrium& equilibrium = model.equilibria[target];
  equilibrium.coordinates.resize(model.coordinates.size());
  equilibrium.inputs.resize(model.inputs.size());
  const auto read_point_table = [&](std::string_view name, const PointTable& table) {
    const KeySyntax* given = entry.find(name);
    if (given == nullptr) return;
    for (const KeySyntax& key : given->value.entries) {
      read_point_value(values, table, key, equilibrium);
    }
  };
  read_point_table("at", coordinate_table);
  read_point_table("inputs", input_table);
  if (const KeySyntax* when = entry.find("when")) {
    equilibrium.condition = read_condition(values, when->value);
  }
  if (const KeySyntax* squares = entry.find("frequencies_squared")) {
    read_frequencies(values, squares->value, equilibrium);
  }
}

}  // namespace elgen
