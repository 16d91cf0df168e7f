// Unit expressions, by recursive descent:
//
//     product  = power { ("*" | "/") power }
//     power    = primary [ "^" exponent ]
//     primary  = name | "1" | "(" product ")"
//     exponent = integer | "(" integer [ "/" integer ] ")"
#include <algorithm>
#include <array>
#include <charconv>

#include "base/ascii.hpp"
#include "check/expressions/units.hpp"

namespace elgen {
namespace {

/// A unit outside the language, as a multiple of a unit of the language.
struct ForeignUnitRow {
  std::string_view name;
  std::string_view factor;
  std::string_view unit;
};

constexpr std::array<ForeignUnitRow, 16> foreign_units{{{"deg", "pi/180", "rad"},
                                                        {"g", "0.001", "kg"},
                                                        {"lb", "0.45359237", "kg"},
                                                        {"mm", "0.001", "m"},
                                                        {"cm", "0.01", "m"},
                                                        {"km", "1000", "m"},
                                                        {"ms", "0.001", "s"},
                                                        {"min", "60", "s"},
                                                        {"h", "3600", "s"},
                                                        {"rpm", "pi/30", "rad/s"},
                                                        {"mN", "0.001", "N"},
                                                        {"kN", "1000", "N"},
                                                        {"kW", "1000", "W"},
                                                        {"mA", "0.001", "A"},
                                                        {"mH", "0.001", "H"},
                                                        {"uF", "1e-6", "F"}}};

/// Hint with the value in a unit of the language; only the conversion factor if the value is
/// unknown.
std::string conversion_hint(const ForeignUnitRow& row, const ValueSyntax* value) {
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
  const auto* const multiple = std::ranges::find(foreign_units, name, &ForeignUnitRow::name);
  if (multiple != foreign_units.end()) return conversion_hint(*multiple, value);
  std::vector<std::string> candidates{missing_operator_hint(name)};
  if (candidates.front().empty()) {
    candidates.clear();
    for (const UnitRow& row : unit_table()) candidates.emplace_back(row.name);
  }
  return suggestion(name, candidates);
}

class UnitReader {
 public:
  UnitReader(const ValueSyntax& unit, Report& report, const ValueSyntax* value)
      : text_(unit.text), span_(unit.span), report_(report), value_(value) {}

  std::optional<Unit> read() {
    std::optional<Unit> unit = parse_product(0);
    skip_spaces();
    if (unit && position_ != text_.size()) {
      return fail(position_, position_ + 1, "unexpected " + quote_text(text_.substr(position_, 1)));
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
                unknown_unit_hint(name, name == text_ ? value_ : nullptr));
    return std::nullopt;
  }

  std::optional<Unit> fail(std::size_t begin, std::size_t end, const std::string& message) {
    report_.add(Code::E402, text_span(begin, end), message + " in the unit " + quote_text(text_));
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
  std::size_t position_ = 0;
};

}  // namespace

std::optional<Unit> read_unit(const ValueSyntax& unit, Report& report, const ValueSyntax* value) {
  return UnitReader(unit, report, value).read();
}

}  // namespace elgen
