// E312, E313, E314, E910: constants without a value, and too large powers, that are found only if
// names are replaced by their expressions. Such names are definitions, prescribed functions without
// t, components of points, fixed parameters and locks.
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
constexpr int most_digits = 400;
/// A value with fewer known digits is treated as unknown, because cancellation may hide a 0.
constexpr int least_digits = 60;

/// The largest degree of a product. In double, x^10000 overflows or underflows unless |x| is
/// between 0.93 and 1.07.
constexpr double largest_degree = 10'000;

/// The size of an expanded expression: its degree in the variables, and the number of digits of its
/// numbers.
struct Growth {
  double degree = 0;
  double digits = 0;
};

/// The value of a fixed parameter with its error. An irrational value has constant_digits digits.
EnclosedNumber enclose_fixed_value(const cl_R& fixed) {
  if (is_rational(fixed)) return {fixed, 0};
  return {cln::cl_float(fixed, cln::float_format(most_digits)),
          cln::abs(fixed) * power_of_ten(-constant_digits)};
}

bool is_known(const EnclosedNumber& x) {
  static const cln::cl_RA share = power_of_ten(-least_digits);
  return x.error <= share * cln::abs(x.value);
}

double digits_of(const cl_R& number) {
  if (!is_rational(number)) return 0;
  const auto rational = cln::the<cln::cl_RA>(number);
  const bool is_unit = cln::abs(rational) == 1 || cln::zerop(rational);
  return is_unit ? 0 : static_cast<double>(digit_count(rational));
}

/// True if the node has no operands to evaluate. The arguments of an open function do not count.
bool is_last(const Expression& node) {
  return node.operands.empty() || node.kind == ExpressionKind::leaf;
}

bool is_number(const Expression& node) {
  return node.kind == ExpressionKind::number || node.kind == ExpressionKind::pi;
}

class NamedConstants {
 public:
  explicit NamedConstants(const Inspected& subject)
      : subject_(subject),
        model_(subject.model),
        known_(model_.expressions.size()),
        growth_(model_.expressions.size()) {}

  /// Evaluates a node. All nodes that it refers to must have been visited.
  void visit(ExpressionId id) {
    const Expression& node = model_.expressions[id];
    const auto referred = references(model_, id);
    if (node.operands.empty() && !referred.empty()) {
      known_[id] = known_[referred.front()];
      growth_[id] = growth_[referred.front()];
    } else if (evaluate(id, node)) {
      grow(id, node);
    }
  }

  Diagnostics take() { return std::move(found_); }

 private:
  /// Evaluates the node if it is constant. Reports an error and returns false if it has no value.
  bool evaluate(ExpressionId id, const Expression& node) {
    if (is_leaf(node, Opcode::parameter)) {
      const auto& fixed = subject_.scene.specialisation.fixed;
      const auto value = fixed.find(node.index);
      if (value != fixed.end()) known_[id] = enclose_fixed_value(value->second.number);
      return true;
    }
    if (node.kind == ExpressionKind::divide && is_zero(node.operands[1])) {
      return report(node, {Code::E312, "is zero", 1});
    }
    if (!is_constant(node)) return true;
    if (node.kind == ExpressionKind::time_derivative) {
      known_[id] = EnclosedNumber{};
      return true;
    }
    std::vector<EnclosedNumber> operands;
    for (const ExpressionId operand : node.operands) operands.push_back(*known_[operand]);
    ConstantOutcome outcome = evaluate_constant(node, operands, most_digits);
    if (outcome.failure) return report(node, *outcome.failure);
    if (outcome.value && is_known(*outcome.value)) known_[id] = std::move(outcome.value);
    return true;
  }

  [[nodiscard]] bool is_constant(const Expression& node) const {
    if (is_last(node)) return is_number(node);
    return std::all_of(node.operands.begin(), node.operands.end(),
                       [this](ExpressionId operand) { return known_[operand].has_value(); });
  }

  [[nodiscard]] bool is_zero(ExpressionId id) const {
    return known_[id] && cln::zerop(known_[id]->value);
  }

  void grow(ExpressionId id, const Expression& node) {
    Growth& growth = growth_[id];
    if (known_[id]) {
      growth.digits = digits_of(known_[id]->value);
    } else if (is_last(node) || node.kind == ExpressionKind::function) {
      growth.degree = 1;
    } else {
      growth = combined_growth(node);
    }
    const bool is_known = growth.degree <= largest_degree;
    if (is_known && growth.digits <= static_cast<double>(largest_exact_digits)) return;
    found_.push_back({Code::E910, node.span,
                      is_known ? fmt::format("{} has numbers of more than {} digits",
                                             in_backticks(node.span), largest_exact_digits)
                               : fmt::format("{} has powers beyond {}", in_backticks(node.span),
                                             largest_degree)});
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

  bool report(const Expression& node, const ConstantFailure& failure) {
    const bool is_operand = failure.operand && *failure.operand < node.operands.size();
    const Span span =
        is_operand ? model_.expressions[node.operands[*failure.operand]].span : node.span;
    // The stage check rejects literals of this length (E914), so the number results from
    // operations.
    const Code code = failure.code == Code::E914 ? Code::E910 : failure.code;
    found_.push_back({code, span, in_backticks(span) + " " + failure.message, values_in(node)});
    return false;
  }

  /// The values of the names in a node that has no value: "`c` is 2".
  [[nodiscard]] std::string values_in(const Expression& node) const {
    std::vector<std::string> values;
    std::vector<ExpressionId> stack(node.operands.rbegin(), node.operands.rend());
    while (!stack.empty()) {
      const ExpressionId id = stack.back();
      stack.pop_back();
      const Expression& operand = model_.expressions[id];
      const std::string value = value_of_name(id);
      const bool is_new = std::find(values.begin(), values.end(), value) == values.end();
      if (!value.empty() && is_new) values.push_back(value);
      stack.insert(stack.end(), operand.operands.rbegin(), operand.operands.rend());
    }
    return fmt::format("{}", fmt::join(values, ", "));
  }

  [[nodiscard]] std::string value_of_name(ExpressionId id) const {
    constexpr std::size_t longest = 20;
    const Expression& node = model_.expressions[id];
    if (!node.operands.empty() || is_number(node) || !known_[id]) return {};
    const std::string value = readable(known_[id]->value);
    if (value.size() > longest) return {};
    return fmt::format("`{}` is {}{}", to_string(model_, id), cause_of(node), value);
  }

  [[nodiscard]] const char* cause_of(const Expression& node) const {
    if (is_leaf(node, Opcode::parameter)) return "fixed at ";
    const bool is_locked =
        is_name(node, NamedKind::prescribed) && node.index >= whole_model(model_).prescribed.size();
    return is_locked ? "locked at " : "";
  }

  const Inspected& subject_;
  const Model& model_;
  std::vector<std::optional<EnclosedNumber>> known_;
  std::vector<Growth> growth_;
  Diagnostics found_ = {};
};

}  // namespace

Diagnostics inspect_constants(const Inspected& subject) {
  NamedConstants names(subject);
  const Model& model = subject.model;
  // Closed forms of [[expect]] are not roots; they are checked when they are compared.
  const auto is_any = [](const Root&) { return true; };
  for (const ExpressionId id : reachable_from(model, roots_if(model, is_any))) names.visit(id);
  return names.take();
}

}  // namespace elgen
