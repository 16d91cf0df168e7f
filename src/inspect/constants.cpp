// E312, E313, E314, E910: constants without a value, and too large powers, that are found only if
// names are replaced by their expressions. These names are definitions, prescribed functions
// without t, components of points, fixed parameters and locks.
//
//     c = 2      asin(c)*x        asin(c) has no value
//     x1 = x*x   x2 = x1*x1 ...   the degree is computed before anything is expanded
//
// The stage check has already evaluated constants without names. This check follows names, operands
// before users, and uses the same evaluate_constant(). A value with too few known digits is treated
// as unknown.
#include "check/names/constants.hpp"

#include <cln/real_ring.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "elgen/references.hpp"
#include "elgen/wording.hpp"
#include "inspect/checks.hpp"
#include "inspect/readable.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// Number of digits of pi and of roots: enough for the sine of numbers up to 10^300.
constexpr int max_digits = 400;
/// A value with fewer known digits is treated as unknown, because cancellation may hide a 0.
constexpr int min_known_digits = 60;

/// The largest degree of a product. In double, x^10000 overflows or underflows unless |x| is
/// between 0.93 and 1.07.
constexpr double largest_degree = 10'000;

/// The size of an expanded expression: its degree in the variables, and the number of digits of its
/// numbers.
struct Growth {
  double degree = 0;
  double digits = 0;
};

/// The value of a fixed parameter with its error: 0 for a rational value, 10^-constant_digits times
/// the magnitude for an irrational value.
EnclosedNumber enclose_fixed_value(const cl_R& fixed) {
  if (is_rational(fixed)) return {fixed, 0};
  return {cln::cl_float(fixed, cln::float_format(max_digits)),
          cln::abs(fixed) * power_of_ten(-constant_digits)};
}

bool is_precise_enough(const EnclosedNumber& x) {
  static const cln::cl_RA share = power_of_ten(-min_known_digits);
  return x.error <= share * cln::abs(x.value);
}

double digit_count_of(const cl_R& number) {
  if (!is_rational(number)) return 0;
  const auto rational = cln::the<cln::cl_RA>(number);
  const bool is_unit = cln::abs(rational) == 1 || cln::zerop(rational);
  return is_unit ? 0 : static_cast<double>(digit_count(rational));
}

/// True if the node has no operands to evaluate. The arguments of an open function do not count.
bool has_no_operands(const Expression& node) {
  return node.operands.empty() || node.kind == ExpressionKind::leaf;
}

bool is_number(const Expression& node) {
  return node.kind == ExpressionKind::number || node.kind == ExpressionKind::pi;
}

class ConstantEvaluator {
 public:
  explicit ConstantEvaluator(const InspectedModel& subject)
      : subject_(subject),
        model_(subject.model),
        known_values_(model_.expressions.size()),
        growth_(model_.expressions.size()) {}

  /// Evaluates a node. All nodes that it refers to must have been visited.
  void evaluate_reference(ExpressionId id) {
    const Expression& node = model_.expressions[id];
    const auto referred = references(model_, id);
    if (node.operands.empty() && !referred.empty()) {
      known_values_[id] = known_values_[referred.front()];
      growth_[id] = growth_[referred.front()];
    } else if (evaluate_if_constant(id, node)) {
      update_growth(id, node);
    }
  }

  Diagnostics take_diagnostics() { return std::move(diagnostics_); }

 private:
  /// Evaluates `node` if it is constant. If a constant node has no value, reports an error and
  /// returns false.
  bool evaluate_if_constant(ExpressionId id, const Expression& node) {
    if (is_leaf(node, Opcode::parameter)) {
      const auto& fixed = subject_.scene.specialisation.fixed;
      const auto value = fixed.find(node.index);
      if (value != fixed.end()) known_values_[id] = enclose_fixed_value(value->second.number);
      return true;
    }
    if (node.kind == ExpressionKind::divide && is_zero(node.operands[1])) {
      return report_failure(node, {Code::E312, "is zero", 1});
    }
    if (!is_constant(node)) return true;
    if (node.kind == ExpressionKind::time_derivative) {
      known_values_[id] = EnclosedNumber{};
      return true;
    }
    std::vector<EnclosedNumber> operands;
    for (const ExpressionId operand : node.operands) operands.push_back(*known_values_[operand]);
    ConstantOutcome outcome = evaluate_constant(node, operands, max_digits);
    if (outcome.failure) return report_failure(node, *outcome.failure);
    if (outcome.value && is_precise_enough(*outcome.value))
      known_values_[id] = std::move(outcome.value);
    return true;
  }

  [[nodiscard]] bool is_constant(const Expression& node) const {
    if (has_no_operands(node)) return is_number(node);
    return std::all_of(node.operands.begin(), node.operands.end(),
                       [this](ExpressionId operand) { return known_values_[operand].has_value(); });
  }

  [[nodiscard]] bool is_zero(ExpressionId id) const {
    return known_values_[id] && cln::zerop(known_values_[id]->value);
  }

  void update_growth(ExpressionId id, const Expression& node) {
    Growth& growth = growth_[id];
    if (known_values_[id]) {
      growth.digits = digit_count_of(known_values_[id]->value);
    } else if (has_no_operands(node) || node.kind == ExpressionKind::function) {
      growth.degree = 1;
    } else {
      growth = combined_growth(node);
    }
    const bool is_known = growth.degree <= largest_degree;
    if (is_known && growth.digits <= static_cast<double>(largest_exact_digits)) return;
    diagnostics_.push_back({Code::E910, node.span,
                            is_known ? fmt::format("{} has numbers of more than {} digits",
                                                   in_backticks(node.span), largest_exact_digits)
                                     : fmt::format("{} has powers beyond {}",
                                                   in_backticks(node.span), largest_degree)});
    growth = {};
  }

  /// The growth of a node from its operands: the sum over factors, a multiple for a power, the
  /// maximum over the terms of a sum.
  [[nodiscard]] Growth combined_growth(const Expression& node) const {
    const bool adds = node.kind == ExpressionKind::multiply || node.kind == ExpressionKind::divide;
    Growth growth;
    for (const ExpressionId id : node.operands) {
      const Growth& operand = growth_[id];
      growth.degree =
          adds ? growth.degree + operand.degree : std::max(growth.degree, operand.degree);
      growth.digits =
          adds ? growth.digits + operand.digits : std::max(growth.digits, operand.digits);
    }
    if (node.kind == ExpressionKind::power) {
      const double exponent = std::abs(cln::double_approx(node.number));
      growth.degree *= exponent;
      growth.digits *= exponent;
    }
    return growth;
  }

  bool report_failure(const Expression& node, const ConstantFailure& failure) {
    const bool is_operand = failure.operand && *failure.operand < node.operands.size();
    const Span span =
        is_operand ? model_.expressions[node.operands[*failure.operand]].span : node.span;
    // The stage check rejects literals of this length (E914), so the number results from
    // operations.
    const Code code = failure.code == Code::E914 ? Code::E910 : failure.code;
    diagnostics_.push_back(
        {code, span, in_backticks(span) + " " + failure.message, operand_values_text(node)});
    return false;
  }

  /// The known values of the names in the operands of `node`: "`c` is 2, `d` is fixed at 3".
  [[nodiscard]] std::string operand_values_text(const Expression& node) const {
    std::vector<std::string> values;
    std::vector<ExpressionId> stack(node.operands.rbegin(), node.operands.rend());
    while (!stack.empty()) {
      const ExpressionId id = stack.back();
      stack.pop_back();
      const Expression& operand = model_.expressions[id];
      const std::string value = name_value_text(id);
      const bool is_new = std::find(values.begin(), values.end(), value) == values.end();
      if (!value.empty() && is_new) values.push_back(value);
      stack.insert(stack.end(), operand.operands.rbegin(), operand.operands.rend());
    }
    return fmt::format("{}", fmt::join(values, ", "));
  }

  [[nodiscard]] std::string name_value_text(ExpressionId id) const {
    constexpr std::size_t longest = 20;
    const Expression& node = model_.expressions[id];
    if (!node.operands.empty() || is_number(node) || !known_values_[id]) return {};
    const std::string value = readable_number(known_values_[id]->value);
    if (value.size() > longest) return {};
    return fmt::format("`{}` is {}{}", to_string(model_, id), cause_of(node), value);
  }

  [[nodiscard]] const char* cause_of(const Expression& node) const {
    if (is_leaf(node, Opcode::parameter)) return "fixed at ";
    const bool is_locked = refers_to_entry(node, NamedKind::prescribed) &&
                           node.index >= unreduced_model(model_).prescribed.size();
    return is_locked ? "locked at " : "";
  }

  const InspectedModel& subject_;
  const Model& model_;
  std::vector<std::optional<EnclosedNumber>> known_values_;
  std::vector<Growth> growth_;
  Diagnostics diagnostics_ = {};
};

}  // namespace

Diagnostics inspect_constants(const InspectedModel& subject) {
  ConstantEvaluator names(subject);
  const Model& model = subject.model;
  // Closed forms of [[expect]] are not roots; they are checked when they are compared.
  const auto is_any = [](const Root&) { return true; };
  for (const ExpressionId id : reachable_expressions(model, filter_roots(model, is_any)))
    names.evaluate_reference(id);
  return names.take_diagnostics();
}

}  // namespace elgen
