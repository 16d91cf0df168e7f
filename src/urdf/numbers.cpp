// Converts numbers of URDF files from the decimal notation of C to the notation of TOML.
#include "urdf/numbers.hpp"

#include <cln/real.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "elgen/wording.hpp"
#include "parse/decimal.hpp"

namespace elgen::urdf {

namespace {

std::string take_digits(std::string_view& rest) {
  const auto end = std::ranges::find_if_not(rest, is_digit);
  const auto count = static_cast<std::size_t>(end - rest.begin());
  std::string digits(rest.substr(0, count));
  rest.remove_prefix(count);
  return digits;
}

bool take(std::string_view& rest, std::string_view any_of) {
  if (rest.empty() || any_of.find(rest.front()) == std::string_view::npos) return false;
  rest.remove_prefix(1);
  return true;
}

/// "e-3", or "" without an exponent; none if the exponent has no digits.
std::optional<std::string> take_exponent(std::string_view& rest) {
  if (!take(rest, "eE")) return std::string();
  std::string exponent = "e";
  if (take(rest, "-")) {
    exponent += '-';
  } else {
    take(rest, "+");
  }
  const std::string digits = take_digits(rest);
  if (digits.empty()) return std::nullopt;
  return exponent + digits;
}

bool is_nonzero(const std::string& digits) {
  return digits.find_first_not_of('0') != std::string::npos;
}

/// The number without its sign in TOML's notation; none if `rest` is no number.
std::optional<std::string> toml_digits(std::string_view rest) {
  std::string whole = take_digits(rest);
  std::string fraction;
  if (take(rest, ".")) fraction = take_digits(rest);
  if (whole.empty() && fraction.empty()) return std::nullopt;
  const std::optional<std::string> exponent = take_exponent(rest);
  if (!exponent || !rest.empty()) return std::nullopt;
  if (!is_nonzero(whole) && !is_nonzero(fraction)) return "0";
  whole.erase(0, std::min(whole.find_first_not_of('0'), whole.size()));
  if (whole.empty()) whole = "0";
  return whole + (fraction.empty() ? "" : "." + fraction) + *exponent;
}

Diagnostic number_error(const Span& span) {
  const std::string shown = quote_text(covered_text(span));
  if (is_not_finite(covered_text(span))) return {Code::E804, span, shown + " is not finite"};
  return {Code::E804, span, shown + " is not a decimal number", xacro_hint(span)};
}

}  // namespace

std::string xacro_hint(const Span& span) {
  const bool is_macro = covered_text(span).find('$') != std::string_view::npos;
  return std::string(is_macro ? xacro_remedy : "");
}

bool is_not_finite(std::string_view text) {
  take(text, "+-");
  std::string word(text);
  std::transform(word.begin(), word.end(), word.begin(), to_lower_case);
  return word == "nan" || word == "inf" || word == "infinity";
}

double clamped_double(const cln::cl_RA& value) {
  const cln::cl_RA large = 1'000'000'000;
  const cln::cl_RA size = cln::abs(value);
  if (size > large) return cln::minusp(value) ? -1e9 : 1e9;
  return size * large * large * large < 1 ? 0.0 : cln::double_approx(value);
}

FileNumber make_file_number(int value) { return {std::to_string(value), value, {}}; }

FileNumber negate_number(FileNumber number) {
  if (number.is_zero()) return number;
  if (number.text.front() == '-') {
    number.text.erase(0, 1);
  } else {
    number.text.insert(0, 1, '-');
  }
  number.value = -number.value;
  return number;
}

Result<FileNumber> read_decimal(const Span& span, const Limits& limits) {
  std::string_view rest = covered_text(span);
  const bool is_negative = take(rest, "-");
  if (!is_negative) take(rest, "+");
  const std::optional<std::string> text = toml_digits(rest);
  if (!text) return number_error(span);
  const DecimalParts parts = decimal_parts(*text);
  if (const auto hit = find_exceeded_limit(parts, limits)) {
    return Diagnostic{hit->code, span, hit->message, hit->hint};
  }
  const FileNumber number{*text, decimal_value(parts), span};
  return is_negative ? negate_number(number) : number;
}

std::vector<Span> word_spans(const Span& span) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::string_view text = covered_text(span);
  std::vector<Span> words;
  std::size_t begin = text.find_first_not_of(blanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    words.push_back({span.source, span.begin + static_cast<std::uint32_t>(begin),
                     span.begin + static_cast<std::uint32_t>(end)});
    begin = text.find_first_not_of(blanks, end);
  }
  return words;
}

}  // namespace elgen::urdf
