// Appends operands before the nodes that use them, which the arena requires.
#include "check/expressions/node_builder.hpp"

#include <cln/real.h>

#include <utility>

#include "numbers/exact_number.hpp"

namespace elgen {

ExpressionId NodeBuilder::push(Expression node) {
  node.span = span_;
  (void)context_.append_node(std::move(node));
  return context_.last_node();
}

bool NodeBuilder::is_number(ExpressionId id, int value) const {
  const Expression& node = context_.model.expressions[id];
  return node.kind == ExpressionKind::number && node.number == value;
}

ExpressionId NodeBuilder::number(const cln::cl_RA& value) {
  if (cln::zerop(value)) return no_expression;
  return push({.number = value});
}

ExpressionId NodeBuilder::leaf(Opcode kind, std::uint32_t index) {
  return push({.kind = ExpressionKind::leaf, .leaf = kind, .index = index});
}

ExpressionId NodeBuilder::name_node(NamedKind kind, std::uint32_t index, std::uint32_t component) {
  return push(
      {.kind = ExpressionKind::named, .named = kind, .index = index, .component = component});
}

ExpressionId NodeBuilder::negate(ExpressionId a) {
  if (is_number(a, 0)) return a;
  const Expression& operand = context_.model.expressions[a];
  if (operand.kind == ExpressionKind::negate) return operand.operands.front();
  return push({.kind = ExpressionKind::negate, .operands = {a}});
}

ExpressionId NodeBuilder::add(const std::vector<ExpressionId>& terms) {
  Expression node;
  node.kind = ExpressionKind::add;
  for (const ExpressionId term : terms) {
    if (!is_number(term, 0)) node.operands.push_back(term);
  }
  if (node.operands.empty()) return no_expression;
  return node.operands.size() == 1 ? node.operands.front() : push(std::move(node));
}

ExpressionId NodeBuilder::subtract(ExpressionId a, ExpressionId b) {
  const ExpressionId minus_b = negate(b);
  return add({a, minus_b});
}

ExpressionId NodeBuilder::multiply(const std::vector<ExpressionId>& factors) {
  Expression node;
  node.kind = ExpressionKind::multiply;
  bool negative = false;
  for (const ExpressionId factor : factors) {
    if (is_number(factor, 0)) return no_expression;
    negative = negative != is_number(factor, -1);
    if (!is_number(factor, 1) && !is_number(factor, -1)) node.operands.push_back(factor);
  }
  ExpressionId product = no_expression;
  if (node.operands.empty()) {
    product = number(1);
  } else {
    product = node.operands.size() == 1 ? node.operands.front() : push(std::move(node));
  }
  return negative ? negate(product) : product;
}

ExpressionId NodeBuilder::divide(ExpressionId a, ExpressionId b) {
  if (is_number(a, 0) || is_number(b, 1)) return a;
  return push({.kind = ExpressionKind::divide, .operands = {a, b}});
}

ExpressionId NodeBuilder::power(ExpressionId base, const cln::cl_RA& exponent) {
  return push({.kind = ExpressionKind::power, .number = exponent, .operands = {base}});
}

ExpressionId NodeBuilder::call(FunctionId function, ExpressionId argument) {
  const ExpressionId id =
      push({.kind = ExpressionKind::function, .function = function, .operands = {argument}});
  const auto& value = context_.constants[id];
  if (!value) return id;
  // CLN computes sin(k pi/2) as a float of 100 digits, although the exact value is -1, 0 or 1.
  const cln::cl_I nearest = cln::round1(*value);
  if (cln::abs(*value - nearest) >= power_of_ten(5 - constant_digits)) return id;
  return number(nearest);
}

ExpressionId NodeBuilder::stumpff(ExpressionId argument, int order) {
  const ExpressionId k = number(order);
  return push({.kind = ExpressionKind::function,
               .function = FunctionId::stumpff,
               .operands = {argument, k}});
}

ExpressionId NodeBuilder::rate(ExpressionId a) {
  if (context_.constants[a]) return no_expression;
  const Expression& node = context_.model.expressions[a];
  if (is_leaf(node, Opcode::coordinate)) {
    const Coordinate& coordinate = context_.model.coordinates[node.index];
    if (!coordinate.rotation) return leaf(Opcode::velocity, coordinate.velocity);
  }
  return push({.kind = ExpressionKind::time_derivative, .operands = {a}});
}

ExpressionId NodeBuilder::dot(const Vector3& a, const Vector3& b) {
  std::vector<ExpressionId> terms;
  for (std::size_t i = 0; i < 3; ++i) terms.push_back(multiply({a[i], b[i]}));
  return add(terms);
}

Vector3 NodeBuilder::add(const Vector3& a, const Vector3& b) {
  Vector3 sum{};
  for (std::size_t i = 0; i < 3; ++i) sum[i] = add({a[i], b[i]});
  return sum;
}

Vector3 NodeBuilder::apply(const Matrix3& m, const Vector3& x) {
  Vector3 result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = dot({m[3 * i], m[3 * i + 1], m[3 * i + 2]}, x);
  return result;
}

Vector3 NodeBuilder::apply_transposed(const Matrix3& m, const Vector3& x) {
  Vector3 result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = dot({m[i], m[3 + i], m[6 + i]}, x);
  return result;
}

Matrix3 NodeBuilder::multiply(const Matrix3& a, const Matrix3& b) {
  Matrix3 product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      product[3 * i + j] = dot({a[3 * i], a[3 * i + 1], a[3 * i + 2]}, {b[j], b[3 + j], b[6 + j]});
    }
  }
  return product;
}

Matrix3 NodeBuilder::identity() {
  const ExpressionId one = number(1);
  return {one,           no_expression, no_expression,
          no_expression, one,           no_expression,
          no_expression, no_expression, one};
}

Matrix3 frame_rotation_matrix(NodeBuilder& nodes, std::uint32_t frame) {
  Matrix3 result{};
  for (std::uint32_t k = 0; k < 9; ++k) {
    result[k] = nodes.name_node(NamedKind::frame, frame, k);
  }
  return result;
}

Vector3 frame_vector(NodeBuilder& nodes, std::uint32_t frame, FrameComponent first) {
  Vector3 result{};
  for (std::uint32_t k = 0; k < 3; ++k) {
    result[k] = nodes.name_node(NamedKind::frame, frame, first + k);
  }
  return result;
}

Vector3 change_axes(NodeBuilder& nodes, const Vector3& x, std::optional<std::uint32_t> from,
                    std::optional<std::uint32_t> to) {
  if (from == to) return x;
  Vector3 result = x;
  if (from) result = nodes.apply(frame_rotation_matrix(nodes, *from), result);
  if (to) result = nodes.apply_transposed(frame_rotation_matrix(nodes, *to), result);
  return result;
}

}  // namespace elgen
