// cpp_constant: built-in types get a decimal literal, other types get integers in chunks of six
// digits. A chunk fits every int of at least 21 bits, and every scalar type can be constructed from
// an int.
#include "emit/code/cpp_constant.hpp"

#include <cln/integer.h>
#include <cln/rational.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "base/ascii.hpp"
#include "emit/text/emission_input.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/scalar_literal.hpp"

namespace elgen {
namespace {

/// numerator / denominator * 10^exponent
struct ScaledRatio {
  cln::cl_I numerator = 0;
  cln::cl_I denominator = 1;
  long exponent = 0;
};

/// Digits of an irrational number for scalar types that are not built in.
constexpr int irrational_digits = 66;
/// The largest |k| for which 10^k becomes a factor of the numerator or the denominator.
constexpr long small_exponent = 6;

ScaledRatio decimal_ratio(const Decimal& decimal) {
  const cln::cl_I scale = cln::numerator(power_of_ten(std::abs(decimal.exponent)));
  if (std::abs(decimal.exponent) > small_exponent)
    return {decimal.significand, 1, decimal.exponent};
  if (decimal.exponent < 0) return {decimal.significand, scale, 0};
  return {decimal.significand * scale, 1, 0};
}

ScaledRatio make_scaled_ratio(const cln::cl_R& value) {
  if (!is_rational(value)) return decimal_ratio(rounded_decimal(value, irrational_digits));
  if (const std::optional<Decimal> decimal = exact_decimal(value)) return decimal_ratio(*decimal);
  const cln::cl_RA x = cln::rational(value);
  return {cln::numerator(x), cln::denominator(x), 0};
}

/// "{9, 806650}": the integer in base 10^6, most significant chunk first.
std::string chunks_text(const cln::cl_I& integer) {
  std::vector<std::string> reversed;
  cln::cl_I rest = integer;
  do {
    const cln::cl_I_div_t part = cln::truncate2(rest, 1'000'000);
    reversed.push_back(integer_text(part.remainder));
    rest = part.quotient;
  } while (!cln::zerop(rest));
  return fmt::format("{{{}}}", fmt::join(reversed.rbegin(), reversed.rend(), ", "));
}

std::string literal_or_out_of_range(const cln::cl_R& value, ScalarKind scalar,
                                    std::string_view suffix) {
  if (scalar_fit(value, scalar) != ScalarFit::fits) return "detail::OutOfRange{}";
  return scalar_literal(value, scalar) + std::string(suffix);
}

/// True if the name can state the exact value: for rational numbers, pi, square roots of rational
/// numbers, and products of these.
bool fits_in_name(const ConstantForm& form) {
  const auto is_plain = [](const ConstantOperand& part) {
    const ConstantForm& inner = part.form;
    const bool is_root = inner.kind == ConstantKind::square_root &&
                         inner.operands.front().weight > 0 &&
                         inner.operands.front().form.kind == ConstantKind::rational;
    return is_root || inner.kind == ConstantKind::pi || inner.kind == ConstantKind::rational;
  };
  if (form.kind != ConstantKind::product) return is_plain({form, 1});
  return std::all_of(form.operands.begin(), form.operands.end(), [&](const ConstantOperand& part) {
    return part.weight == 1 && is_plain(part);
  });
}

}  // namespace

std::string cpp_magnitude(const cln::cl_R& value, std::string_view scalar) {
  const cln::cl_R magnitude = cln::abs(value);
  if (const std::optional<std::string> exact = exact_float_literal(magnitude)) {
    return fmt::format("constant<{}>({})", scalar, *exact);
  }
  const ScaledRatio fraction = make_scaled_ratio(magnitude);
  const std::string exponent = fraction.exponent == 0 ? "" : fmt::format(", {}", fraction.exponent);
  return fmt::format("constant<{}>({}, {}, {}, {}, {}{})", scalar,
                     literal_or_out_of_range(magnitude, ScalarKind::single_precision, "F"),
                     literal_or_out_of_range(magnitude, ScalarKind::double_precision, ""),
                     literal_or_out_of_range(magnitude, ScalarKind::long_double, "L"),
                     chunks_text(fraction.numerator), chunks_text(fraction.denominator), exponent);
}

std::string cpp_constant(const cln::cl_R& value) {
  return (cln::minusp(value) ? "-" : "") + cpp_magnitude(value);
}

bool is_short_constant(const cln::cl_R& value) {
  return exact_float_literal(cln::abs(value)).has_value();
}

std::string constant_name(const Constant& constant) {
  constexpr std::size_t longest = 40;
  const cln::cl_R magnitude = cln::abs(constant.value);
  const bool is_fraction = is_rational(constant);
  const std::string text = is_fraction ? exact_text(magnitude) : text_of(constant.form);
  if (text.size() > longest || !fits_in_name(constant.form)) return "number_" + short_hash(text);
  std::string name = "number_";
  for (const char c : text) {
    const bool is_word = is_letter(c) || is_digit(c);
    if (c == '.') name += 'p';
    if (is_word) name += c;
    // 'm' keeps the sign of an exponent distinct from the other separators.
    if (c == '-') name += 'm';
    if (!is_word && c != '.' && c != '-' && name.back() != '_') name += '_';
  }
  if (name.back() == '_') name.pop_back();
  return name;
}

}  // namespace elgen
