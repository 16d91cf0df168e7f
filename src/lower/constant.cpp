// Constants: folding of sums, products, powers and calls whose operands are all constant.
#include "constant.hpp"

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational_ring.h>
#include <cln/real_io.h>
#include <fmt/core.h>

#include <algorithm>
#include <locale>
#include <optional>
#include <sstream>

namespace elgen {
namespace {

cln::float_format_t constant_format() { return cln::float_format(100); }

/// Most constants are small; streams are slow.
std::optional<std::string> small_number_text(const cln::cl_R& value) {
  if (!cln:: instanceof (value, cln::cl_RA_ring)) return std::nullopt;
  const cln::cl_RA rational = cln::rational(value);
  const cln::cl_I numerator = cln::numerator(rational);
  const cln::cl_I denominator = cln::denominator(rational);
  constexpr std::uintptr_t bits = 31;
  if (cln::integer_length(numerator) > bits || cln::integer_length(denominator) > bits) {
    return std::nullopt;
  }
  const std::string text = std::to_string(cln::cl_I_to_long(numerator));
  if (denominator == 1) return text;
  return text + "/" + std::to_string(cln::cl_I_to_long(denominator));
}

std::string number_text(const cln::cl_R& value) {
  if (auto text = small_number_text(value)) return *text;
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << value;
  return out.str();
}

/// Operands that are written without brackets: numbers, names and calls.
std::string atom_text(const SignedConstant& operand) {
  const std::string& text = operand.constant.text;
  int depth = 0;
  bool is_atom = !operand.negative;
  for (const char c : text) {
    depth += (c == '(') - (c == ')');
    if (depth == 0 && (c == ' ' || c == '*' || c == '^' || c == '/')) is_atom = false;
  }
  return is_atom ? text : fmt::format("({}{})", operand.negative ? "-" : "", text);
}

void sort_by_text(std::vector<SignedConstant>& constants) {
  std::sort(constants.begin(), constants.end(),
            [](const SignedConstant& x, const SignedConstant& y) {
              const bool x_first = is_rational(x.constant) && !is_rational(y.constant);
              const bool y_first = is_rational(y.constant) && !is_rational(x.constant);
              if (x_first != y_first) return x_first;
              return x.constant.text < y.constant.text;
            });
}

cln::cl_R value_of(const SignedConstant& x) {
  return x.negative ? -x.constant.value : x.constant.value;
}

cln::cl_R as_float(const SignedConstant& x) {
  return cln::cl_float(value_of(x), constant_format());
}

cln::cl_R call_value(FunctionId function, const cln::cl_R& x, const cln::cl_R& y) {
  switch (function) {
    case FunctionId::sin:
      return cln::sin(x);
    case FunctionId::cos:
      return cln::cos(x);
    case FunctionId::tan:
      return cln::tan(x);
    case FunctionId::asin:
      return cln::atan(cln::realpart(cln::sqrt(1 - x * x)), x);
    case FunctionId::acos:
      return cln::atan(x, cln::realpart(cln::sqrt(1 - x * x)));
    case FunctionId::atan:
      return cln::atan(x);
    case FunctionId::atan2:
      return cln::atan(y, x);
    case FunctionId::sinh:
      return cln::sinh(x);
    case FunctionId::cosh:
      return cln::cosh(x);
    case FunctionId::tanh:
      return cln::tanh(x);
    case FunctionId::exp:
      return cln::exp(x);
    case FunctionId::log:
      return cln::ln(x);
    case FunctionId::abs:
    case FunctionId::sign:
    case FunctionId::min:
    case FunctionId::max:
      break;  // exact_call
  }
  return x;
}

bool is_exact(FunctionId function) {
  return function == FunctionId::abs || function == FunctionId::sign ||
         function == FunctionId::min || function == FunctionId::max;
}

/// One of the arguments as it stands, with its text, or a small integer.
SignedConstant exact_call(FunctionId function, const SignedConstant& x, const SignedConstant& y) {
  if (function == FunctionId::abs) return {x.constant, false};
  if (function == FunctionId::sign) {
    if (cln::zerop(x.constant.value)) return make_constant(0);
    return make_constant(x.negative ? -1 : 1);
  }
  const bool x_is_less = value_of(x) < value_of(y);
  return x_is_less == (function == FunctionId::min) ? x : y;
}

bool in_domain(FunctionId function, const cln::cl_R& x) {
  if (function == FunctionId::log) return cln::plusp(x);
  if (function == FunctionId::asin || function == FunctionId::acos) return cln::abs(x) <= 1;
  return true;
}

}  // namespace

bool is_rational(const Constant& constant) {
  return cln:: instanceof (constant.value, cln::cl_RA_ring);
}

cln::cl_RA rational_value(const Constant& constant) { return cln::rational(constant.value); }

SignedConstant make_constant(const cln::cl_R& value, const std::string& text) {
  const bool negative = cln::minusp(value);
  const cln::cl_R magnitude = negative ? -value : value;
  const bool rational = cln:: instanceof (magnitude, cln::cl_RA_ring);
  return {{magnitude, rational || text.empty() ? number_text(magnitude) : text}, negative};
}

SignedConstant pi_constant() { return make_constant(cln::pi(constant_format()), "pi"); }

SignedConstant sum_of(std::vector<SignedConstant> terms) {
  sort_by_text(terms);
  cln::cl_R value = 0;
  for (const SignedConstant& term : terms) value = value + value_of(term);
  // The text states the magnitude, so all signs turn where the value is negative.
  const bool negative = cln::minusp(value);
  std::string text;
  for (const SignedConstant& term : terms) {
    const bool minus = term.negative != negative;
    text += text.empty() ? (minus ? "-" : "") : (minus ? " - " : " + ");
    text += term.constant.text;
  }
  return make_constant(value, text);
}

SignedConstant product_of(std::vector<SignedConstant> factors) {
  sort_by_text(factors);
  cln::cl_R value = 1;
  std::string text;
  for (const SignedConstant& factor : factors) {
    value = value * value_of(factor);
    if (factor.constant.text == "1") continue;
    // Only the first factor may be a quotient without brackets.
    const bool is_first = text.empty();
    if (!is_first) text += '*';
    text += is_first && is_rational(factor.constant) ? factor.constant.text
                                                     : atom_text({factor.constant, false});
  }
  return make_constant(value, text);
}

SignedConstant power_of(const SignedConstant& base, int exponent) {
  if (exponent == 1) return base;
  const std::string text =
      fmt::format("{}^{}", atom_text({base.constant, false}),
                  exponent < 0 ? fmt::format("({})", exponent) : std::to_string(exponent));
  return make_constant(cln::expt(value_of(base), exponent), text);
}

SignedConstant square_root_of(const Constant& radicand) {
  cln::cl_RA exact;
  if (is_rational(radicand) && cln::sqrtp(rational_value(radicand), &exact)) {
    return make_constant(exact);
  }
  const cln::cl_R value = cln::sqrt(cln::cl_float(radicand.value, constant_format()));
  return make_constant(value, fmt::format("sqrt({})", radicand.text));
}

SignedConstant call_of(FunctionId function, const std::vector<SignedConstant>& arguments) {
  const SignedConstant& last = arguments.back();
  if (!in_domain(function, value_of(arguments[0]))) return {};
  if (is_exact(function)) return exact_call(function, arguments[0], last);
  std::string text(function_row(function).name);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    text += fmt::format("{}{}{}", i == 0 ? "(" : ", ", arguments[i].negative ? "-" : "",
                        arguments[i].constant.text);
  }
  text += ')';
  const cln::cl_R value = call_value(function, as_float(arguments[0]), as_float(last));
  if (cln::zerop(value)) return make_constant(0);
  if (value == 1) return make_constant(1);
  // The text states the magnitude.
  return make_constant(value, cln::minusp(value) ? fmt::format("(-{})", text) : text);
}

}  // namespace elgen
