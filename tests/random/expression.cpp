// Builds, prints and evaluates expressions of random models.
#include "random/expression.hpp"

#include <algorithm>
#include <stdexcept>

namespace elgen::test::random {

namespace {

constexpr int lowest_binding = 1;
constexpr int product_binding = 2;
constexpr int power_binding = 3;
constexpr int tightest_binding = 4;

int binding(const Node& node) {
  switch (node.kind) {
    case NodeKind::addition:
    case NodeKind::subtraction:
    case NodeKind::negation:
      return lowest_binding;
    case NodeKind::multiplication:
    case NodeKind::division:
      return product_binding;
    case NodeKind::power:
      return power_binding;
    default:
      return tightest_binding;
  }
}

/// The printed expression, in brackets if the expression binds less than `least`.
std::string placed(const Expression& expression, int least) {
  const std::string text = printed(expression);
  return binding(*expression) < least ? "(" + text + ")" : text;
}

std::string printed_binary(const Node& node, const char* sign, int left, int right) {
  return placed(node.operands[0], left) + sign + placed(node.operands[1], right);
}

std::string printed_call(const std::string& function, const std::vector<Expression>& arguments) {
  std::string text = function + "(";
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    text += (i > 0 ? ", " : "") + printed(arguments[i]);
  }
  return text + ")";
}

std::string printed_exponent(const Node& node) {
  const std::string text = std::to_string(node.first);
  if (node.second == 1) return node.first < 0 ? "(" + text + ")" : text;
  return "(" + text + "/" + std::to_string(node.second) + ")";
}

std::string printed_leaf(const Node& node) {
  switch (node.kind) {
    case NodeKind::pi:
      return "pi";
    case NodeKind::time:
      return "t";
    case NodeKind::component:
      return std::string(1, "xyz"[node.first]) + "(" + indexed(node.text, node.element) + ")";
    case NodeKind::speed:
      return "v2(" + indexed(node.text, node.element) + ")";
    case NodeKind::distance:
      return "dist2(" + node.text + ", " + node.other + ")";
    case NodeKind::turning:
      return std::string("w") + "xyz"[node.first] + "(" + node.text +
             (node.other.empty() ? "" : ", " + node.other) + ")";
    default:
      return indexed(node.text, node.element);
  }
}

Expression binary(NodeKind kind, Expression a, Expression b) {
  return made({.kind = kind, .operands = {std::move(a), std::move(b)}});
}

std::string resolved(const Node& node, const Scope& scope) {
  const auto index = scope.indices.find(node.element);
  return index == scope.indices.end() ? node.element : std::to_string(index->second);
}

Vector position_of(const std::string& point, const std::string& element, Scope& scope) {
  Vector position;
  for (int axis = 0; axis < scope.dimension_of(point); ++axis) {
    position.push_back(scope.component_of(point, element, axis));
  }
  return position;
}

Jet speed_of(const Node& node, Scope& scope) {
  Jet sum;
  for (const Jet& x : position_of(node.text, resolved(node, scope), scope)) {
    const Jet rate = x.along(time_infinitesimal);
    sum += rate * rate;
  }
  return sum;
}

Jet distance_of(const Node& node, Scope& scope) {
  const Vector a = position_of(node.text, "", scope);
  const Vector b = position_of(node.other, "", scope);
  Jet sum;
  for (std::size_t axis = 0; axis < a.size(); ++axis) {
    sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  }
  return sum;
}

Jet summed(const Node& node, Scope& scope) {
  Jet sum;
  for (int i = node.first; i <= node.second; ++i) {
    scope.indices[node.text] = i;
    sum += evaluated(node.operands[0], scope);
  }
  scope.indices.erase(node.text);
  return sum;
}

Jet leaf_value(const Node& node, Scope& scope) {
  switch (node.kind) {
    case NodeKind::number:
      return Number(node.text);
    case NodeKind::pi:
      return pi();
    case NodeKind::time:
      return scope.now();
    case NodeKind::index:
      return scope.indices.at(node.text);
    case NodeKind::component:
      return scope.component_of(node.text, resolved(node, scope), node.first);
    case NodeKind::speed:
      return speed_of(node, scope);
    case NodeKind::distance:
      return distance_of(node, scope);
    case NodeKind::turning:
      return scope.turning_of(node.text, node.other).at(static_cast<std::size_t>(node.first));
    default:
      return scope.value_of(node.text, resolved(node, scope));
  }
}

}  // namespace

std::string indexed(const std::string& name, const std::string& element) {
  return element.empty() ? name : name + "[" + element + "]";
}

Expression made(Node node) { return std::make_shared<const Node>(std::move(node)); }

Expression number(const std::string& literal) {
  return made({.kind = NodeKind::number, .text = literal});
}
Expression number(int value) {
  return value < 0 ? -number(std::to_string(-value)) : number(std::to_string(value));
}
Expression name(const std::string& text, const std::string& element) {
  return made({.kind = NodeKind::name, .text = text, .element = element});
}
Expression constant_pi() { return made({.kind = NodeKind::pi}); }
Expression time() { return made({.kind = NodeKind::time}); }
Expression component(const std::string& point, int axis, const std::string& element) {
  return made({.kind = NodeKind::component, .text = point, .element = element, .first = axis});
}
Expression rate(Expression operand) {
  return made({.kind = NodeKind::rate, .operands = {std::move(operand)}});
}
Expression turning(const std::string& frame, const std::string& axes, int axis) {
  return made({.kind = NodeKind::turning, .text = frame, .other = axes, .first = axis});
}
Expression call_of(const std::string& function, std::vector<Expression> arguments) {
  return made({.kind = NodeKind::call, .text = function, .operands = std::move(arguments)});
}
Expression raised(Expression base, int numerator, int denominator) {
  return made({.kind = NodeKind::power,
               .first = numerator,
               .second = denominator,
               .operands = {std::move(base)}});
}
Expression sum_over(const std::string& variable, int from, int to, Expression body) {
  return made({.kind = NodeKind::sum,
               .text = variable,
               .first = from,
               .second = to,
               .operands = {std::move(body)}});
}

Expression operator+(Expression a, Expression b) {
  return binary(NodeKind::addition, std::move(a), std::move(b));
}
Expression operator-(Expression a, Expression b) {
  return binary(NodeKind::subtraction, std::move(a), std::move(b));
}
Expression operator*(Expression a, Expression b) {
  return binary(NodeKind::multiplication, std::move(a), std::move(b));
}
Expression operator/(Expression a, Expression b) {
  return binary(NodeKind::division, std::move(a), std::move(b));
}
Expression operator-(Expression a) {
  return made({.kind = NodeKind::negation, .operands = {std::move(a)}});
}

std::string printed(const Expression& expression) {
  const Node& node = *expression;
  switch (node.kind) {
    case NodeKind::negation:
      return "-" + placed(node.operands[0], product_binding);
    case NodeKind::addition:
      return placed(node.operands[0], lowest_binding) + " + " +
             placed(node.operands[1], product_binding);
    case NodeKind::subtraction:
      return printed_binary(node, " - ", lowest_binding, product_binding);
    case NodeKind::multiplication:
      return printed_binary(node, "*", product_binding, product_binding + 1);
    case NodeKind::division:
      return printed_binary(node, "/", product_binding, product_binding + 1);
    case NodeKind::power:
      return placed(node.operands[0], tightest_binding) + "^" + printed_exponent(node);
    case NodeKind::rate:
      return printed_call("dot", node.operands);
    case NodeKind::call:
      return printed_call(node.text, node.operands);
    case NodeKind::sum:
      return "sum(" + node.text + ", " + std::to_string(node.first) + ", " +
             std::to_string(node.second) + ", " + printed(node.operands[0]) + ")";
    default:
      return printed_leaf(node);
  }
}

bool has_names(const Expression& expression) {
  const Node& node = *expression;
  const bool is_constant = node.kind == NodeKind::number || node.kind == NodeKind::pi;
  if (node.operands.empty()) return !is_constant;
  return std::any_of(node.operands.begin(), node.operands.end(), has_names);
}

Jet evaluated(const Expression& expression, Scope& scope) {
  const Node& node = *expression;
  if (node.kind == NodeKind::sum) return summed(node, scope);
  const Vector operands = evaluated(node.operands, scope);
  switch (node.kind) {
    case NodeKind::rate:
      return operands[0].along(time_infinitesimal);
    case NodeKind::negation:
      return -operands[0];
    case NodeKind::addition:
      return operands[0] + operands[1];
    case NodeKind::subtraction:
      return operands[0] - operands[1];
    case NodeKind::multiplication:
      return operands[0] * operands[1];
    case NodeKind::division:
      return operands[0] / operands[1];
    case NodeKind::power:
      return power(operands[0], node.first, node.second);
    case NodeKind::call:
      return call(node.text, operands);
    default:
      return leaf_value(node, scope);
  }
}

Vector evaluated(const std::vector<Expression>& expressions, Scope& scope) {
  Vector values;
  for (const Expression& expression : expressions) values.push_back(evaluated(expression, scope));
  return values;
}

}  // namespace elgen::test::random
