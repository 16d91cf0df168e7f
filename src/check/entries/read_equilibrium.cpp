// Equilibria: where they are, on which condition, and the squared frequencies of small motions.
#include <string_view>
#include <utility>

#include "check/entries/entries.hpp"
#include "check/entries/stated_point.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"

namespace elgen {
namespace {

constexpr PointTable coordinates_there{
    {"a value of `at`", place::parameters_only}, true, false, Code::E612};
constexpr PointTable inputs_there{
    {"a value of `inputs`", place::parameters_only}, false, true, Code::E201};
constexpr Place condition_place{"a condition", place::parameters_only};
constexpr Place frequency_place{"a squared frequency", place::parameters_only};

/// { left, sign, right } as the parser gives it.
Condition read_condition(ValueReader& values, const ValueSyntax& value) {
  const ExpressionSyntax& left = value.find("left")->value.expression;
  const ExpressionSyntax& right = value.find("right")->value.expression;
  const std::string& sign = value.find("sign")->value.text;
  const bool is_left_larger = sign.front() == '>';
  Condition condition;
  condition.excess = values.root(
      is_left_larger ? difference(left, right, value.span) : difference(right, left, value.span),
      {condition_place});
  condition.is_strict = sign.size() == 1;
  condition.text = one_line(value.text);
  return condition;
}

void read_frequencies(ValueReader& values, const ValueSyntax& list, Equilibrium& equilibrium) {
  Context& context = values.context();
  const Unit unit = power(*find_unit("s"), {-2, 1});
  equilibrium.frequencies_squared = values.roots(list, {frequency_place, unit});
  const std::size_t count = context.model.velocities.size();
  if (list.items.size() == count) return;
  context.report.add(Code::E517, list.span,
                     counted(list.items.size(), "value") + ", but the model has " +
                         std::to_string(count) + (count == 1 ? " velocity" : " velocities"));
}

}  // namespace

void read_equilibrium(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  Model& model = values.context().model;
  Equilibrium& equilibrium = model.equilibria[target];
  equilibrium.coordinates.resize(model.coordinates.size());
  equilibrium.inputs.resize(model.inputs.size());
  const auto read_there = [&](std::string_view name, const PointTable& table) {
    const KeySyntax* given = entry.find(name);
    if (given == nullptr) return;
    for (const KeySyntax& key : given->value.entries) {
      read_point_value(values, table, key, equilibrium);
    }
  };
  read_there("at", coordinates_there);
  read_there("inputs", inputs_there);
  if (const KeySyntax* when = entry.find("when")) {
    equilibrium.condition = read_condition(values, when->value);
  }
  if (const KeySyntax* squares = entry.find("frequencies_squared")) {
    read_frequencies(values, squares->value, equilibrium);
  }
}

}  // namespace elgen
