// Constraints: an entry becomes one Constraint for each of its equations.
//
//     name = "loop", coincide = ["P", "Q"]      ->   loop_x: x(P) - x(Q), loop_y: y(P) - y(Q)
//     name = "loop", equation = ["a = b", …]    ->   loop_1: a - b, …
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "check/entries/entries.hpp"
#include "check/expressions/node_builder.hpp"
#include "check/expressions/places.hpp"
#include "elgen/leaf_names.hpp"

namespace elgen {
namespace {

constexpr Place position_equation{place::position_equation, place::of_configuration};
constexpr Place velocity_equation{"a constraint on velocities", place::of_state};
constexpr Place gain{"a gain", place::parameters_only};

/// "link[3]" -> "link_x[3]"
std::string with_suffix(const std::string& name, std::string_view suffix) {
  const std::size_t end = std::min(name.find('['), name.size());
  return name.substr(0, end) + "_" + std::string(suffix) + name.substr(end);
}

class ConstraintReader {
 public:
  ConstraintReader(ValueReader& values, const EntrySyntax& entry, Constraint blank)
      : values_(values), context_(values.context()), entry_(entry), blank_(std::move(blank)) {}

  void read() {
    blank_.is_position = text_of(entry_, "kind") != "velocity";
    if (const KeySyntax* gains = entry_.find("stabilise")) {
      blank_.omega = values_.root(gains->value, "omega", {gain, find_unit("Hz")});
      blank_.zeta = values_.root(gains->value, "zeta", {gain, Unit{}});
      refuse_negative(*blank_.omega, *gains->value.find("omega"));
      if (blank_.zeta) refuse_negative(*blank_.zeta, *gains->value.find("zeta"));
      if (!blank_.zeta) blank_.zeta = NodeBuilder(context_, gains->value.span).number(1);
    }
    constexpr std::array<std::string_view, 2> kinds{"equation", "coincide"};
    const auto [first, second] = first_two(entry_, kinds);
    if (first == nullptr || second != nullptr) {
      context_.report.add(Code::E112, second == nullptr ? entry_.span : second->key_span,
                          "a constraint has one of `equation` and `coincide`");
    } else if (first->key == "equation") {
      read_equations(first->value);
    } else {
      read_points(first->value);
    }
  }

 private:
  void read_equations(const ValueSyntax& list) {
    const Place& place = blank_.is_position ? position_equation : velocity_equation;
    for (std::size_t i = 0; i < list.items.size(); ++i) {
      const ValueSyntax& item = list.items[i];
      const std::optional<ExpressionSyntax> value = residual(item);
      if (!value) continue;
      const std::string suffix = list.items.size() == 1 ? "" : std::to_string(i + 1);
      add(suffix, values_.root(*value, {place}), item.span);
    }
  }

  void refuse_negative(ExpressionId value, const KeySyntax& key) {
    const auto number = context_.constants[value];
    if (!number || !cln::minusp(*number)) return;
    context_.report.add(Code::E112, key.value.span,
                        in_backticks(key.value.span) + " is negative: errors would grow");
  }

  /// A row for each component that both points have.
  void read_points(const ValueSyntax& list) {
    if (list.items.size() != 2) {
      context_.report.add(Code::E104, list.span,
                          counted(list.items.size(), "point") + ", but two coincide");
      return;
    }
    if (!blank_.is_position) {
      context_.report.add(Code::E112, entry_.find("coincide")->key_span,
                          "points that coincide are a constraint on positions");
    }
    const auto p = values_.reference(list.items[0], SymbolKind::point);
    const auto q = values_.reference(list.items[1], SymbolKind::point);
    if (!p || !q) return;
    const auto& points = context_.model.points;
    const std::uint32_t dimension = std::min(points[*p].dimension, points[*q].dimension);
    NodeBuilder nodes(context_, list.span);
    const auto component = [&](std::uint32_t point, std::uint32_t axis) {
      const bool is_zero = points[point].at[axis] == no_expression;
      return is_zero ? no_expression
                     : nodes.named(ExpressionKind::point_component, 3 * point + axis);
    };
    for (std::uint32_t axis = 0; axis < dimension; ++axis) {
      const ExpressionId value = nodes.subtract(component(*p, axis), component(*q, axis));
      add(std::string(1, "xyz"[axis]), value, list.span);
      if (context_.has_units) context_.model.constraints.back().unit = find_unit("m");
    }
  }

  void add(const std::string& suffix, ExpressionId value, const Span& span) {
    Constraint row = blank_;
    row.value = value;
    row.equation_span = span;
    if (!suffix.empty()) row.name = with_suffix(blank_.name, suffix);
    row.identifier = identifier_of(row.name);
    const DeclaredName* other = context_.symbols.find("lambda_" + row.name);
    if (other != nullptr) {
      context_.report.add({Code::E203, row.span,
                           in_backticks("lambda_" + row.name) + " is the multiplier, but also " +
                               with_article(noun(other->kind)),
                           "", other->span, "declared here"});
    }
    std::vector<Constraint>& rows = context_.model.constraints;
    const auto same = std::ranges::find(rows, row.identifier, &Constraint::identifier);
    // Two entries of one name are told so already.
    if (same != rows.end() && covered_text(same->span) != covered_text(row.span)) {
      context_.report.add({Code::E203, row.span,
                           in_backticks(row.name) + " is already the name of an equation", "",
                           same->span, "of this constraint"});
    }
    rows.push_back(std::move(row));
  }

  ValueReader& values_;
  Context& context_;
  const EntrySyntax& entry_;
  Constraint blank_;
};

}  // namespace

void read_constraints(Context& context, const std::vector<Instance>& instances) {
  const std::vector<Constraint> blanks = std::exchange(context.model.constraints, {});
  for (const auto& [entry, scope, target] : instances) {
    if (entry->name != "constraint") continue;
    ValueReader values(context, scope);
    ConstraintReader(values, *entry, blanks[target]).read();
  }
}

}  // namespace elgen
