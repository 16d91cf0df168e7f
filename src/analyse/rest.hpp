// Rest: the equations of a system that does not move, and what they say of each coordinate.
//
//     r(q) = bias(q, 0) - B(q) u = 0,    u given        M(q)        W(q) = V0 - T0
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "elgen/oracle.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// r, M and W as functions of a program, under the kinds bias, mass_matrix and energy_function.
/// Their leaves are parameters and coordinates, and t where it occurs.
struct RestProgram {
  Program program = {};
  [[nodiscard]] const Function& residual() const { return program.functions[0]; }
};

/// `moving` has bias, mass_matrix and energy_function, and input_matrix where there are inputs,
/// which have the values `inputs`. E530 where an entry has no value at rest.
[[nodiscard]] Result<RestProgram> rest_program(const Program& moving,
                                               const std::vector<cln::cl_R>& inputs);

/// The coordinates that a value depends on.
struct Occurrence {
  std::set<std::uint32_t> coordinates = {};
  std::set<std::uint32_t> outside_sinusoids = {};  ///< not only in e^(i k q) with an integer k
  bool has_time = false;
};

/// One for every entry of a function.
[[nodiscard]] std::vector<Occurrence> occurrences(const Program& program, const Function& function);

/// Equations of rest that share coordinates, and these. Without coordinates: one equation, which is
/// constant.
struct RestBlock {
  std::vector<std::uint32_t> rows = {};         ///< by velocity
  std::vector<std::uint32_t> coordinates = {};  ///< ascending
};

/// Apart from each other; coordinates in no equation are in none of them.
[[nodiscard]] std::vector<RestBlock> rest_blocks(const std::vector<Occurrence>& rows);

/// The inputs at a state of rest: 0, or their laws, which have to be numbers there, else E606.
[[nodiscard]] Result<std::vector<cln::cl_R>> inputs_of(const Model& model, const State& state);

}  // namespace elgen
