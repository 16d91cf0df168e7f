// Three evaluators of formulas, which share only the values of symbols, powers and roots.
#include "formula/written_values.hpp"

#include <cln/real.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "base/ascii.hpp"
#include "elgen/syntax.hpp"

namespace elgen::test {
namespace {

/// The complex value of a, b or c; different short expressions in a, b, c have different values.
Value value_of_symbol(std::string_view name) {
  if (name == "a") return {1.3, 0.2};
  if (name == "b") return {0.7, -0.4};
  if (name == "c") return {1.6, 0.3};
  throw std::invalid_argument("no symbol: " + std::string(name));
}

[[noreturn]] void fail(const std::string& what, std::string_view where) {
  throw std::invalid_argument(what + " at: " + std::string(where));
}

/// `x` with imaginary part 0 if the imaginary part is only a rounding error or -0. A negative real
/// number is then always on the same side of the branch cut.
Value on_branch(const Value& x) {
  const bool is_real = std::abs(x.imag()) <= 1e-14 * std::abs(x.real());
  return {x.real(), is_real ? 0.0 : x.imag()};
}
Value power_of(const Value& x, const Value& y) { return std::pow(on_branch(x), y); }
Value root_of(const Value& x) { return std::sqrt(on_branch(x)); }

Value value_of_syntax(const ExpressionSyntax& e) {
  const auto operand = [&e](std::size_t i) { return value_of_syntax(e.operands.at(i)); };
  switch (e.kind) {
    case SyntaxKind::number:
      return cln::double_approx(e.value);
    case SyntaxKind::name:
      return value_of_symbol(e.text);
    case SyntaxKind::call:
      if (e.text == "sqrt") return root_of(operand(0));
      if (e.text == "sin") return std::sin(operand(0));
      fail("no function", e.text);
    case SyntaxKind::negate:
      return -operand(0);
    case SyntaxKind::divide:
      return operand(0) / operand(1);
    case SyntaxKind::power:
      return power_of(operand(0), operand(1));
    case SyntaxKind::add:
    case SyntaxKind::multiply:
      break;
  }
  Value total = operand(0);
  for (std::size_t i = 1; i < e.operands.size(); ++i) {
    total = e.kind == SyntaxKind::add ? total + operand(i) : total * operand(i);
  }
  return total;
}

class LineReader {
 public:
  explicit LineReader(std::string_view line) : rest_(line) {}

  Value parse_all() {
    const Value value = sum();
    skip_blanks();
    if (!rest_.empty()) fail("text is left", rest_);
    return value;
  }

 private:
  Value sum() {
    Value total = accept("-") ? -product() : product();
    for (;;) {
      if (accept("+")) {
        total += product();
      } else if (accept("-")) {
        total -= product();
      } else {
        return total;
      }
    }
  }

  Value product() {
    Value total = factor();
    for (;;) {
      if (accept("\\cdot") || accept("*")) {
        total *= factor();
      } else if (accept("/")) {
        total /= accept("-") ? -factor() : factor();
      } else if (begins_factor()) {
        total *= factor();
      } else {
        return total;
      }
    }
  }

  Value factor() {
    if (!accept("\\sin") && !accept("sin")) return power();
    const Value exponent = rest_.starts_with('^') ? exponent_value() : 1;
    if (rest_.starts_with('(') || rest_.starts_with("\\left(")) {
      return power_of(std::sin(primary()), exponent);
    }
    Value argument = power();
    while (begins_factor() && !is_next("sin") && !is_next("\\sin")) argument *= power();
    return power_of(std::sin(argument), exponent);
  }

  Value power() {
    const Value base = primary();
    return rest_.starts_with('^') ? power_of(base, exponent_value()) : base;
  }

  /// An exponent: {…}, (…), or one character.
  Value exponent_value() {
    rest_.remove_prefix(1);
    if (rest_.starts_with('{') || rest_.starts_with('(')) return primary();
    if (rest_.empty()) fail("no exponent", rest_);
    const Value value = LineReader(rest_.substr(0, 1)).parse_all();
    rest_.remove_prefix(1);
    return value;
  }

  Value primary() {
    if (accept("\\left(")) return until("\\right)");
    if (accept("(")) return until(")");
    if (accept("{")) return until("}");
    if (accept("\\sqrt{")) return root_of(until("}"));
    if (accept("sqrt(")) return root_of(until(")"));
    if (accept("\\frac{")) {
      const Value above = until("}");
      if (!accept("{")) fail("no denominator", rest_);
      return above / until("}");
    }
    skip_blanks();
    const std::size_t digits = std::min(rest_.find_first_not_of("0123456789."), rest_.size());
    const std::size_t length = digits > 0 || rest_.empty() ? digits : 1;
    if (length == 0) fail("no operand", rest_);
    const std::string text(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return digits > 0 ? Value(std::stod(text)) : value_of_symbol(text);
  }

  Value until(std::string_view end) {
    const Value value = sum();
    if (!accept(end)) fail("no " + std::string(end), rest_);
    return value;
  }

  bool begins_factor() {
    skip_blanks();
    for (const std::string_view command : {"\\left(", "\\frac{", "\\sqrt{", "\\sin"}) {
      if (is_next(command)) return true;
    }
    return !rest_.empty() &&
           (is_letter(rest_[0]) || is_digit(rest_[0]) || rest_[0] == '(' || rest_[0] == '{');
  }

  bool is_next(std::string_view word) {
    skip_blanks();
    return rest_.starts_with(word);
  }

  bool accept(std::string_view word) {
    const bool is_there = is_next(word);
    if (is_there) rest_.remove_prefix(word.size());
    return is_there;
  }

  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

  std::string_view rest_;
};

}  // namespace

Value value_of_tree(const Formula& formula) {
  const auto part = [&formula](std::size_t i) { return value_of_tree(formula.parts.at(i)); };
  const auto folded = [&formula](auto with) {
    Value total = value_of_tree(formula.parts.front());
    for (std::size_t i = 1; i < formula.parts.size(); ++i) {
      total = with(total, value_of_tree(formula.parts[i]));
    }
    return total;
  };
  switch (formula.kind) {
    case FormulaKind::number:
      return formula.text.empty() ? cln::double_approx(formula.number) : std::stod(formula.text);
    case FormulaKind::symbol:
      return value_of_symbol(text_of(formula));
    case FormulaKind::negative:
      return -part(0);
    case FormulaKind::sum:
      return folded(std::plus<>());
    case FormulaKind::product:
      return folded(std::multiplies<>());
    case FormulaKind::quotient:
      return part(0) / part(1);
    case FormulaKind::power:
      return power_of(part(0), part(1));
    case FormulaKind::root:
      return root_of(part(0));
    case FormulaKind::group:
      return part(0);
    case FormulaKind::call:
      if (formula.function == FunctionId::sin) return std::sin(part(0));
      [[fallthrough]];
    default:
      fail("no value", text_of(formula));
  }
}

Value value_of_text(const std::string& text) {
  const Result<ExpressionSyntax> syntax = parse_expression(make_source("", text), Limits{});
  if (!syntax) fail(format(syntax.diagnostics), text);
  return value_of_syntax(*syntax);
}

Value value_of_line(std::string_view line) { return LineReader(line).parse_all(); }

}  // namespace elgen::test
