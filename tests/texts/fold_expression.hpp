// fold_expression: evaluates an equation from a file that elgen wrote, with values of any type.
//
//     m*dot(x)^2   ->   multiply(named("m"), multiply(named("dot(x)"), named("dot(x)")))
//
// `Rules` has a type Value and the functions number(q), named(text), negate(x), add(x, y),
// multiply(x, y), divide(x, y), square_root(x), call(row, x, y) with y = x for functions of one
// argument, and fail(problem), which returns the Value of an expression without a value.
#pragma once

#include <cln/integer.h>
#include <fmt/format.h>

#include <string>

#include "elgen/functions.hpp"
#include "elgen/syntax.hpp"
#include "elgen/wording.hpp"
#include "numbers/exact_number.hpp"

namespace elgen::test {

/// The name of the leaf `e`: "theta", "l[2]", "dot(dot(x))". Empty if `e` is no leaf.
[[nodiscard]] inline std::string leaf_name(const ExpressionSyntax& e) {
  if (e.kind == SyntaxKind::name) {
    if (e.operands.empty()) return e.text;
    const ExpressionSyntax& index = e.operands.front();
    return fmt::format("{}[{}]", e.text,
                       index.kind == SyntaxKind::number ? exact_text(index.value) : "");
  }
  const bool is_wrapped = e.kind == SyntaxKind::call && e.operands.size() == 1;
  return is_wrapped ? fmt::format("{}({})", e.text, leaf_name(e.operands.front())) : "";
}

template <class Rules>
class ExpressionFold {
 public:
  using Value = typename Rules::Value;

  explicit ExpressionFold(Rules& rules) : rules_(rules) {}

  [[nodiscard]] Value operator()(const ExpressionSyntax& e) {
    switch (e.kind) {
      case SyntaxKind::number:
        return rules_.number(e.value);
      case SyntaxKind::name:
        return rules_.named(leaf_name(e));
      case SyntaxKind::call:
        return call(e);
      case SyntaxKind::negate:
        return rules_.negate((*this)(e.operands[0]));
      case SyntaxKind::divide: {
        const Value x = (*this)(e.operands[0]);
        return rules_.divide(x, (*this)(e.operands[1]));
      }
      case SyntaxKind::power:
        return power(e);
      default:
        return all(e);
    }
  }

 private:
  static constexpr long largest_power = 10'000;

  /// The value of a sum or a product.
  Value all(const ExpressionSyntax& e) {
    Value total = (*this)(e.operands[0]);
    for (std::size_t i = 1; i < e.operands.size(); ++i) {
      const Value x = (*this)(e.operands[i]);
      total = e.kind == SyntaxKind::add ? rules_.add(total, x) : rules_.multiply(total, x);
    }
    return total;
  }

  /// The value of a power with an integer exponent; roots are written as `sqrt`.
  Value power(const ExpressionSyntax& e) {
    const ExpressionSyntax& written = e.operands[1];
    const bool is_negative = written.kind == SyntaxKind::negate;
    const ExpressionSyntax& exponent = is_negative ? written.operands.front() : written;
    const bool is_integer = exponent.kind == SyntaxKind::number &&
                            cln::denominator(exponent.value) == 1 &&
                            exponent.value <= largest_power;
    if (!is_integer) return rules_.fail("an exponent that is no integer");
    const Value base = (*this)(e.operands[0]);
    const long count = cln::cl_I_to_long(cln::numerator(exponent.value));
    Value product = count > 0 ? base : rules_.number(1);
    for (long i = 1; i < count; ++i) product = rules_.multiply(product, base);
    return is_negative ? rules_.divide(rules_.number(1), product) : product;
  }

  Value call(const ExpressionSyntax& e) {
    if (e.text == "sinc" || e.text == "cosc") {
      const int order = e.text == "sinc" ? 1 : 2;
      return rules_.call(function_row(FunctionId::stumpff), (*this)(e.operands[0]),
                         rules_.number(order));
    }
    const bool is_root = e.text == "sqrt";
    const FunctionRow* const row = find_function(e.text);
    if (!is_root && row == nullptr) return rules_.named(leaf_name(e));
    if (e.operands.size() != (is_root ? 1 : row->arity)) {
      return rules_.fail(quote_text(e.text) + " is no function of so many arguments");
    }
    const Value x = (*this)(e.operands[0]);
    if (is_root) return rules_.square_root(x);
    return rules_.call(*row, x, row->arity > 1 ? (*this)(e.operands[1]) : x);
  }

  Rules& rules_;
};

template <class Rules>
[[nodiscard]] typename Rules::Value fold_expression(const ExpressionSyntax& e, Rules rules) {
  return ExpressionFold<Rules>(rules)(e);
}

/// Limits that allow the longest sums and products that elgen writes.
[[nodiscard]] inline Limits written_limits() {
  Limits limits;
  limits.expression_depth = 1000;
  limits.literal_digits = 5000;
  return limits;
}

}  // namespace elgen::test
