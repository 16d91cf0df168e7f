// Sums, products and quotients of short expressions.
#include "urdf/expressions.hpp"

#include <fmt/format.h>

namespace elgen::urdf {

namespace {

std::string in_brackets(const std::string& expression) { return "(" + expression + ")"; }

/// Blanks stand around the signs of a sum only; those within brackets are of another one.
bool is_sum(const std::string& expression) {
  int depth = 0;
  for (const char c : expression) {
    depth += (c == '(' ? 1 : 0) - (c == ')' ? 1 : 0);
    if (c == ' ' && depth == 0) return true;
  }
  return false;
}

std::string as_factor(const std::string& expression) {
  return is_sum(expression) || expression.front() == '-' ? in_brackets(expression) : expression;
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
  if (is_sum(expression)) return "-" + in_brackets(expression);
  return expression.front() == '-' ? expression.substr(1) : "-" + expression;
}

std::string product(const std::string& factor, const std::string& expression) {
  if (factor == "0" || expression == "0") return "0";
  if (factor == "1") return expression;
  if (factor == "-1") return negated(expression);
  if (expression == "1") return factor;
  if (expression == "-1") return negated(factor);
  return factor + "*" + as_factor(expression);
}

std::string quotient(const std::string& expression, const std::string& divisor) {
  if (expression == "0" || divisor == "1") return expression;
  return (is_sum(expression) ? in_brackets(expression) : expression) + "/" + divisor;
}

std::string Coupling::position() const { return sum(product(factor, coordinate), offset); }

std::string Coupling::rate() const { return product(factor, fmt::format("dot({})", coordinate)); }

}  // namespace elgen::urdf
