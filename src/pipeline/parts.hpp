// parts: M, bias and what else solutions of M x = b are judged by, from the program before forms
// were chosen.
#pragma once

#include "elgen/equations_of_motion.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// Those that the scene has; no functions where nothing is solved, or where one is missing.
[[nodiscard]] Program known_parts(const CheckedModel& checked, const Program& recursive);

/// Those that the scene has not are derived. Always in recursive form: what is closed has cancelled
/// terms that solutions do not. No functions where nothing is solved, or where a limit was reached.
[[nodiscard]] Result<Program> parts(const Lagrangian& lagrangian, const CheckedModel& checked,
                                    const Program& recursive, const Limits& limits);

}  // namespace elgen
