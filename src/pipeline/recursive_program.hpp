// recursive_program: what the model's Lagrangian makes of some outputs, before forms are chosen.
#pragma once

#include <vector>

#include "elgen/equations_of_motion.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// derive, lower and cancel in one go: by-ways of the pipeline need equations of their own.
[[nodiscard]] Result<Program> recursive_program(const Lagrangian& lagrangian,
                                                const std::vector<OutputRequest>& outputs,
                                                const Limits& limits);

}  // namespace elgen
