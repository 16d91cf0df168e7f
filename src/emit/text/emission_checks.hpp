// Errors that only emission finds: names that the emitted code keeps for itself (E701), and numbers
// that a scalar the scene asks for cannot hold (E702).
#pragma once

#include <string>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// E701 at the span of what wants the name.
[[nodiscard]] Diagnostic taken_name(const std::string& name, const char* what, const Span& span);

/// The same of a function, where the scene asks for it; nowhere for the scene `full`.
[[nodiscard]] Diagnostic taken_name(const Scene& scene, const Function& function);

/// E702: looks at the values of run-time parameters and at the constants of the equations. A value
/// that becomes subnormal has lost digits and counts as vanished.
[[nodiscard]] Diagnostics check_scalar_range(const Model& model, const Scene& scene,
                                             const Program& program);

}  // namespace elgen
