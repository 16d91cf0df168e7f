// The graph gives a constant the form that it had when it was printed.
#include "support/constant_reader.hpp"

#include <cln/integer.h>

#include "lower/graph/graph.hpp"
#include "parse/expression_parser.hpp"

namespace elgen::test {
namespace {

using Read = std::optional<Ref>;

Read read(Graph& graph, const ExpressionSyntax& syntax);

std::optional<std::vector<Ref>> read_all(Graph& graph, const std::vector<ExpressionSyntax>& all) {
  std::vector<Ref> values;
  for (const ExpressionSyntax& one : all) {
    const Read value = read(graph, one);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

Read read_call(Graph& graph, const std::string& name, const std::vector<Ref>& arguments) {
  if (name == "sqrt" && arguments.size() == 1) return graph.square_root(arguments.front());
  const FunctionRow* row = find_function(name);
  const bool is_known = row != nullptr && row->arity == arguments.size();
  return is_known ? Read(graph.call(row->id, arguments)) : std::nullopt;
}

Read read_power(Graph& graph, Ref base, Ref exponent) {
  if (!graph.is_rational(exponent.node)) return std::nullopt;
  const cln::cl_RA& value = graph.rational_of(exponent.node);
  const bool is_small = cln::denominator(value) == 1 && value <= 1'000'000;
  if (!is_small || graph.is_zero(base.node)) return std::nullopt;
  const auto magnitude = static_cast<std::int32_t>(cln::cl_I_to_long(cln::numerator(value)));
  return graph.product({{base, exponent.negative ? -magnitude : magnitude}});
}

Read read_product(Graph& graph, const std::vector<Ref>& factors) {
  std::vector<Power> powers;
  for (const Ref factor : factors) powers.push_back({factor});
  return graph.product(powers);
}

Read read(Graph& graph, const ExpressionSyntax& syntax) {
  const auto operands = read_all(graph, syntax.operands);
  if (!operands) return std::nullopt;
  switch (syntax.kind) {
    case SyntaxKind::number:
      return graph.rational(syntax.value);
    case SyntaxKind::name:
      return syntax.text == "pi" ? Read(graph.pi()) : std::nullopt;
    case SyntaxKind::negate:
      return -operands->front();
    case SyntaxKind::add:
      return graph.sum(*operands);
    case SyntaxKind::multiply:
      return read_product(graph, *operands);
    case SyntaxKind::divide:
      if (graph.is_zero(operands->back().node)) return std::nullopt;
      return graph.product({{operands->front(), 1}, {operands->back(), -1}});
    case SyntaxKind::power:
      return read_power(graph, operands->front(), operands->back());
    case SyntaxKind::call:
      return read_call(graph, syntax.text, *operands);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Constant> read_constant(const std::string& text) {
  Limits limits;
  limits.expression_depth = deepest_expression;
  limits.literal_digits = text.size();
  const Result<ExpressionSyntax> syntax = parse_expression(make_source("constant", text), limits);
  if (!syntax) return std::nullopt;
  Graph graph;
  const Read value = read(graph, *syntax);
  if (!value || !graph.has_form(value->node)) return std::nullopt;
  return constant_of(graph.form_of(*value));
}

}  // namespace elgen::test
