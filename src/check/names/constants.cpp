// Constants are evaluated before anything is derived: to report expressions without a value, and to
// keep exact values exact.
//
// If digits cancel or an angle is large, a constant is evaluated again with more digits. Sizes are
// bounded (10^±10000, 4096 exact digits), so that no constant hangs.
#include "check/names/constants.hpp"

#include <cln/integer.h>

#include <algorithm>
#include <cmath>

#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using cln::cl_RA;
using Operands = std::vector<EnclosedNumber>;

/// Digits of the floats: at first 20 more than are kept, then doubled until the kept digits are
/// right.
constexpr int first_digits = constant_digits + 20;
constexpr int max_digits = 30'000;

ConstantOutcome make_failure(Code code, std::string message,
                             std::optional<std::size_t> operand = {}) {
  return {{}, ConstantFailure{code, std::move(message), operand}};
}

ConstantOutcome too_large_failure() { return make_failure(Code::E914, "is beyond 10^±10000"); }

/// `number` exactly, if the enclosure of x contains `number` and x.error is at most 1e-60 `scale`;
/// otherwise x.
EnclosedNumber snap_to_integer(const EnclosedNumber& x, int number, const cl_R& scale) {
  static const cl_RA known_well = power_of_ten(-60);
  const bool may_be = cln::abs(x.value - number) <= x.error;
  return may_be && x.error <= known_well * scale ? EnclosedNumber{number, 0} : x;
}

EnclosedNumber sum_enclosed(const Operands& terms, const EnclosedArithmetic& with) {
  EnclosedNumber total;
  cl_R scale = 0;
  for (const EnclosedNumber& term : terms) {
    total = with.sum(total, term);
    scale = cln::max(scale, cln::abs(term.value));
  }
  return snap_to_integer(total, 0, scale);
}

EnclosedResult multiply_enclosed(const Operands& factors, const EnclosedArithmetic& with) {
  EnclosedNumber total{1, 0};
  for (const EnclosedNumber& factor : factors) {
    total = with.product(total, factor);
    if (std::abs(decimal_exponent(total.value)) > largest_decimal_exponent) {
      return NoValueReason::too_large;
    }
  }
  return total;
}

EnclosedResult divide_enclosed(const Operands& x, const EnclosedArithmetic& with) {
  const EnclosedResult reciprocal = with.reciprocal(x[1]);
  return reciprocal.number ? with.product(x[0], *reciprocal.number) : reciprocal;
}

EnclosedResult call_enclosed(FunctionId function, const Operands& x,
                             const EnclosedArithmetic& with) {
  const bool is_inverse = function == FunctionId::asin || function == FunctionId::acos;
  const EnclosedNumber argument =
      is_inverse ? snap_to_integer(snap_to_integer(x[0], 1, 1), -1, 1) : x[0];
  EnclosedResult value = with.call(function, argument, x.back());
  if (value.number) value.number = snap_to_integer(*value.number, 0, 1);
  return value;
}

EnclosedResult apply_operation(const Expression& node, const Operands& x,
                               const EnclosedArithmetic& with) {
  switch (node.kind) {
    case ExpressionKind::number:
      return EnclosedNumber{node.number, 0};
    case ExpressionKind::pi:
      return with.pi();
    case ExpressionKind::negate:
      return -x[0];
    case ExpressionKind::add:
      return sum_enclosed(x, with);
    case ExpressionKind::multiply:
      return multiply_enclosed(x, with);
    case ExpressionKind::divide:
      return divide_enclosed(x, with);
    case ExpressionKind::power:
      return with.power(x[0], node.number);
    case ExpressionKind::function:
      return call_enclosed(node.function, x, with);
    default:
      return NoValueReason::unknown;
  }
}

/// The result of an operation; unknown if a float overflows, in the value or in the error bound.
EnclosedResult try_operation(const Expression& node, const Operands& x,
                             const EnclosedArithmetic& with) {
  try {
    return apply_operation(node, x, with);
  } catch (const cln::floating_point_exception&) {
    return NoValueReason::unknown;
  }
}

ConstantOutcome outcome_without_value(NoValueReason why) {
  switch (why) {
    case NoValueReason::undefined:
      return make_failure(Code::E313, "has no value");
    case NoValueReason::complex:
      return make_failure(Code::E314, "is not a real number");
    case NoValueReason::too_large:
      return too_large_failure();
    case NoValueReason::unknown:
      break;
  }
  return {};
}

/// True if the relative error is at most 10^-constant_digits.
bool is_precise_enough(const EnclosedNumber& x) {
  static const cl_RA share = power_of_ten(-constant_digits);
  return x.error <= share * cln::abs(x.value);
}

bool is_constant_leaf(ExpressionKind kind) {
  return kind == ExpressionKind::number || kind == ExpressionKind::pi;
}

}  // namespace

ConstantOutcome evaluate_constant(const Expression& node,
                                  const std::vector<EnclosedNumber>& operands, int digits) {
  const bool is_pole = node.kind == ExpressionKind::power && cln::minusp(node.number);
  if (is_pole && sign_of(operands[0]) == 0) return make_failure(Code::E312, "is zero", 0);
  const EnclosedResult result = try_operation(node, operands, EnclosedArithmetic(digits));
  if (!result.number) return outcome_without_value(result.reason);
  const cl_R& value = result.number->value;
  if (sign_of(*result.number) == 0) return {EnclosedNumber{}, {}};
  if (is_rational(value) && digit_count(cln::the<cl_RA>(value)) > largest_exact_digits) {
    return make_failure(Code::E914, "has more than 4096 digits");
  }
  const bool is_float = !is_rational(value);
  if (is_float && std::abs(decimal_exponent(value)) > largest_decimal_exponent)
    return too_large_failure();
  return {*result.number, {}};
}

std::optional<ConstantFailure> ConstantValues::evaluate_next(const std::vector<Expression>& arena) {
  const Expression& node = arena[values_.size()];
  const auto constant = [&](ExpressionId id) { return values_[id].has_value(); };
  const bool all = std::ranges::all_of(node.operands, constant);
  const bool divides = node.kind == ExpressionKind::divide && constant(node.operands[1]);
  values_.emplace_back();
  if (divides && sign_of(*values_[node.operands[1]]) == 0) {
    return ConstantFailure{Code::E312, "is zero", 1};
  }
  const bool is_last = node.operands.empty() || node.kind == ExpressionKind::leaf;
  if (!all || (is_last && !is_constant_leaf(node.kind))) return std::nullopt;
  ConstantOutcome outcome;
  for (int digits = first_digits; digits < max_digits; digits *= 2) {
    outcome = evaluate_node(arena, node, digits);
    if (outcome.failure || (outcome.value && is_precise_enough(*outcome.value))) break;
  }
  values_.back() = std::move(outcome.value);
  return std::move(outcome.failure);
}

ConstantOutcome ConstantValues::evaluate_node(const std::vector<Expression>& arena,
                                              const Expression& node, int digits) const {
  std::vector<EnclosedNumber> operands;
  for (const ExpressionId id : node.operands) {
    operands.push_back(*values_[id]);
    if (digits == first_digits || is_exact(operands.back())) continue;
    const ConstantOutcome again = evaluate_node(arena, arena[id], digits);
    if (again.value) operands.back() = *again.value;
  }
  return evaluate_constant(node, operands, digits);
}

std::size_t digit_count(const cl_RA& number) {
  const auto digits = [](const cln::cl_I& n) {
    return static_cast<std::size_t>(static_cast<double>(cln::integer_length(n)) *
                                    0.30102999566398120) +
           1;
  };
  return std::max(digits(cln::numerator(number)), digits(cln::denominator(number)));
}

}  // namespace elgen
