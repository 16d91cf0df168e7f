// Unit expressions, by recursive descent:
//
//     product  = power { ("*" | "/") power }
//     power    = primary [ "^" exponent ]
//     primary  = name | "1" | "(" product ")"
//     exponent = integer | "(" integer [ "/" integer ] ")"
#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "check/expressions/units.hpp"

namespace elgen {
namespace {

/// Hint with the value in a unit of the language; only the conversion factor if the value is
/// unknown.
std::string conversion_hint(const UnitMultipleRow& row, const ValueSyntax* value) {
  const std::string factor(row.factor);
  const std::string unit(row.unit);
  const std::string equation = "1 " + std::string(row.name) + " is " + factor + " " + unit;
  if (value == nullptr || value->kind != ValueKind::expression) return equation;
  const std::string number(covered_text(value->expression.span));
  const bool is_sum = number.find_first_of("+-", 1) != std::string::npos;
  return equation + ": write `value = \"" + factor + "*" + (is_sum ? "(" : "") + number +
         (is_sum ? ")" : "") + "\", unit = \"" + unit + "\"`";
}

/// "kg*m" for "kgm", two units without an operator; "" otherwise, and for an initial m (milli).
std::string missing_operator_hint(std::string_view name) {
  if (name.starts_with('m')) return {};
  for (std::size_t i = 1; i < name.size(); ++i) {
    if (!find_unit(name.substr(0, i)) || !find_unit(name.substr(i))) continue;
    return std::string(name.substr(0, i)) + "*" + std::string(name.substr(i));
  }
  return {};
}

/// Hint on an unknown unit. `value` is the number in this unit; null if the number is unknown or
/// the unit text contains other units.
std::string unknown_unit_hint(std::string_view name, const ValueSyntax* value) {
  if (const UnitMultipleRow* const row = find_unit_multiple(name))
    return conversion_hint(*row, value);
  std::vector<std::string> candidates{missing_operator_hint(name)};
  if (candidates.front().empty()) {
    candidates.clear();
    for (const UnitRow& row : unit_table()) candidates.emplace_back(row.name);
  }
  return suggestion(name, candidates);
}

class UnitReader {
 public:
  /// `hint`: the hint of all errors; "": each error has its own.
  UnitReader(const ValueSyntax& unit, Report& report, const ValueSyntax* value,
             const std::string& hint)
      : text_(unit.text), span_(unit.span), report_(report), value_(value), hint_(hint) {}

  std::optional<Unit> read() {
    std::optional<Unit> unit = parse_product(0);
    skip_spaces();
    if (unit && position_ != text_.size()) {
      const std::size_t bytes = std::max<std::size_t>(1, code_point_at(text_, position_).bytes);
      const std::string found = quote_text(text_.substr(position_, bytes));
      return fail(position_, position_ + bytes, "unexpected " + found);
    }
    return unit;
  }

 private:
  static constexpr int max_depth = 50;

  std::optional<Unit> parse_product(int depth) {
    std::optional<Unit> result = parse_power(depth);
    while (result) {
      const bool times = accept('*');
      if (!times && !accept('/')) break;
      const std::optional<Unit> factor = parse_power(depth);
      if (!factor) return std::nullopt;
      result = times ? *result * *factor : *result / *factor;
    }
    return result;
  }

  std::optional<Unit> parse_power(int depth) {
    const std::optional<Unit> base = parse_primary(depth);
    if (!base || !accept('^')) return base;
    const std::optional<Exponent> exponent = parse_exponent();
    return exponent ? std::optional(power(*base, *exponent)) : std::nullopt;
  }

  std::optional<Unit> parse_primary(int depth) {
    if (depth < max_depth && accept('(')) {
      const std::optional<Unit> inner = parse_product(depth + 1);
      if (inner && !accept(')')) return fail(position_, position_ + 1, "missing `)`");
      return inner;
    }
    skip_spaces();
    const std::size_t begin = position_;
    while (position_ < text_.size() &&
           (is_letter(text_[position_]) || is_digit(text_[position_]))) {
      ++position_;
    }
    const std::string_view name = text_.substr(begin, position_ - begin);
    if (name.empty()) return fail(begin, begin + 1, "a unit is missing");
    const std::optional<Unit> unit = find_unit(name);
    return unit ? unit : report_unknown_unit(name, begin);
  }

  std::optional<Exponent> parse_exponent() {
    const std::size_t begin = position_;
    const bool bracket = accept('(');
    const std::optional<std::int32_t> numerator = parse_integer();
    std::optional<std::int32_t> denominator = 1;
    if (bracket && accept('/')) denominator = parse_integer();
    if (!numerator || !denominator || *denominator <= 0 || (bracket && !accept(')'))) {
      fail(begin, std::max(position_, begin + 1), "an exponent is an integer, or `(p/q)`");
      return std::nullopt;
    }
    return Exponent{*numerator, *denominator};
  }

  std::optional<std::int32_t> parse_integer() {
    constexpr std::int32_t largest = 64;
    skip_spaces();
    std::int32_t value = 0;
    const char* end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(text_.data() + position_, end, value);
    if (error != std::errc{} || value > largest || value < -largest) return std::nullopt;
    position_ = static_cast<std::size_t>(stop - text_.data());
    return value;
  }

  std::optional<Unit> report_unknown_unit(std::string_view name, std::size_t begin) {
    report_.add(Code::E402, text_span(begin, begin + name.size()),
                "unknown unit " + quote_text(name),
                hint_.empty() ? unknown_unit_hint(name, name == text_ ? value_ : nullptr) : hint_);
    return std::nullopt;
  }

  std::optional<Unit> fail(std::size_t begin, std::size_t end, const std::string& message) {
    report_.add(Code::E402, text_span(begin, end), message + " in the unit " + quote_text(text_),
                hint_);
    return std::nullopt;
  }

  [[nodiscard]] Span text_span(std::size_t begin, std::size_t end) const {
    const auto at = [&](std::size_t offset) {
      return std::min(span_.begin + static_cast<std::uint32_t>(offset), span_.end);
    };
    return {span_.source, at(begin), at(end)};
  }

  bool accept(char wanted) {
    skip_spaces();
    if (position_ < text_.size() && text_[position_] == wanted) {
      ++position_;
      return true;
    }
    return false;
  }

  void skip_spaces() {
    while (position_ < text_.size() && text_[position_] == ' ') {
      ++position_;
    }
  }

  std::string_view text_;
  Span span_;
  Report& report_;
  const ValueSyntax* value_;
  std::string hint_;
  std::size_t position_ = 0;
};

/// Signs of other notations, and the signs of the language.
constexpr auto unit_signs =
    std::to_array<std::pair<std::string_view, std::string_view>>({{"\u00B7", "*"},
                                                                  {"\u22C5", "*"},
                                                                  {"\u207B", "^-"},
                                                                  {"^-\u00B9", "^-1"},
                                                                  {"^-\u00B2", "^-2"},
                                                                  {"^-\u00B3", "^-3"},
                                                                  {"\u00B2", "^2"},
                                                                  {"\u00B3", "^3"}});

/// The unit with the signs of the language, with `*` between factors, and with `^` before
/// exponents: "kg*m^2" for "kg m²", "m/s^2" for "m/s2".
std::string usual_spelling(std::string text) {
  for (const auto& [sign, usual] : unit_signs) {
    for (std::size_t at = 0; (at = text.find(sign, at)) != std::string::npos;)
      text.replace(at, sign.size(), usual);
  }
  std::string result;
  bool after_space = false;
  for (const char c : text) {
    const char last = result.empty() ? ' ' : result.back();
    const bool begins_factor = is_word_character(c) || c == '(';
    if (after_space && begins_factor && (is_word_character(last) || last == ')')) result += '*';
    if (!after_space && is_letter(last) && is_digit(c)) result += '^';
    after_space = c == ' ';
    if (!after_space) result += c;
  }
  return result;
}

}  // namespace

std::optional<Unit> read_unit(const ValueSyntax& unit, Report& report, const ValueSyntax* value) {
  ValueSyntax usual = unit;
  usual.text = usual_spelling(unit.text);
  Report unheard;
  const bool is_mended = usual.text != unit.text && UnitReader(usual, unheard, nullptr, "").read();
  const std::string hint = is_mended ? "write " + quote_text(usual.text) : "";
  return UnitReader(unit, report, value, hint).read();
}

}  // namespace elgen
