// Constants: numbers, pi and functions of them, evaluated to find what has no value before anything
// is derived, and to keep exact what is exact.
//
// The precision follows the magnitude: sin(10^30) is evaluated with 30 more digits. Sizes are
// bounded (10^±10000, 4096 exact digits) before anything is computed, so that no constant hangs.
#include "constants.hpp"

#include <cln/cln.h>

#include <algorithm>
#include <cmath>

#include "base/exact_number.hpp"

namespace elgen::checking {
namespace {

using cln::cl_F;
using cln::cl_R;
using cln::cl_RA;

constexpr double largest_decimal_exponent = 10'000;
constexpr double ln10 = 2.302585092994046;
constexpr double log10_of_2 = 0.30102999566398120;
/// Digits lost to rounding that still count as cancellation.
constexpr int guard_digits = 20;

ConstantOutcome value(cl_R number) { return {std::move(number), {}}; }

ConstantOutcome failure(Code code, std::string message, std::optional<std::size_t> operand = {}) {
  return {{}, ConstantFailure{code, std::move(message), operand}};
}

ConstantOutcome too_large() { return failure(Code::E914, "is beyond 10^±10000"); }

cln::float_format_t format_of(int digits) {
  return cln::float_format(static_cast<uintE>(digits) + guard_digits);
}

cl_F as_float(const cl_R& x, int digits) { return cln::cl_float(x, format_of(digits)); }

/// 0 where |x| is below what rounding leaves of `scale`.
cl_R without_rounding(const cl_R& x, const cl_R& scale, int digits) {
  const bool noise = !is_rational(x) && cln::abs(x) < scale * power_of_ten(guard_digits - digits);
  return noise ? cl_R(0) : x;
}

/// Arguments of one node with the digits asked for.
struct Operands {
  const Expression& node;
  const OperandValue& get;
  int digits;

  [[nodiscard]] cl_R operator[](std::size_t i) const { return get(i, digits); }
};

ConstantOutcome sum(const Operands& x) {
  cl_R total = 0;
  cl_R scale = 0;
  for (std::size_t i = 0; i < x.node.operands.size(); ++i) {
    const cl_R term = x[i];
    total = total + term;
    scale = cln::max(scale, cln::abs(term));
  }
  return value(without_rounding(total, scale, x.digits));
}

ConstantOutcome product(const Operands& x) {
  cl_R total = 1;
  for (std::size_t i = 0; i < x.node.operands.size(); ++i) {
    total = total * x[i];
    if (std::abs(decimal_exponent(total)) > largest_decimal_exponent) {
      return too_large();
    }
  }
  return value(total);
}

/// The denominator is not zero; append() looks at it even where the numerator is no constant.
ConstantOutcome quotient(const Operands& x) { return value(x[0] / x[1]); }

/// base^(p/q) of a positive base; exact where the root is.
ConstantOutcome root_power(const cl_R& base, const cl_RA& exponent, int digits) {
  const cln::cl_I q = cln::denominator(exponent);
  if (is_rational(base)) {
    cl_RA root;
    if (cln::rootp(cln::the<cl_RA>(base), q, &root)) {
      return value(cln::expt(root, cln::numerator(exponent)));
    }
  }
  return value(cln::exp(exponent * cln::ln(as_float(base, digits))));
}

ConstantOutcome power(const Operands& x) {
  const cl_R base = x[0];
  const cl_RA exponent = x.node.number;
  if (cln::zerop(base)) {
    if (cln::zerop(exponent)) {
      return failure(Code::E313, "has no value");
    }
    return cln::minusp(exponent) ? failure(Code::E312, "is zero", 0) : value(0);
  }
  if (std::abs(decimal_exponent(base) * cln::double_approx(exponent)) > largest_decimal_exponent) {
    return too_large();
  }
  if (cln::denominator(exponent) == 1) {
    return value(cln::expt(base, cln::numerator(exponent)));
  }
  if (cln::minusp(base)) {
    return failure(Code::E314, "is not a real number");
  }
  return root_power(base, exponent, x.digits);
}

/// sin and cos with as many digits more as the argument has before its point.
struct SineCosine {
  cl_R sine;
  cl_R cosine;
};

SineCosine sine_cosine(const Operands& x) {
  // The kept value tells the magnitude: asking for more digits twice would double with every level.
  const int extra = std::max(0, static_cast<int>(decimal_exponent(x.get(0, constant_digits))) + 1);
  const cl_R angle = x.get(0, x.digits + extra);
  if (cln::zerop(angle)) {
    return {0, 1};
  }
  const cln::cos_sin_t both = cln::cos_sin(as_float(angle, x.digits + extra));
  // Near 0 a small sine is no rounding error, elsewhere it is: no rational is a multiple of pi.
  const bool small = decimal_exponent(angle) < 0;
  return {small ? cl_R(both.sin) : without_rounding(both.sin, 1, x.digits),
          without_rounding(both.cos, 1, x.digits)};
}

ConstantOutcome tangent(const Operands& x) {
  const SineCosine both = sine_cosine(x);
  if (cln::zerop(both.cosine)) {
    return failure(Code::E313, "has no value");
  }
  return value(both.sine / both.cosine);
}

ConstantOutcome inverse_sine_cosine(const Operands& x) {
  cl_R sine = x[0];
  if (cln::abs(cln::abs(sine) - 1) < power_of_ten(guard_digits - x.digits)) {
    sine = cln::signum(cln::realpart(sine)) > 0 ? 1 : -1;
  }
  if (cln::abs(sine) > 1) {
    return failure(Code::E314, "is not a real number");
  }
  const cl_R other = cln::sqrt(as_float(1 - sine * sine, x.digits));
  const bool is_asin = x.node.function == FunctionId::asin;
  return value(is_asin ? cln::atan(other, as_float(sine, x.digits))
                       : cln::atan(as_float(sine, x.digits), other));
}

ConstantOutcome arc_tangent_2(const Operands& x) {
  const cl_R y = x[0];
  const cl_R adjacent = x[1];
  if (cln::zerop(y) && cln::zerop(adjacent)) {
    return failure(Code::E313, "has no value");
  }
  if (cln::zerop(y) && cln::plusp(adjacent)) {
    return value(0);
  }
  return value(cln::atan(as_float(adjacent, x.digits), as_float(y, x.digits)));
}

ConstantOutcome exponential(const Operands& x) {
  const cl_R argument = x[0];
  if (cln::abs(argument) > cl_R(static_cast<long>(largest_decimal_exponent * ln10))) {
    return too_large();
  }
  return value(cln::zerop(argument) ? cl_R(1) : cl_R(cln::exp(as_float(argument, x.digits))));
}

ConstantOutcome logarithm(const Operands& x) {
  const cl_R argument = x[0];
  if (cln::zerop(argument)) {
    return failure(Code::E313, "has no value");
  }
  if (cln::minusp(argument)) {
    return failure(Code::E314, "is not a real number");
  }
  return value(argument == 1 ? cl_R(0) : cl_R(cln::ln(as_float(argument, x.digits))));
}

ConstantOutcome hyperbolic(const Operands& x) {
  const cl_R argument = x[0];
  const FunctionId function = x.node.function;
  if (cln::zerop(argument)) {
    return value(function == FunctionId::cosh ? 1 : 0);
  }
  if (cln::abs(argument) > cl_R(static_cast<long>(largest_decimal_exponent * ln10))) {
    // tanh is ±1 to more digits than are kept.
    return function == FunctionId::tanh ? value(cln::signum(as_float(argument, x.digits)))
                                        : too_large();
  }
  const cl_F y = as_float(argument, x.digits);
  switch (function) {
    case FunctionId::sinh:
      return value(cln::sinh(y));
    case FunctionId::cosh:
      return value(cln::cosh(y));
    default:
      return value(cln::tanh(y));
  }
}

cl_R arc_tangent(const cl_R& x, int digits) {
  return cln::zerop(x) ? cl_R(0) : cl_R(cln::atan(as_float(x, digits)));
}

int sign(const cl_R& x) { return cln::zerop(x) ? 0 : (cln::minusp(x) ? -1 : 1); }

ConstantOutcome call(const Operands& x) {
  switch (x.node.function) {
    case FunctionId::sin:
      return value(sine_cosine(x).sine);
    case FunctionId::cos:
      return value(sine_cosine(x).cosine);
    case FunctionId::tan:
      return tangent(x);
    case FunctionId::asin:
    case FunctionId::acos:
      return inverse_sine_cosine(x);
    case FunctionId::atan:
      return value(arc_tangent(x[0], x.digits));
    case FunctionId::atan2:
      return arc_tangent_2(x);
    case FunctionId::sinh:
    case FunctionId::cosh:
    case FunctionId::tanh:
      return hyperbolic(x);
    case FunctionId::exp:
      return exponential(x);
    case FunctionId::log:
      return logarithm(x);
    case FunctionId::abs:
      return value(cln::abs(x[0]));
    case FunctionId::sign:
      return value(sign(x[0]));
    case FunctionId::min:
      return value(cln::min(x[0], x[1]));
    case FunctionId::max:
      return value(cln::max(x[0], x[1]));
  }
  return {};
}

ConstantOutcome dispatch(const Operands& x) {
  switch (x.node.kind) {
    case ExpressionKind::number:
      return value(x.node.number);
    case ExpressionKind::pi:
      return value(cln::pi(format_of(x.digits)));
    case ExpressionKind::negate:
      return value(-x[0]);
    case ExpressionKind::add:
      return sum(x);
    case ExpressionKind::multiply:
      return product(x);
    case ExpressionKind::divide:
      return quotient(x);
    case ExpressionKind::power:
      return power(x);
    case ExpressionKind::function:
      return call(x);
    default:
      return {};
  }
}

bool is_too_large(const cl_R& x) {
  if (is_rational(x)) {
    return digit_count(cln::the<cl_RA>(x)) > largest_exact_digits;
  }
  return std::abs(decimal_exponent(x)) > largest_decimal_exponent;
}

bool is_zero(const std::optional<cl_R>& x) { return x && cln::zerop(*x); }

bool is_constant_leaf(ExpressionKind kind) {
  return kind == ExpressionKind::number || kind == ExpressionKind::pi;
}

}  // namespace

ConstantOutcome evaluate_constant(const Expression& node, const OperandValue& operand, int digits) {
  ConstantOutcome outcome = dispatch(Operands{node, operand, digits});
  if (is_zero(outcome.value)) {
    return value(0);  // exact, also where a float became 0
  }
  if (outcome.value && is_too_large(*outcome.value)) {
    return failure(Code::E914, is_rational(*outcome.value) ? "has more than 4096 digits"
                                                           : "is beyond 10^±10000");
  }
  return outcome;
}

std::optional<ConstantFailure> Constants::append(const std::vector<Expression>& arena) {
  const Expression& node = arena[values_.size()];
  values_.emplace_back();
  const auto constant = [&](ExpressionId id) { return values_[id].has_value(); };
  const bool all = std::all_of(node.operands.begin(), node.operands.end(), constant);
  if (node.kind == ExpressionKind::divide && is_zero(values_[node.operands[1]])) {
    return ConstantFailure{Code::E312, "is zero", 1};
  }
  if (!all || (node.operands.empty() && !is_constant_leaf(node.kind))) {
    return std::nullopt;
  }
  const auto operand = [&](std::size_t i, int digits) {
    return at(arena, node.operands[i], digits);
  };
  ConstantOutcome outcome = evaluate_constant(node, operand, constant_digits);
  values_.back() = std::move(outcome.value);
  return std::move(outcome.failure);
}

cl_R Constants::at(const std::vector<Expression>& arena, ExpressionId id, int digits) const {
  const Expression& node = arena[id];
  if (digits <= constant_digits || is_rational(*values_[id])) {
    return *values_[id];
  }
  const auto operand = [&](std::size_t i, int more) { return at(arena, node.operands[i], more); };
  const ConstantOutcome outcome = evaluate_constant(node, operand, digits);
  return outcome.value ? *outcome.value : *values_[id];
}

double decimal_exponent(const cl_R& x) {
  if (cln::zerop(x)) {
    return 0;
  }
  if (is_rational(x)) {
    const cl_RA r = cln::the<cl_RA>(x);
    const auto bits = [](const cln::cl_I& n) {
      return static_cast<double>(cln::integer_length(n));
    };
    return (bits(cln::numerator(r)) - bits(cln::denominator(r))) * log10_of_2;
  }
  return static_cast<double>(cln::float_exponent(cln::the<cl_F>(x))) * log10_of_2;
}

std::size_t digit_count(const cl_RA& number) {
  const auto digits = [](const cln::cl_I& n) {
    return static_cast<std::size_t>(static_cast<double>(cln::integer_length(n)) * log10_of_2) + 1;
  };
  return std::max(digits(cln::numerator(number)), digits(cln::denominator(number)));
}

}  // namespace elgen::checking
