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

/// Whether numbers stay where the graph has them, or go into the sums that they multiply.
///
///     before:  3*cos(q) - 2*(sin(1)*sin(q) - cos(1)*cos(q))
///     after:   (3 + 2*cos(1))*cos(q) - 2*sin(1)*sin(q)          two numbers, two products
enum class Numbers : std::uint8_t { as_they_stand, joined };

[[nodiscard]] Network make_network(const Expressions& expressions,
                                   Numbers numbers = Numbers::as_they_stand);

/// Sub-sums and sub-products that several operations have in common are computed once.
///
///     before:  y = product(m, l, c)   z = product(m, l, s)
///     after:   p = product(m, l)   y = product(p, c)   z = product(p, s)
///
/// The only common-subexpression elimination. Greedy: the pair of operands found in most operations
/// becomes an operation; pairs of a sum count up to sign, a - b as b - a. Ties go to the pair that
/// comes first in the network.
void eliminate_common_subexpressions(Network& network);

/// A value that is only needed negative is computed negative, where a difference can turn for
/// nothing.
///
///     before:  s = a - b   result -s        p = product(m, a - b)   result -p
///     after:   s = b - a   result s         p = product(m, b - a)   result p
void turn_signs(Network& network);

}  // namespace elgen
