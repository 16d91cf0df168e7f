// Arguments: the kinds of leaves that an emitted function takes, whether it reads them or not.
//
//     inverse_dynamics, time occurs   ->   p, q, v, a, t
#pragma once

#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// Parameters, q and what the output table says, in the order of leaves.def; t where it occurs, and
/// open values where the model has some.
[[nodiscard]] std::vector<Opcode> arguments_of(const Model& model, const Function& function);

/// Whether it is an array of numbers, not the struct of parameters or one number.
[[nodiscard]] constexpr bool is_vector(Opcode argument) {
  return argument != Opcode::parameter && !is_single(argument);
}

}  // namespace elgen
