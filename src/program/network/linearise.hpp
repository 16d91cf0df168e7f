// linearise: Network -> Function: instructions in order of execution, operands before users.
//
//     sum(a, -b, product(m, x))  ->  0 = a   1 = b   2 = subtract 0 1
//                                    3 = m   4 = x   5 = multiply 3 4   6 = add 2 5
//
// The traversal is depth-first, from the entries in their order, operands from left to right.
// Operations that no entry needs get no instruction.
#pragma once

#include "elgen/program.hpp"
#include "program/network/network.hpp"

namespace elgen {

/// `function` without instructions; its entries become 0, 1, 2, ...: indices of network values.
[[nodiscard]] Function without_instructions(const Function& function);

/// Sets instructions and names of `function`. Entries of its fields change from indices into
/// `network.values` to indices of instructions. New constants are appended to `program`.
void linearise(const Network& network, Program& program, Function& function);

/// The values of a network as a function with one field, and its constants.
struct LinearisedNetwork {
  explicit LinearisedNetwork(const Network& network);

  Program program = {};
  Function function = {};
};

}  // namespace elgen
