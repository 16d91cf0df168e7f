// Decimal numbers as rationals: digits * 10^(exponent - number of fraction digits).
#include "parse/decimal.hpp"

#include <cln/integer.h>
#include <fmt/format.h>

#include <charconv>
#include <limits>

#include "base/ascii.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {

namespace {

char byte_at(std::string_view text, std::size_t position) {
  return position < text.size() ? text[position] : '\0';
}

std::size_t skip_digits(std::string_view text, std::size_t position) {
  while (is_digit(byte_at(text, position))) ++position;
  return position;
}

/// The extent of a malformed number: up to its last letter, digit, underscore or point, so that the
/// message shows the whole number.
NumberExtent malformed_extent(std::string_view text, std::size_t position) {
  const auto belongs = [](char c) { return is_word_character(c) || c == '.'; };
  while (belongs(byte_at(text, position))) ++position;
  return {position, false};
}

bool is_radix_prefix(std::string_view text, std::size_t begin) {
  const char letter = byte_at(text, begin + 1);
  const bool radix = letter == 'x' || letter == 'X' || letter == 'b' || letter == 'o';
  return byte_at(text, begin) == '0' && radix && is_digit(byte_at(text, begin + 2));
}

/// True if the character at `end` must not follow a number directly.
bool has_invalid_continuation(std::string_view text, std::size_t end) {
  const char next = byte_at(text, end);
  const char after = byte_at(text, end + 1);
  const bool second_exponent = (next == 'e' || next == 'E') && is_digit(after);
  return next == '.' || next == '_' || second_exponent;
}

std::string without_leading_zeros(std::string digits) {
  digits.erase(0, digits.find_first_not_of('0'));
  return digits;
}

bool exceeds(const std::string& digits, std::uint64_t limit) {
  std::uint64_t value = 0;
  const char* end = digits.data() + digits.size();
  const auto read = std::from_chars(digits.data(), end, value);
  return read.ec == std::errc::result_out_of_range || value > limit;
}

}  // namespace

NumberExtent number_extent(std::string_view text, std::size_t begin) {
  const std::size_t point = skip_digits(text, begin);
  if (point == begin || is_radix_prefix(text, begin)) return malformed_extent(text, begin);
  std::size_t end = point;
  if (byte_at(text, point) == '.') {
    end = skip_digits(text, point + 1);
    if (end == point + 1) return malformed_extent(text, begin);
  }
  if (byte_at(text, end) == 'e' || byte_at(text, end) == 'E') {
    const bool sign = byte_at(text, end + 1) == '+' || byte_at(text, end + 1) == '-';
    const std::size_t first = end + 1 + (sign ? 1 : 0);
    const std::size_t last = skip_digits(text, first);
    const bool starts_name =
        !sign && (is_letter(byte_at(text, first)) || byte_at(text, first) == '_');
    if (last == first && !starts_name) return {first, false};
    if (last != first) end = last;
  }
  return has_invalid_continuation(text, end) ? malformed_extent(text, end)
                                             : NumberExtent{end, true};
}

DecimalParts decimal_parts(std::string_view text) {
  DecimalParts parts;
  std::size_t position = 0;
  bool in_fraction = false;
  for (; position < text.size() && text[position] != 'e' && text[position] != 'E'; ++position) {
    if (text[position] == '.') in_fraction = true;
    if (!is_digit(text[position])) continue;
    parts.digits += text[position];
    if (in_fraction) ++parts.fraction_digits;
  }
  for (; position < text.size(); ++position) {
    if (text[position] == '-') parts.negative_exponent = true;
    if (is_digit(text[position])) parts.exponent += text[position];
  }
  parts.digits = without_leading_zeros(std::move(parts.digits));
  parts.exponent = without_leading_zeros(std::move(parts.exponent));
  return parts;
}

std::optional<ExceededLimit> find_exceeded_limit(const DecimalParts& parts, const Limits& limits) {
  if (parts.digits.size() > limits.literal_digits) {
    return ExceededLimit{Code::E903,
                         fmt::format("number has {} digits, more than {}", parts.digits.size(),
                                     limits.literal_digits),
                         "`--limit literal_digits=N` raises the limit"};
  }
  if (exceeds(parts.exponent, limits.decimal_exponent)) {
    const std::string shown =
        parts.exponent.size() > 12 ? parts.exponent.substr(0, 12) + "…" : parts.exponent;
    return ExceededLimit{
        Code::E904,
        fmt::format("decimal exponent `{}{}` is beyond ±{}", parts.negative_exponent ? "-" : "",
                    shown, limits.decimal_exponent),
        "`--limit decimal_exponent=N` raises the limit"};
  }
  return std::nullopt;
}

cln::cl_RA decimal_value(const DecimalParts& parts) {
  if (parts.digits.empty()) return 0;
  const cln::cl_I digits = cln::cl_I(parts.digits.c_str());
  std::size_t exponent = 0;
  std::from_chars(parts.exponent.data(), parts.exponent.data() + parts.exponent.size(), exponent);
  const auto power = static_cast<long>(exponent);
  const auto fraction = static_cast<long>(parts.fraction_digits);
  return digits * power_of_ten((parts.negative_exponent ? -power : power) - fraction);
}

std::string decimal_text(const cln::cl_RA& value) {
  const std::optional<Decimal> decimal = exact_decimal(value, std::numeric_limits<long>::max());
  if (!decimal || decimal->exponent >= 0) return number_text(value);
  std::string digits = integer_text(cln::abs(decimal->significand));
  const std::string sign = cln::minusp(value) ? "-" : "";
  constexpr long most_places = 30;  // longer decimals are easier to read with an exponent
  if (-decimal->exponent > most_places)
    return fmt::format("{}{}e{}", sign, digits, decimal->exponent);
  const auto places = static_cast<std::size_t>(-decimal->exponent);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  digits.insert(digits.size() - places, 1, '.');
  return sign + digits;
}

}  // namespace elgen
