// Units of expressions: one pass over the arena.
//
// Numbers are dimensionless, but 0 has any unit. If a leaf has no unit, the unit of every
// expression with this leaf is unknown and not compared. A model without units is not checked.
// After an error the node's unit is unknown, so that one mistake is reported once. A value without
// names is in the unit of its place.
#include <cln/integer.h>

#include <algorithm>

#include "check/expressions/units.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/references.hpp"

namespace elgen {
namespace {

enum class Known : std::uint8_t { yes, any, no };

struct InferredUnit {
  Known known = Known::no;
  Unit unit = {};
};

InferredUnit known(const Unit& unit) { return {Known::yes, unit}; }
InferredUnit known(std::string_view unit) { return known(*find_unit(unit)); }

InferredUnit declared(const std::optional<Unit>& unit) {
  return unit ? known(*unit) : InferredUnit{};
}

/// The unit if it is known; none if it is unknown or arbitrary.
std::optional<Unit> known_unit(const InferredUnit& inferred) {
  return inferred.known == Known::yes ? std::optional(inferred.unit) : std::nullopt;
}

InferredUnit quotient(const InferredUnit& a, const InferredUnit& b) {
  if (a.known == Known::any) return a;
  const bool both = a.known == Known::yes && b.known == Known::yes;
  return both ? known(a.unit / b.unit) : InferredUnit{};
}

InferredUnit rate(const InferredUnit& base) { return quotient(base, known("s")); }

/// Dimensionless, unless the argument's unit is unknown.
InferredUnit ratio(const InferredUnit& argument) {
  return argument.known == Known::no ? InferredUnit{} : known(Unit{});
}

Exponent exponent_of(const cln::cl_RA& number) {
  const auto integer = [](const cln::cl_I& n) {
    return static_cast<std::int32_t>(cln::cl_I_to_long(n));
  };
  return {integer(cln::numerator(number)), integer(cln::denominator(number))};
}

class UnitInference {
 public:
  explicit UnitInference(Context& context)
      : context_(context), model_(context.model), units_(context.model.expressions.size()) {}

  void run() {
    std::vector<bool> has_unit(units_.size(), false);
    for (const WrittenExpression& root : context_.roots) {
      if (root.is_in_unit_of_place) continue;
      std::fill(has_unit.begin() + root.first, has_unit.begin() + root.value + 1, true);
    }
    for (const ExpressionId id : topological_order(model_)) {
      if (has_unit[id]) units_[id] = of(id);
    }
    for (const WrittenExpression& root : context_.roots) compare_with_place(root);
    for (OpenValue& value : context_.model.open_values) {
      const std::optional<Unit> unit = known_unit(of_open_value(value));
      if (!unit) continue;
      value.unit = unit;
      value.unit_text = to_string(*unit);
    }
    for (Constraint& constraint : context_.model.constraints) {
      if (const auto unit = known_unit(units_[constraint.value])) constraint.unit = unit;
    }
    for (Expectation& expectation : context_.model.expectations) {
      for (const ExpressionId entry : expectation.entries) {
        expectation.units.push_back(known_unit(units_[entry]));
      }
    }
  }

 private:
  void compare_with_place(const WrittenExpression& root) {
    const std::optional<Unit> inferred = known_unit(units_[root.value]);
    if (!root.unit || root.has_forbidden_ingredient || !inferred || *inferred == *root.unit) return;
    refuse(Code::E403, root.value, *inferred,
           std::string(root.place.noun) + " is in " + unit_text_in(root.place, *root.unit),
           *inferred == Unit{} ? unnamed_number_hint(model_, root.value) : "");
  }

  InferredUnit of(ExpressionId id) {
    const Expression& node = model_.expressions[id];
    switch (node.kind) {
      case ExpressionKind::number:
        return cln::zerop(node.number) ? InferredUnit{Known::any, {}} : known(Unit{});
      case ExpressionKind::pi:
        return known(Unit{});
      case ExpressionKind::leaf:
        return of_leaf(node);
      case ExpressionKind::named:
        return of_name(node);
      default:
        return of_compound(node, references(model_, id));
    }
  }

  [[nodiscard]] InferredUnit of_name(const Expression& node) const {
    switch (node.named) {
      case NamedKind::prescribed:
        return of_prescribed(node.index);
      case NamedKind::definition:
        return units_[model_.definitions[node.index].value];
      case NamedKind::point:
      case NamedKind::body:
        return known("m");
      case NamedKind::frame:
        return of_frame_component(node.component);
    }
    return {};
  }

  [[nodiscard]] static InferredUnit of_frame_component(std::uint32_t component) {
    if (component < frame_origin) return known(Unit{});
    return known(component < frame_angular_velocity ? "m" : "Hz");
  }

  [[nodiscard]] InferredUnit of_leaf(const Expression& node) const {
    const InferredUnit of_entry = declared(declared_unit(model_, node.leaf, node.index));
    switch (leaf_row(node.leaf).unit) {
      case LeafUnit::second:
        return known("s");
      case LeafUnit::joule:
        return known("J");
      case LeafUnit::of_entry:
        return of_entry;
      case LeafUnit::entry_per_second:
        return rate(of_entry);
      case LeafUnit::joule_per_entry:
        return quotient(known("J"), of_entry);
      case LeafUnit::of_open_value:
        return of_open_value(model_.open_values[node.index]);
      case LeafUnit::of_multiplier:
        return of_multiplier(model_.constraints[node.index]);
    }
    return {};
  }

  /// The unit of the multiplier of an equation r = 0. multiplier * r is in W for a velocity
  /// equation, and in J for a position equation.
  [[nodiscard]] InferredUnit of_multiplier(const Constraint& constraint) const {
    return quotient(known(constraint.is_position ? "J" : "W"), units_[constraint.value]);
  }

  /// [f]/([x_i] [x_j])
  [[nodiscard]] InferredUnit of_open_value(const OpenValue& value) const {
    const OpenFunction& function = model_.functions[value.function];
    InferredUnit result = declared(function.unit);
    for (const std::uint32_t argument : value.by) {
      result = quotient(result, units_[function.arguments[argument]]);
    }
    return result;
  }

  InferredUnit of_compound(const Expression& node, const std::vector<ExpressionId>& parts) {
    const InferredUnit& first = units_[parts.front()];
    switch (node.kind) {
      case ExpressionKind::add:
        return common_unit(node, "the sum");
      case ExpressionKind::multiply:
        return product(node);
      case ExpressionKind::divide:
        return quotient(first, units_[parts[1]]);
      case ExpressionKind::power:
        return first.known == Known::yes ? known(power(first.unit, exponent_of(node.number)))
                                         : first;
      case ExpressionKind::function:
        return of_call(node);
      case ExpressionKind::time_derivative:
        return rate(first);
      default:
        return first;
    }
  }

  /// The declared unit of a prescribed function; without a declaration, the unit of its value.
  [[nodiscard]] InferredUnit of_prescribed(std::uint32_t index) const {
    const std::optional<Unit>& unit = context_.prescribed_units[index];
    return unit ? known(*unit) : units_[model_.prescribed[index].value];
  }

  InferredUnit product(const Expression& node) const {
    InferredUnit result = known(Unit{});
    for (const ExpressionId operand : node.operands) {
      const InferredUnit& factor = units_[operand];
      if (factor.known == Known::any) return factor;
      const bool both = factor.known == Known::yes && result.known == Known::yes;
      result = both ? known(result.unit * factor.unit) : InferredUnit{};
    }
    return result;
  }

  /// The unit that all operands share. E401 at the first operand with another unit.
  InferredUnit common_unit(const Expression& node, std::string_view what) {
    InferredUnit result{Known::any, {}};
    ExpressionId first = no_expression;
    bool complete = true;
    for (const ExpressionId operand : node.operands) {
      const InferredUnit& term = units_[operand];
      complete = complete && term.known != Known::no;
      if (result.known == Known::any && term.known == Known::yes) {
        result = term;
        first = operand;
      }
      if (term.known == Known::yes && term.unit != result.unit) {
        refuse(Code::E401, unsigned_term(operand), term.unit,
               std::string(what) + " is in " + text_at(operand, result.unit),
               hint_on_dimensionless(operand, first));
        return {};
      }
    }
    return complete ? result : InferredUnit{};
  }

  InferredUnit of_call(const Expression& node) {
    switch (function_row(node.function).units) {
      case FunctionUnits::kept:
        return units_[node.operands[0]];
      case FunctionUnits::shared:
        return common_unit(node, "the other argument");
      case FunctionUnits::ratio:
        return ratio(common_unit(node, "the other argument"));
      case FunctionUnits::ignored:
        return ratio(units_[node.operands[0]]);
      case FunctionUnits::pure:
        break;
    }
    return require_pure(node);
  }

  InferredUnit require_pure(const Expression& node) {
    const InferredUnit& argument = units_[node.operands[0]];
    if (argument.known == Known::yes && argument.unit != Unit{}) {
      refuse(Code::E404, node.operands[0], argument.unit,
             in_backticks(name_of_call(node)) + " takes a pure number");
    }
    return ratio(argument);
  }

  [[nodiscard]] std::string_view name_of_call(const Expression& node) const {
    const bool is_stumpff = node.function == FunctionId::stumpff;
    const std::string_view own =
        is_stumpff ? stumpff_name(model_.expressions[node.operands[1]].number) : "";
    return own.empty() ? function_row(node.function).name : own;
  }

  /// The term without its sign: b in `a - b`.
  [[nodiscard]] ExpressionId unsigned_term(ExpressionId id) const {
    const Expression& term = model_.expressions[id];
    return term.kind == ExpressionKind::negate ? term.operands[0] : id;
  }

  /// Hint on two terms with different units: if one is dimensionless, a number in it may lack a
  /// unit.
  [[nodiscard]] std::string hint_on_dimensionless(ExpressionId a, ExpressionId b) const {
    if (units_[a].unit == Unit{}) return unnamed_number_hint(model_, a);
    return units_[b].unit == Unit{} ? unnamed_number_hint(model_, b) : "";
  }

  [[nodiscard]] std::string text_at(ExpressionId id, const Unit& unit) const {
    const auto found = std::ranges::find_if(context_.roots, [id](const WrittenExpression& root) {
      return root.first <= id && id <= root.value;
    });
    return unit_text_in(found == context_.roots.end() ? Place{} : found->place, unit);
  }

  void refuse(Code code, ExpressionId id, const Unit& observed, const std::string& expected,
              const std::string& hint = {}) {
    const Span& span = model_.expressions[id].span;
    Diagnostic diagnostic{
        code, span, in_backticks(span) + " is in " + text_at(id, observed) + ", but " + expected,
        hint};
    if (const auto declared = unit_declaration(model_, id)) {
      diagnostic.related = declared->span;
      diagnostic.related_message = declared->message;
    }
    context_.report.add(std::move(diagnostic));
  }

  Context& context_;
  const Model& model_;
  std::vector<InferredUnit> units_;
};

}  // namespace

bool uses_units(const FileSyntax& model) {
  Report unheard;
  const auto is_used = [&](const KeySyntax* unit) {
    return unit != nullptr && read_unit(unit->value, unheard).value_or(Unit{}) != Unit{};
  };
  const auto has_unit = [&](const EntrySyntax& entry) {
    if (entry.name != "parameters") return is_used(entry.find("unit"));
    return std::ranges::any_of(entry.keys, [&](const KeySyntax& parameter) {
      return is_used(parameter.value.find("unit"));
    });
  };
  return std::ranges::any_of(model.entries, has_unit);
}

void check_units(Context& context) {
  if (context.has_units) UnitInference(context).run();
  // After errors, notes would only distract.
  if (context.report.errors() > 0) return;
  if (context.has_units) note_plain_numbers(context);
  note_missing_units(context);
}

}  // namespace elgen
