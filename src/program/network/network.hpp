// Network: n-ary operations on plain operand lists, what sharing and the order of evaluation work
// on.
//
//     Graph:    m^2*x/(y*z)
//     Network:  quotient(product(m, m, x), product(y, z))
//
// Powers are repeated factors. A divisor of two or more products becomes a reciprocal, computed
// once. Constants of a sum or product are folded into one number each, which keeps its form.
// NodeIds are dense and follow the canonical order of the graph, so from here on they may decide
// ties.
#pragma once

#include "program/graph/rebuild.hpp"

namespace elgen {

enum class OperationKind : std::uint8_t {
  constant,
  leaf,
  product,
  quotient,
  square_root,
  call,
  sum
};

struct Operation {
  OperationKind kind = OperationKind::constant;
  Opcode leaf = Opcode::constant;
  FunctionId function = FunctionId::sin;
  std::uint32_t index = 0;
  std::vector<Ref> operands = {};  ///< products and quotients: none negative
  std::string name = {};
};

struct Network {
  std::vector<Constant> constants = {};
  std::vector<Operation> operations = {};
  std::vector<Ref> values = {};
};

[[nodiscard]] Network make_network(const Expressions& expressions);

}  // namespace elgen
