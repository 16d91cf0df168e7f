// Conservation: constant momenta and causes of energy change. Both follow from entries of outputs
// that are the number 0.
#pragma once

#include "elgen/model.hpp"
#include "elgen/program.hpp"

namespace elgen {

struct Conservation {
  std::vector<std::uint32_t> momenta = {};  ///< indices of velocities, never of angular ones
  bool is_forced = false;                   ///< an input, a force or dissipation acts
  bool has_time = false;                    ///< L contains t: E or a momentum does
};

/// `has_inputs`: inputs act on the system. Without `needs_proof`, zeros found by sampling count,
/// and an output that the program lacks counts as zero.
[[nodiscard]] Conservation find_conservation(const Model& model, const Program& program,
                                             bool has_inputs, bool needs_proof);

/// True if the function contains t, directly or in an argument of an open value.
[[nodiscard]] bool contains_time(const Model& model, const Function& function);

}  // namespace elgen
