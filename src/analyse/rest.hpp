// Rest: the equations of a system at rest, and the coordinates in each equation.
//
//     r(q) = bias(q, 0) - B(q) u = 0,    given u         M(q)        W(q) = V0 - T0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "elgen/oracle.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// r, M and W as functions of the kinds bias, mass_matrix and energy_function. Their leaves are
/// parameters and coordinates, and t if it occurs.
struct RestProgram {
  Program program = {};
  [[nodiscard]] const Function& residual() const { return program.functions[0]; }
};

/// r, M and W at v = 0 and u = `inputs`. `motion_program` has bias, mass_matrix and
/// energy_function, and input_matrix if the model has inputs. E530: an entry has no value at rest.
[[nodiscard]] Result<RestProgram> rest_program(const Program& motion_program,
                                               const std::vector<cln::cl_R>& inputs);

/// The hint on each parameter whose value 0 removes t from the equations at rest, but not all their
/// terms: "`--fix F0=0` removes t". "" if there is none.
[[nodiscard]] std::string time_removal_hint(const Model& model, const RestProgram& rest);

/// The coordinates on which a value depends.
struct CoordinateOccurrence {
  std::set<std::uint32_t> coordinates = {};
  std::set<std::uint32_t> outside_sinusoids = {};  ///< q occurs outside e^(i k q), k an integer
  bool has_time = false;
};

/// The coordinates in each entry of a function.
[[nodiscard]] std::vector<CoordinateOccurrence> coordinate_occurrences(const Program& program,
                                                                       const Function& function);

/// Equations at rest that share coordinates, and these coordinates. A block without coordinates is
/// one constant equation.
struct RestBlock {
  std::vector<std::uint32_t> rows = {};         ///< indices of velocities
  std::vector<std::uint32_t> coordinates = {};  ///< ascending
};

/// The independent blocks. Coordinates in no equation are in no block.
[[nodiscard]] std::vector<RestBlock> rest_blocks(const std::vector<CoordinateOccurrence>& rows);

/// The inputs at an equilibrium: 0, or the values of their laws. E606: a law depends on more than
/// parameters, or has no value.
[[nodiscard]] Result<std::vector<cln::cl_R>> rest_inputs(const CheckedModel& checked,
                                                         const State& state);

}  // namespace elgen
