// Network: n-ary operations on plain operand lists. Common-subexpression elimination and
// linearisation work on networks.
//
//     Graph:    m^2*x/(y*z)
//     Network:  quotient(product(m, m, x), product(y, z))
//
// A power is a repeated factor. A divisor of two or more products becomes a reciprocal, computed
// once. The constants of a sum or product are folded into one number, which keeps its form (but see
// mark_literal_calls). The ids of operations are dense and follow the canonical order of the graph,
// so that later passes may decide ties by ids.
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
  std::vector<SignedNode> operands = {};  ///< products and quotients: none negative
  std::string name = {};
};

struct Network {
  std::vector<Constant> constants = {};
  std::vector<Operation> operations = {};
  std::vector<SignedNode> values = {};
};

/// For each node: true if it contains a function of a number that code must call, because one term
/// of a sum contains this function, and another term the same function of an argument with this
/// number as a summand. Both then have the same rounding error of the number.
///
///     cos(7/10) - cos(x)*cos(y - 7/10)     calls cos(0.7): 0 at x = y = 0
///     cos(7/10)*x + cos(y - 3/10)          has the number 0.764842187284488
[[nodiscard]] std::vector<bool> mark_literal_calls(const Expressions& expressions);

/// Numbers keep their place in the graph, or are multiplied into the sums that they scale.
///
///     before:  3*cos(q) - 2*(sin(1)*sin(q) - cos(1)*cos(q))
///     after:   (3 + 2*cos(1))*cos(q) - 2*sin(1)*sin(q)          two numbers, two products
enum class NumberJoining : std::uint8_t { unjoined, joined };

[[nodiscard]] Network make_network(const Expressions& expressions,
                                   NumberJoining numbers = NumberJoining::unjoined);

/// Computes each sub-sum or sub-product only once, even if several operations contain it.
///
///     before:  y = product(m, l, c)   z = product(m, l, s)
///     after:   p = product(m, l)   y = product(p, c)   z = product(p, s)
///
/// No other pass eliminates common subexpressions. Greedy: the pair of operands with most users
/// becomes an operation. In sums, a - b and b - a are one pair. On a tie, the first pair in the
/// network wins.
void eliminate_common_subexpressions(Network& network);

/// Computes -x instead of x if all uses of x negate it, and a difference in x can be reversed at no
/// cost.
///
///     before:  s = a - b   result -s        p = product(m, a - b)   result -p
///     after:   s = b - a   result s         p = product(m, b - a)   result p
void flip_signs(Network& network);

}  // namespace elgen
