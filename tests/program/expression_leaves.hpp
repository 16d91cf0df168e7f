// Expressions over coordinates a, b, c, d, e: read from text and printed again.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/page.hpp"
#include "elgen/program.hpp"
#include "program/graph/graph_reader.hpp"
#include "program/network/linearise.hpp"
#include "program/network/network.hpp"

namespace elgen::test {

using Texts = std::vector<std::string>;

inline SignedNode value_of(Graph& graph, const std::string& text) {
  const auto value = read_value(graph, text, {"a", "b", "c", "d", "e"});
  if (!value) FAIL("cannot read " << text);
  return *value;
}

/// Reads sums and products as typed: a bracket is a node of its own.
inline Expressions expressions_of(const Texts& texts) {
  Expressions result;
  for (const std::string& text : texts) result.values.push_back(value_of(result.graph, text));
  return result;
}

/// The five coordinates as leaves of a graph.
struct ExpressionLeaves {
  Expressions expressions = {};
  Graph& graph = expressions.graph;
  SignedNode a = graph.leaf(Opcode::coordinate, 0);
  SignedNode b = graph.leaf(Opcode::coordinate, 1);
  SignedNode c = graph.leaf(Opcode::coordinate, 2);
  SignedNode d = graph.leaf(Opcode::coordinate, 3);
  SignedNode e = graph.leaf(Opcode::coordinate, 4);
};

/// A program with one field, a row of the values of `network`.
inline Program program_of(const Network& network) {
  Program program;
  program.leaves.q = program.leaves.v = program.leaves.a = {"a", "b", "c", "d", "e"};
  Function function;
  function.name = "bias";
  function.kind = OutputKind::bias;
  Field field;
  field.columns = static_cast<std::uint32_t>(network.values.size());
  for (std::uint32_t i = 0; i < field.columns; ++i) field.entries.push_back(i);
  function.fields = {field};
  linearise(network, program, function);
  program.functions = {function};
  return program;
}

/// The first value at this point.
inline Real value_of(const Expressions& expressions, const Arguments<Real>& point) {
  const Program program = program_of(make_network(expressions));
  return evaluate(program, program.functions[0], point).at(0);
}

/// The value in double at `letters`, five numbers.
inline double value_in_double(const Expressions& expressions, const std::vector<double>& letters) {
  Arguments<double> point;
  point.q = letters;
  const Program program = program_of(make_network(expressions));
  return evaluate(program, program.functions[0], point).at(0);
}

inline Program program_of(const Texts& texts) {
  return program_of(make_network(expressions_of(texts)));
}

inline Texts texts_of(const Network& network) {
  const Program program = program_of(network);
  const Function& function = program.functions[0];
  return texts_of(
      function_equations(program, function, temporary_names(program, function)).entries.at(0));
}

inline Texts texts_of(const Expressions& expressions) {
  return texts_of(make_network(expressions));
}

inline OperationCounts counts_of(const Network& network) {
  return count_operations(program_of(network).functions[0]);
}

inline OperationCounts counts_of(const Expressions& expressions) {
  return counts_of(make_network(expressions));
}

}  // namespace elgen::test
