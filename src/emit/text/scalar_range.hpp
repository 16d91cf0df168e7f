// scalar_range: E702 for numbers that a scalar the scene asks for cannot hold.
#pragma once

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// Looks at the values of run-time parameters and at the constants of the equations. A value that
/// becomes subnormal has lost digits and counts as vanished.
[[nodiscard]] Diagnostics check_scalar_range(const Model& model, const Scene& scene,
                                             const Program& program);

/// Whether none of them is lost in this scalar.
[[nodiscard]] bool fits(const Model& model, const Program& program, ScalarKind scalar);

}  // namespace elgen
