// Named intermediates are recognised by value, however a program computes them.
#include "program/network/named_intermediates.hpp"

#include <catch2/catch.hpp>

#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("instructions with the value of a named intermediate get its name") {
  Expressions told;
  Graph& graph = told.graph;
  const SignedNode m = graph.leaf(Opcode::parameter, 0);
  const SignedNode x = graph.leaf(Opcode::coordinate, 0);
  const SignedNode sine = graph.call(FunctionId::sin, {x});
  const SignedNode value =
      graph.product({{graph.rational(cln::cl_RA(1) / 2), 1}, {m, 1}, {sine, 2}});
  told.values = {value, value, -sine};
  Program program = read_program(
      "parameters m\ncoordinates x\nfunction bias\n  0 = parameter m\n  1 = coordinate x\n"
      "  2 = sin 1\n  3 = constant 1/2\n  4 = multiply 3 2\n  5 = multiply 4 0\n"
      "  6 = multiply 5 2\n  7 = negate 6  ; own\n  8 = cos 1\n  result 1 3 = 6 7 8\n");
  Function& function = program.functions[0];
  name_intermediates(named_intermediates(told, {"moment", "later", "turn"}, program.leaves),
                     program, function);
  CHECK(function.names ==
        std::vector<std::string>{"", "", "~minus_turn", "", "", "", "~moment", "own", ""});
}

TEST_CASE(
    "a named intermediate's name is replaced by an own name, but by no other intermediate's") {
  std::string name;
  merge_name(name, "~first");
  merge_name(name, "~second");
  merge_name(name, "");
  CHECK(name == "~first");
  merge_name(name, "own");
  merge_name(name, "other");
  CHECK(name == "own");
}
