// Arguments: the kinds of leaves that an emitted function takes, whether it reads them or not.
//
//     inverse_dynamics, time occurs   ->   p, q, v, a, t
#pragma once

#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// Those of the output table, in the order of leaves.def: parameters, q, then v, a, u and t as far
/// as the function takes them.
[[nodiscard]] std::vector<Opcode> arguments_of(const Model& model, const Function& function);

/// How many numbers an argument holds; one for time.
[[nodiscard]] std::size_t argument_size(const Model& model, Opcode argument);

/// Whether it is an array of numbers, not the struct of parameters or one number.
[[nodiscard]] constexpr bool is_vector(Opcode argument) {
  return argument != Opcode::parameter && argument != Opcode::time;
}

}  // namespace elgen
