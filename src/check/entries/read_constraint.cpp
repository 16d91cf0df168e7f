// Constraints: an entry becomes one Constraint for each equation.
//
//     name = "loop", coincide = ["P", "Q"]      ->   loop_x: x(P) - x(Q), loop_y: y(P) - y(Q)
//     name = "loop", equation = ["a = b", …]    ->   loop_1: a - b, …
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/reason.hpp"
#include "check/entries/entries.hpp"
#include "check/expressions/node_builder.hpp"
#include "check/expressions/places.hpp"
#include "elgen/leaf_names.hpp"

namespace elgen {
namespace {

constexpr ExpressionRole position_equation{place::position_equation, place::configuration_terms};
constexpr ExpressionRole velocity_equation{place::velocity_equation, place::state_terms};
constexpr ExpressionRole gain{"a gain", place::parameters_only};

/// "link[3]" -> "link_x[3]"
std::string with_suffix(const std::string& name, std::string_view suffix) {
  const std::size_t end = std::min(name.find('['), name.size());
  return name.substr(0, end) + "_" + std::string(suffix) + name.substr(end);
}

class ConstraintReader {
 public:
  ConstraintReader(ValueReader& values, const EntrySyntax& entry, Constraint blank)
      : values_(values),
        context_(values.context()),
        entry_(entry),
        row_template_(std::move(blank)) {}

  void read() {
    row_template_.is_position = text_value(entry_, "kind") != "velocity";
    if (const KeySyntax* gains = entry_.find("stabilise")) {
      row_template_.omega = values_.root(gains->value, "omega", {gain, find_unit("Hz")});
      row_template_.zeta = values_.root(gains->value, "zeta", {gain, Unit{}});
      check_nonnegative(*row_template_.omega, *gains->value.find("omega"));
      if (row_template_.zeta) check_nonnegative(*row_template_.zeta, *gains->value.find("zeta"));
      if (!row_template_.zeta)
        row_template_.zeta = NodeBuilder(context_, gains->value.span).number(1);
    }
    constexpr std::array<std::string_view, 2> kinds{"equation", "coincide"};
    const auto [first, second] = first_two_keys(entry_, kinds);
    if (first == nullptr || second != nullptr) {
      context_.report.add(Reason::not_one_alternative,
                          second == nullptr ? entry_.span : second->key_span,
                          "a constraint has exactly one of `equation` and `coincide`");
    } else if (first->key == "equation") {
      read_equations(first->value);
    } else {
      read_coincidence(first->value);
    }
  }

 private:
  void read_equations(const ValueSyntax& list) {
    const ExpressionRole& place = row_template_.is_position ? position_equation : velocity_equation;
    for (std::size_t i = 0; i < list.items.size(); ++i) {
      const ValueSyntax& item = list.items[i];
      const std::optional<ExpressionSyntax> value = residual_syntax(item);
      if (!value) continue;
      const std::string suffix = list.items.size() == 1 ? "" : std::to_string(i + 1);
      add_equation(suffix, values_.read_root(*value, {place}), item.span);
    }
  }

  void check_nonnegative(ExpressionId value, const KeySyntax& key) {
    const auto number = context_.constants[value];
    if (!number || !cln::minusp(*number)) return;
    context_.report.add(
        Reason::negative_gain, key.value.span,
        in_backticks(key.value.span) + " is negative: errors of the constraint would grow");
  }

  /// Adds a row for each component that both points have. An unknown point counts as a point of the
  /// model's dimension, since too few equations would cause a second error.
  void read_coincidence(const ValueSyntax& list) {
    if (list.items.size() != 2) {
      context_.report.add(Reason::wrong_list_length, list.span,
                          count_text(list.items.size(), "point") + ", but `coincide` takes two");
      return;
    }
    if (!row_template_.is_position) {
      context_.report.add(Reason::velocity_of_coincidence, entry_.find("coincide")->key_span,
                          "`coincide` is a constraint on positions");
    }
    const auto p = values_.resolve_reference(list.items[0], SymbolKind::point);
    const auto q = values_.resolve_reference(list.items[1], SymbolKind::point);
    const auto& points = context_.model.points;
    const auto components = [&](const std::optional<std::uint32_t>& point) {
      return point ? points[*point].dimension : context_.dimension == 2 ? 2U : 3U;
    };
    NodeBuilder nodes(context_, list.span);
    const auto component = [&](const std::optional<std::uint32_t>& point, std::uint32_t axis) {
      const bool is_zero = !point || points[*point].position[axis] == no_expression;
      return is_zero ? no_expression : nodes.name_node(NamedKind::point, *point, axis);
    };
    const std::uint32_t dimension = std::min(components(p), components(q));
    for (std::uint32_t axis = 0; axis < dimension; ++axis) {
      const ExpressionId value = nodes.subtract(component(p, axis), component(q, axis));
      const std::string name(1, "xyz"[axis]);
      add_equation(name, value, list.span);
      Constraint& row = context_.model.constraints.back();
      row.equality =
          fmt::format("{0}({1}) = {0}({2})", name, list.items[0].text, list.items[1].text);
      if (context_.has_units) row.unit = find_unit("m");
    }
  }

  void add_equation(const std::string& suffix, ExpressionId value, const Span& span) {
    Constraint row = row_template_;
    row.value = value;
    row.equation_span = span;
    if (!suffix.empty()) row.name = with_suffix(row_template_.name, suffix);
    row.identifier = identifier_of(row.name);
    const DeclaredName* other = context_.symbols.find("lambda_" + row.name);
    if (other != nullptr) {
      context_.report.add({Code::E203, row.span,
                           quote_text("lambda_" + row.name) +
                               " is the multiplier of this constraint, but also " +
                               with_article(symbol_noun(other->kind)),
                           "", other->span, "declared here"});
    }
    std::vector<Constraint>& rows = context_.model.constraints;
    const auto same = std::ranges::find(rows, row.identifier, &Constraint::identifier);
    // Two entries with the same name are already reported.
    if (same != rows.end() && covered_text(same->span) != covered_text(row.span)) {
      context_.report.add({Code::E203, row.span,
                           quote_text(row.name) + " is already the name of an equation", "",
                           same->span, "of this constraint"});
    }
    rows.push_back(std::move(row));
  }

  ValueReader& values_;
  Context& context_;
  const EntrySyntax& entry_;
  Constraint row_template_;
};

/// True if a variable angle or a quaternion turns the frame or an ancestor of the frame.
bool may_turn(const Context& context, std::optional<std::uint32_t> frame) {
  for (; frame; frame = context.model.frames[*frame].parent) {
    for (const ElementaryTransform& step : context.model.frames[*frame].transforms) {
      if (step.kind == TransformKind::quaternion) return true;
      if (step.kind == TransformKind::turn && !context.constants[step.angle]) return true;
    }
  }
  return false;
}

/// The point P if the expression is dot(x(P)), dot(y(P)) or dot(z(P)); none for other expressions.
std::optional<std::uint32_t> find_rate_point(const Model& model, ExpressionId value) {
  const Expression& node = model.expressions[value];
  if (node.kind != ExpressionKind::time_derivative) return std::nullopt;
  const Expression& inner = model.expressions[node.operands[0]];
  if (!refers_to_entry(inner, NamedKind::point)) return std::nullopt;
  return inner.index;
}

/// Warns with E541 if two velocity equations fix the same point of a turning frame. The warning is
/// at the second equation.
void warn_of_material_points(Context& context) {
  std::vector<std::uint32_t> held;
  for (const Constraint& row : context.model.constraints) {
    const auto point = find_rate_point(context.model, row.value);
    if (row.is_position || !point) continue;
    held.push_back(*point);
    const Point& at = context.model.points[*point];
    if (std::ranges::count(held, *point) != 2 || !at.local) continue;
    const std::uint32_t frame = at.local->frame;
    if (!may_turn(context, frame)) continue;
    context.report.add(Code::E541, row.equation_span,
                       quote_text(at.name) + " turns with " +
                           quote_text(context.model.frames[frame].name) +
                           ", so the equation fixes one material point, as in a pivot",
                       "for a rolling contact, write the velocity of the centre: `dot(x) = "
                       "r*wy(F)`");
  }
}

}  // namespace

void read_constraints(Context& context, const std::vector<EntryInstance>& instances) {
  const std::vector<Constraint> row_templates = std::exchange(context.model.constraints, {});
  for (const auto& [entry, scope, target] : instances) {
    if (entry->name != "constraint") continue;
    ValueReader values(context, scope);
    ConstraintReader(values, *entry, row_templates[target]).read();
  }
  warn_of_material_points(context);
}

}  // namespace elgen
