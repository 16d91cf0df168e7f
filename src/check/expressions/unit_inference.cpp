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

enum class UnitKnowledge : std::uint8_t { known, arbitrary, unknown };

struct InferredUnit {
  UnitKnowledge knowledge = UnitKnowledge::unknown;
  Unit unit = {};
};

InferredUnit known_as(const Unit& unit) { return {UnitKnowledge::known, unit}; }
InferredUnit known(std::string_view unit) { return known_as(*find_unit(unit)); }

InferredUnit declared_or_unknown(const std::optional<Unit>& unit) {
  return unit ? known_as(*unit) : InferredUnit{};
}

/// The unit if it is known; none if it is unknown or arbitrary.
std::optional<Unit> known_unit(const InferredUnit& inferred) {
  return inferred.knowledge == UnitKnowledge::known ? std::optional(inferred.unit) : std::nullopt;
}

InferredUnit quotient_unit(const InferredUnit& a, const InferredUnit& b) {
  if (a.knowledge == UnitKnowledge::arbitrary) return a;
  const bool both = a.knowledge == UnitKnowledge::known && b.knowledge == UnitKnowledge::known;
  return both ? known_as(a.unit / b.unit) : InferredUnit{};
}

InferredUnit rate_unit(const InferredUnit& base) { return quotient_unit(base, known("s")); }

/// The unit 1 of a pure number; unknown if the unit of `argument` is unknown.
InferredUnit pure_if_known(const InferredUnit& argument) {
  return argument.knowledge == UnitKnowledge::unknown ? InferredUnit{} : known_as(Unit{});
}

Exponent to_exponent(const cln::cl_RA& number) {
  const auto integer = [](const cln::cl_I& n) {
    return static_cast<std::int32_t>(cln::cl_I_to_long(n));
  };
  return {integer(cln::numerator(number)), integer(cln::denominator(number))};
}

class UnitInference {
 public:
  explicit UnitInference(Context& context)
      : context_(context), model_(context.model), units_(context.model.expressions.size()) {}

  void infer_units() {
    std::vector<bool> has_unit(units_.size(), false);
    for (const WrittenExpression& root : context_.roots) {
      if (root.is_in_role_unit) continue;
      std::fill(has_unit.begin() + root.first, has_unit.begin() + root.value + 1, true);
    }
    for (const ExpressionId id : topological_order(model_)) {
      if (has_unit[id]) units_[id] = infer_node(id);
    }
    for (const WrittenExpression& root : context_.roots) compare_with_place(root);
    for (OpenValue& value : context_.model.open_values) {
      const std::optional<Unit> unit = known_unit(open_value_unit(value));
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
    report_unit_error(
        Code::E403, root.value, *inferred,
        std::string(root.role.noun) + " is in " + role_unit_text(root.role, *root.unit),
        *inferred == Unit{} ? unnamed_number_hint(model_, root.value) : "");
  }

  InferredUnit infer_node(ExpressionId id) {
    const Expression& node = model_.expressions[id];
    switch (node.kind) {
      case ExpressionKind::number:
        return cln::zerop(node.number) ? InferredUnit{UnitKnowledge::arbitrary, {}}
                                       : known_as(Unit{});
      case ExpressionKind::pi:
        return known_as(Unit{});
      case ExpressionKind::leaf:
        return infer_leaf(node);
      case ExpressionKind::named:
        return infer_name(node);
      default:
        return infer_compound(node, references(model_, id));
    }
  }

  [[nodiscard]] InferredUnit infer_name(const Expression& node) const {
    switch (node.named) {
      case NamedKind::prescribed:
        return prescribed_unit(node.index);
      case NamedKind::definition:
        return units_[model_.definitions[node.index].value];
      case NamedKind::point:
      case NamedKind::body:
        return known("m");
      case NamedKind::frame:
        return frame_component_unit(node.component);
    }
    return {};
  }

  [[nodiscard]] static InferredUnit frame_component_unit(std::uint32_t component) {
    if (component < frame_origin) return known_as(Unit{});
    return known(component < frame_angular_velocity ? "m" : "Hz");
  }

  [[nodiscard]] InferredUnit infer_leaf(const Expression& node) const {
    const InferredUnit of_entry = declared_or_unknown(declared_unit(model_, node.leaf, node.index));
    switch (leaf_row(node.leaf).unit) {
      case LeafUnit::second:
        return known("s");
      case LeafUnit::joule:
        return known("J");
      case LeafUnit::entry_unit:
        return of_entry;
      case LeafUnit::entry_per_second:
        return rate_unit(of_entry);
      case LeafUnit::joule_per_entry:
        return quotient_unit(known("J"), of_entry);
      case LeafUnit::open_value_unit:
        return open_value_unit(model_.open_values[node.index]);
      case LeafUnit::multiplier_unit:
        return infer_multiplier(model_.constraints[node.index]);
    }
    return {};
  }

  /// The unit of the multiplier of an equation r = 0. multiplier * r is in W for a velocity
  /// equation, and in J for a position equation.
  [[nodiscard]] InferredUnit infer_multiplier(const Constraint& constraint) const {
    return quotient_unit(known(constraint.is_position ? "J" : "W"), units_[constraint.value]);
  }

  /// [f]/([x_i] [x_j])
  [[nodiscard]] InferredUnit open_value_unit(const OpenValue& value) const {
    const OpenFunction& function = model_.functions[value.function];
    InferredUnit result = declared_or_unknown(function.unit);
    for (const std::uint32_t argument : value.derivative_arguments) {
      result = quotient_unit(result, units_[function.arguments[argument]]);
    }
    return result;
  }

  InferredUnit infer_compound(const Expression& node, const std::vector<ExpressionId>& parts) {
    const InferredUnit& first = units_[parts.front()];
    switch (node.kind) {
      case ExpressionKind::add:
        return require_common_unit(node, "the sum");
      case ExpressionKind::multiply:
        return infer_product(node);
      case ExpressionKind::divide:
        return quotient_unit(first, units_[parts[1]]);
      case ExpressionKind::power:
        return first.knowledge == UnitKnowledge::known
                   ? known_as(power(first.unit, to_exponent(node.number)))
                   : first;
      case ExpressionKind::function:
        return infer_call(node);
      case ExpressionKind::time_derivative:
        return rate_unit(first);
      default:
        return first;
    }
  }

  /// The declared unit of a prescribed function; without a declaration, the unit of its value.
  [[nodiscard]] InferredUnit prescribed_unit(std::uint32_t index) const {
    const std::optional<Unit>& unit = context_.prescribed_units[index];
    return unit ? known_as(*unit) : units_[model_.prescribed[index].value];
  }

  InferredUnit infer_product(const Expression& node) const {
    InferredUnit result = known_as(Unit{});
    for (const ExpressionId operand : node.operands) {
      const InferredUnit& factor = units_[operand];
      if (factor.knowledge == UnitKnowledge::arbitrary) return factor;
      const bool both =
          factor.knowledge == UnitKnowledge::known && result.knowledge == UnitKnowledge::known;
      result = both ? known_as(result.unit * factor.unit) : InferredUnit{};
    }
    return result;
  }

  /// The unit that all operands share. E401 at the first operand with another unit.
  InferredUnit require_common_unit(const Expression& node, std::string_view what) {
    InferredUnit result{UnitKnowledge::arbitrary, {}};
    ExpressionId first = no_expression;
    bool complete = true;
    for (const ExpressionId operand : node.operands) {
      const InferredUnit& term = units_[operand];
      complete = complete && term.knowledge != UnitKnowledge::unknown;
      if (result.knowledge == UnitKnowledge::arbitrary && term.knowledge == UnitKnowledge::known) {
        result = term;
        first = operand;
      }
      if (term.knowledge == UnitKnowledge::known && term.unit != result.unit) {
        report_unit_error(Code::E401, unsigned_term(operand), term.unit,
                          std::string(what) + " is in " + unit_text_at(operand, result.unit),
                          dimensionless_hint(operand, first));
        return {};
      }
    }
    return complete ? result : InferredUnit{};
  }

  InferredUnit infer_call(const Expression& node) {
    switch (function_row(node.function).units) {
      case FunctionUnits::preserved:
        return units_[node.operands[0]];
      case FunctionUnits::shared:
        return require_common_unit(node, "the other argument");
      case FunctionUnits::ratio:
        return pure_if_known(require_common_unit(node, "the other argument"));
      case FunctionUnits::ignored:
        return pure_if_known(units_[node.operands[0]]);
      case FunctionUnits::dimensionless:
        break;
    }
    return require_pure_argument(node);
  }

  InferredUnit require_pure_argument(const Expression& node) {
    const InferredUnit& argument = units_[node.operands[0]];
    if (argument.knowledge == UnitKnowledge::known && argument.unit != Unit{}) {
      report_unit_error(Code::E404, node.operands[0], argument.unit,
                        quote_text(name_of_call(node)) + " takes a pure number");
    }
    return pure_if_known(argument);
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

  /// unnamed_number_hint() of `a` or `b`, whichever is dimensionless, because a number in this term
  /// may lack a unit. "" if neither term is dimensionless.
  [[nodiscard]] std::string dimensionless_hint(ExpressionId a, ExpressionId b) const {
    if (units_[a].unit == Unit{}) return unnamed_number_hint(model_, a);
    return units_[b].unit == Unit{} ? unnamed_number_hint(model_, b) : "";
  }

  [[nodiscard]] std::string unit_text_at(ExpressionId id, const Unit& unit) const {
    const auto found = std::ranges::find_if(context_.roots, [id](const WrittenExpression& root) {
      return root.first <= id && id <= root.value;
    });
    return role_unit_text(found == context_.roots.end() ? ExpressionRole{} : found->role, unit);
  }

  void report_unit_error(Code code, ExpressionId id, const Unit& observed,
                         const std::string& expected, const std::string& hint = {}) {
    const Span& span = model_.expressions[id].span;
    Diagnostic diagnostic{
        code, span,
        in_backticks(span) + " is in " + unit_text_at(id, observed) + ", but " + expected, hint};
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
  if (context.has_units) UnitInference(context).infer_units();
  // After errors, notes would only distract.
  if (context.report.error_count() > 0) return;
  if (context.has_units) report_plain_numbers(context);
  report_missing_units(context);
}

}  // namespace elgen
