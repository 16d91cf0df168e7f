// graph_reader: each syntax node becomes a graph node, but powers become factors of the product
// around them.
#include "program/graph/graph_reader.hpp"

#include <cln/integer.h>

#include <algorithm>

#include "elgen/syntax.hpp"

namespace elgen {
namespace {

using OptionalNode = std::optional<SignedNode>;

class GraphReader {
 public:
  GraphReader(Graph& graph, const std::vector<std::string>& coordinates)
      : graph_(graph), coordinates_(coordinates) {}

  OptionalNode read_expression(const ExpressionSyntax& syntax) {
    if (syntax.kind == SyntaxKind::multiply) return read_product(syntax.operands);
    if (syntax.kind == SyntaxKind::power) return read_product({syntax});
    const auto operands = read_all(syntax.operands);
    if (!operands) return std::nullopt;
    switch (syntax.kind) {
      case SyntaxKind::number:
        return graph_.rational(syntax.value);
      case SyntaxKind::name:
        return read_leaf(syntax.text);
      case SyntaxKind::negate:
        return -operands->front();
      case SyntaxKind::add:
        return graph_.sum(*operands);
      case SyntaxKind::divide:
        if (graph_.is_zero(operands->back().node)) return std::nullopt;
        return graph_.product({{operands->front(), 1}, {operands->back(), -1}});
      case SyntaxKind::call:
        return read_call(syntax.text, *operands);
      default:
        return std::nullopt;
    }
  }

 private:
  std::optional<std::vector<SignedNode>> read_all(const std::vector<ExpressionSyntax>& all) {
    std::vector<SignedNode> values;
    for (const ExpressionSyntax& one : all) {
      const OptionalNode value = read_expression(one);
      if (!value) return std::nullopt;
      values.push_back(*value);
    }
    return values;
  }

  OptionalNode read_leaf(const std::string& name) {
    if (name == "pi") return graph_.pi();
    const auto found = std::find(coordinates_.begin(), coordinates_.end(), name);
    if (found == coordinates_.end()) return std::nullopt;
    return graph_.leaf(Opcode::coordinate,
                       static_cast<std::uint32_t>(found - coordinates_.begin()));
  }

  OptionalNode read_call(const std::string& name, const std::vector<SignedNode>& arguments) {
    if (name == "sqrt" && arguments.size() == 1) return graph_.square_root(arguments.front());
    const FunctionRow* row = find_function(name);
    const bool is_known = row != nullptr && row->arity == arguments.size();
    return is_known ? OptionalNode(graph_.call(row->id, arguments)) : std::nullopt;
  }

  std::optional<Power> read_factor(const ExpressionSyntax& syntax) {
    const bool is_power = syntax.kind == SyntaxKind::power;
    const OptionalNode base = read_expression(is_power ? syntax.operands.front() : syntax);
    if (!base || !is_power) return base ? std::optional(Power{*base}) : std::nullopt;
    const OptionalNode exponent = read_expression(syntax.operands.back());
    if (!exponent || !graph_.is_rational(exponent->node)) return std::nullopt;
    const cln::cl_RA& value = graph_.rational_of(exponent->node);
    const bool is_small = cln::denominator(value) == 1 && value <= 1'000'000;
    if (!is_small || graph_.is_zero(base->node)) return std::nullopt;
    const auto magnitude = static_cast<std::int32_t>(cln::cl_I_to_long(cln::numerator(value)));
    return Power{*base, exponent->is_negative ? -magnitude : magnitude};
  }

  OptionalNode read_product(const std::vector<ExpressionSyntax>& factors) {
    std::vector<Power> powers;
    for (const ExpressionSyntax& one : factors) {
      const std::optional<Power> power = read_factor(one);
      if (!power) return std::nullopt;
      powers.push_back(*power);
    }
    return graph_.product(powers);
  }

  Graph& graph_;
  const std::vector<std::string>& coordinates_;
};

}  // namespace

std::optional<SignedNode> read_value(Graph& graph, const std::string& text,
                                     const std::vector<std::string>& coordinates,
                                     const Limits& limits) {
  const Result<ExpressionSyntax> syntax = parse_expression(make_source("text", text), limits);
  return syntax ? GraphReader(graph, coordinates).read_expression(*syntax) : std::nullopt;
}

}  // namespace elgen
