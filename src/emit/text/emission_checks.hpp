// emission_checks: errors that only emission finds: names that the emitted code reserves (E701),
// and numbers beyond the range of a scalar of the scene (E702).
#pragma once

#include <string>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// E701 at the span of the parameter, function or module that has the name.
[[nodiscard]] Diagnostic reserved_name_error(const std::string& name, const char* what,
                                             const Span& span);

/// E701 for the name of a function, at the span of the output's request in the scene. The built-in
/// scene `full` has no file and thus no span.
[[nodiscard]] Diagnostic reserved_name_error(const Scene& scene, const Function& function);

/// E702 for values of run-time parameters and for constants of the equations. A value that becomes
/// subnormal loses digits and is reported like a value that becomes 0.
[[nodiscard]] Diagnostics check_scalar_range(const Model& model, const Scene& scene,
                                             const Program& program);

}  // namespace elgen
