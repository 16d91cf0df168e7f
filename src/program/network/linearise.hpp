// linearise: Network -> Function: instructions in the order they are executed, operands before use.
//
//     sum(a, -b, product(m, x))  ->  0 = a   1 = b   2 = subtract 0 1   3 = m   4 = x   5 =
//     multiply 3 4   6 = add 2 5
//
// Depth-first from the entries in their order; operands left to right; only what the entries need.
#pragma once

#include "elgen/program.hpp"
#include "program/network/network.hpp"

namespace elgen {

/// The same function without instructions, its entries numbered as values of a network.
[[nodiscard]] Function unfilled(const Function& function);

/// Sets instructions and names of `function`, and turns the entries of its fields from positions in
/// `network.values` into instructions. New constants are appended to those of `program`.
void linearise(const Network& network, Program& program, Function& function);

/// The values of a network as a function of one field, with its constants.
struct Linearised {
  explicit Linearised(const Network& network);

  Program program = {};
  Function function = {};
};

}  // namespace elgen
