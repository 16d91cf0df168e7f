// Conservation: constant momenta and causes of energy change. find_conservation() finds both by the
// zero entries of the outputs, and by the occurrence of t in E and p.
#pragma once

#include "elgen/model.hpp"
#include "elgen/program.hpp"

namespace elgen {

struct Conservation {
  std::vector<std::uint32_t> momenta = {};  ///< indices of velocities, never of angular velocities
  bool is_forced = false;                   ///< an input, a force or dissipation acts
  bool has_time = false;                    ///< E or a momentum contains t, and thus L contains t
};

/// The constant momenta and the causes of energy change. `has_inputs`: inputs act on the system. If
/// `needs_proof` is false, zeros found only by sampling and missing outputs count as 0.
[[nodiscard]] Conservation find_conservation(const Model& model, const Program& program,
                                             bool has_inputs, bool needs_proof);

/// True if the function contains t, directly or in an argument of a function without expression
/// (`open_value`).
[[nodiscard]] bool contains_time(const Model& model, const Function& function);

}  // namespace elgen
