// Conservation: the momenta that nothing changes, and what changes the energy, as those entries of
// outputs tell that are the number 0.
#pragma once

#include "elgen/model.hpp"
#include "elgen/program.hpp"

namespace elgen {

struct Conservation {
  std::vector<std::uint32_t> momenta = {};  ///< velocities, those of rotations aside
  bool is_forced = false;                   ///< by an input, a force or dissipation
  bool has_time = false;                    ///< whether L contains t, as E or a momentum does
};

/// `has_inputs`: whether inputs act. Where zeros need no proof, those count that were found by
/// sampling, and outputs that the program does not have.
[[nodiscard]] Conservation find_conservation(const Model& model, const Program& program,
                                             bool has_inputs, bool needs_proof);

/// Whether a function contains t. An open value does where an argument of its function does.
[[nodiscard]] bool contains_time(const Model& model, const Function& function);

}  // namespace elgen
