// read_constant, with raised limits: the text may be nested as deeply as the parser permits, with
// literals of any length.
#include "support/graph_reader.hpp"

#include "parse/expression_parser.hpp"
#include "program/graph/graph_reader.hpp"

namespace elgen::test {

std::optional<Constant> read_constant(const std::string& text) {
  Limits limits;
  limits.expression_depth = max_expression_depth;
  limits.literal_digits = text.size();
  Graph graph;
  const std::optional<SignedNode> value = read_value(graph, text, {}, limits);
  if (!value || !graph.has_constant_form(value->node)) return std::nullopt;
  return make_constant(graph.form_of(*value));
}

}  // namespace elgen::test
