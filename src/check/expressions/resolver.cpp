// Resolver: operators and numbers. resolve_name.cpp has the names, resolve_call.cpp the calls.
#include "check/expressions/resolver.hpp"

#include <cln/real_ring.h>

#include <algorithm>
#include <utility>

namespace elgen {
namespace {

ExpressionKind kind_of(SyntaxKind kind) {
  switch (kind) {
    case SyntaxKind::negate:
      return ExpressionKind::negate;
    case SyntaxKind::add:
      return ExpressionKind::add;
    case SyntaxKind::multiply:
      return ExpressionKind::multiply;
    default:
      return ExpressionKind::divide;
  }
}

/// The product of nested exponents: 6 for (x^2)^3, 1 for a node that is no power.
cln::cl_RA exponent_of(const Model& model, ExpressionId id) {
  cln::cl_RA product = 1;
  while (model.expressions[id].kind == ExpressionKind::power) {
    product = product * model.expressions[id].number;
    id = model.expressions[id].operands.front();
  }
  return product;
}

}  // namespace

std::optional<ExpressionId> Resolver::resolve(const ExpressionSyntax& expression) {
  if (!check_node_limit(expression.span)) return std::nullopt;
  switch (expression.kind) {
    case SyntaxKind::number:
      return push_number(expression.value, expression.span);
    case SyntaxKind::name:
      return resolve_name(expression);
    case SyntaxKind::call:
      return resolve_call(expression);
    case SyntaxKind::power:
      return resolve_power(expression);
    default:
      return resolve_operation(expression);
  }
}

bool Resolver::check_node_limit(const Span& span) {
  const std::uint64_t limit = context_.node_limit;
  if (++steps_ <= limit && context_.model.expressions.size() < limit &&
      !context_.is_beyond_limits) {
    return true;
  }
  if (std::exchange(context_.is_beyond_limits, true)) return false;
  context_.report.add(
      Code::E908, span,
      "the expressions have more than " + std::to_string(limit) + " nodes after repetition");
  return false;
}

std::optional<Resolver::Operands> Resolver::resolve_operands(
    const std::vector<ExpressionSyntax>& expressions) {
  Operands result;
  bool complete = true;
  for (const ExpressionSyntax& expression : expressions) {
    const std::optional<ExpressionId> id = resolve(expression);
    complete = complete && id;
    result.push_back(id.value_or(0));
  }
  return complete ? std::optional(std::move(result)) : std::nullopt;
}

std::optional<ExpressionId> Resolver::push(Expression expression) {
  if (const auto failure = context_.append_node(std::move(expression))) {
    report_failure(*failure, context_.model.expressions.back());
    return std::nullopt;
  }
  return context_.last_node();
}

void Resolver::report_failure(const ConstantFailure& failure, const Expression& node) {
  const bool at_operand = failure.operand && *failure.operand < node.operands.size();
  const Span span =
      at_operand ? context_.model.expressions[node.operands[*failure.operand]].span : node.span;
  context_.report.add(failure.code, span, in_backticks(span) + " " + failure.message);
}

std::optional<ExpressionId> Resolver::push_number(const cln::cl_RA& number, const Span& span) {
  return push({.number = number, .span = span});
}

std::optional<ExpressionId> Resolver::push_leaf(Opcode kind, std::uint32_t index,
                                                const Span& span) {
  return push({.kind = ExpressionKind::leaf, .leaf = kind, .index = index, .span = span});
}

std::optional<ExpressionId> Resolver::resolve_operation(const ExpressionSyntax& operation) {
  std::optional<Operands> operands = resolve_operands(operation.operands);
  if (!operands) return std::nullopt;
  return push(
      {.kind = kind_of(operation.kind), .operands = std::move(*operands), .span = operation.span});
}

std::optional<ExpressionId> Resolver::resolve_power(const ExpressionSyntax& power) {
  const std::optional<ExpressionId> base = resolve(power.operands[0]);
  if (!base) return std::nullopt;
  const std::optional<cln::cl_RA> exponent = resolve_exponent(power.operands[1]);
  if (!exponent || !check_exponent(*exponent, power.operands[1].span)) return std::nullopt;
  // (x^a)^b is the power x^(a b), so the product must be within the limit too.
  const cln::cl_RA product = *exponent * exponent_of(context_.model, *base);
  if (product != *exponent && !check_exponent(product, power.span)) return std::nullopt;
  return push({.kind = ExpressionKind::power,
               .number = *exponent,
               .operands = {*base},
               .span = power.span});
}

/// The value of a constant exponent, whose nodes are removed again; none after an error. For x^y^z,
/// E311 is reported once: y^z is not constant.
std::optional<cln::cl_RA> Resolver::resolve_exponent(const ExpressionSyntax& exponent) {
  std::vector<Expression>& arena = context_.model.expressions;
  const std::size_t size = arena.size();
  Report outer = std::exchange(context_.report, Report{});
  const std::optional<ExpressionId> id = resolve(exponent);
  const Report inner = std::exchange(context_.report, std::move(outer));
  std::optional<cln::cl_RA> value;
  if (id && arena[*id].kind == ExpressionKind::number) value = arena[*id].number;
  context_.truncate(size);

  const Diagnostics errors = inner.sorted_diagnostics();
  const auto is_variable = [](const Diagnostic& error) { return error.code == Code::E311; };
  if (id ? !value.has_value() : std::ranges::any_of(errors, is_variable)) {
    context_.report.add(Code::E311, exponent.span,
                        in_backticks(exponent.span) + " is not a rational constant",
                        "write exp(y*log(x)) for x^y");
    return std::nullopt;
  }
  for (const Diagnostic& error : errors) context_.report.add(error);
  return value;
}

bool Resolver::check_exponent(const cln::cl_RA& exponent, const Span& span) {
  const auto largest = static_cast<unsigned long>(context_.limits.integer_power);
  const cln::cl_I limit(largest);
  if (cln::abs(cln::numerator(exponent)) <= limit && cln::denominator(exponent) <= limit) {
    return true;
  }
  context_.report.add(Code::E905, span,
                      in_backticks(span) + " is beyond the limit " + std::to_string(largest));
  return false;
}

}  // namespace elgen
