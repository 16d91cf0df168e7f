// StateFunction: evaluates the nodes of an expression, operands first.
#include "run/steps/state_function.hpp"

#include <limits>
#include <numbers>

#include "elgen/references.hpp"

namespace elgen {
namespace {

/// True for a number, which the constructor rounds, so that calls do not evaluate it again.
bool is_number(const Expression& node) { return node.kind == ExpressionKind::number; }

}  // namespace

StateFunction::StateFunction(const Model& model, ExpressionId root, const Arguments<double>& others)
    : model_(model),
      others_(others),
      order_(reachable_expressions(model, {root})),
      known_(model.expressions.size()) {
  for (const ExpressionId id : order_) {
    const Expression& node = model.expressions[id];
    if (is_number(node)) known_[id] = {to_double(node.number), 0};
  }
  result_ = order_.back();
  std::erase_if(order_, [&model](ExpressionId id) { return is_number(model.expressions[id]); });
}

double StateFunction::operator()(const double* q, const double* v, double t) {
  q_ = q;
  v_ = v;
  t_ = t;
  for (const ExpressionId id : order_) known_[id] = node_value(model_.expressions[id], id);
  return known_[result_].value;
}

StateFunction::ValueWithRate StateFunction::node_value(const Expression& node,
                                                       ExpressionId id) const {
  const auto operand = [&](std::size_t i) { return known_[node.operands[i]]; };
  switch (node.kind) {
    case ExpressionKind::named:
      return known_[references(model_, id).front()];
    case ExpressionKind::negate:
      return -operand(0);
    case ExpressionKind::add: {
      ValueWithRate sum;
      for (const ExpressionId each : node.operands) sum = sum + known_[each];
      return sum;
    }
    case ExpressionKind::multiply: {
      ValueWithRate product{1, 0};
      for (const ExpressionId each : node.operands) product = product * known_[each];
      return product;
    }
    case ExpressionKind::divide:
      return operand(0) / operand(1);
    case ExpressionKind::power:
      return power(operand(0), to_double(node.number));
    case ExpressionKind::function:
      return interpreter::call(node.function, known_[node.operands.front()],
                               known_[node.operands.back()]);
    case ExpressionKind::time_derivative:
      return {operand(0).slope, std::numeric_limits<double>::quiet_NaN()};
    default:
      return leaf_value(node);
  }
}

StateFunction::ValueWithRate StateFunction::leaf_value(const Expression& node) const {
  if (node.kind == ExpressionKind::pi) return {std::numbers::pi, 0};
  if (node.leaf == Opcode::time) return {t_, 1};
  if (node.leaf == Opcode::coordinate) return coordinate_value(node.index);
  if (node.leaf == Opcode::velocity) return {v_[node.index], others_.a[node.index]};
  const bool is_constant = leaf_row(node.leaf).owner == LeafOwner::parameters;
  return {leaf_of(others_, node.leaf, node.index),
          is_constant ? 0 : std::numeric_limits<double>::quiet_NaN()};
}

/// The coordinate and its rate. For a quaternion e, e' = 1/2 e w, w the angular velocity as a pure
/// quaternion; the rate of any other coordinate is its velocity.
StateFunction::ValueWithRate StateFunction::coordinate_value(std::uint32_t index) const {
  const Coordinate& coordinate = model_.coordinates[index];
  if (!coordinate.rotation) return {q_[index], v_[coordinate.velocity]};
  const Rotation& rotation = model_.rotations[*coordinate.rotation];
  const double* const e = q_ + rotation.first_coordinate;
  const double* const w = v_ + rotation.first_velocity;
  const double rates[] = {
      -e[1] * w[0] - e[2] * w[1] - e[3] * w[2], e[0] * w[0] + e[2] * w[2] - e[3] * w[1],
      e[0] * w[1] + e[3] * w[0] - e[1] * w[2], e[0] * w[2] + e[1] * w[1] - e[2] * w[0]};
  return {q_[index], rates[index - rotation.first_coordinate] / 2};
}

StateFunction::ValueWithRate StateFunction::power(const ValueWithRate& base,
                                                  double exponent) const {
  const double slope = exponent * std::pow(base.value, exponent - 1);
  return {std::pow(base.value, exponent), base.slope == 0 ? 0 : slope * base.slope};
}

}  // namespace elgen
