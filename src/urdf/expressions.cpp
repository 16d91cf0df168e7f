// Sums and products of short expressions.
#include "expressions.hpp"

#include <fmt/format.h>

namespace elgen::urdf {

namespace {

/// A sum where it is a factor stands in brackets.
std::string as_factor(const std::string& expression) {
  const bool is_sum = expression.find(' ') != std::string::npos || expression.front() == '-';
  return is_sum ? "(" + expression + ")" : expression;
}

}  // namespace

std::string sum(const std::string& left, const std::string& right) {
  if (left == "0") return right;
  if (right == "0") return left;
  if (right.front() == '-') return left + " - " + right.substr(1);
  return left + " + " + right;
}

std::string negated(const std::string& expression) {
  if (expression == "0") return expression;
  const bool is_sum = expression.find(' ') != std::string::npos;
  if (!is_sum && expression.front() == '-') return expression.substr(1);
  return "-" + (is_sum ? as_factor(expression) : expression);
}

std::string product(const std::string& factor, const std::string& expression) {
  if (factor == "0" || expression == "0") return "0";
  if (factor == "1") return expression;
  if (factor == "-1") return negated(expression);
  return factor + "*" + as_factor(expression);
}

std::string Coupling::position() const { return sum(product(factor, coordinate), offset); }

std::string Coupling::rate() const { return product(factor, fmt::format("dot({})", coordinate)); }

}  // namespace elgen::urdf
