// parts: M, bias and what else solutions of M x = b are judged by, from the program before forms
// were chosen.
#pragma once

#include <optional>

#include "elgen/equations_of_motion.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// None where nothing is solved, or where a limit was reached.
struct SolutionParts {
  std::optional<Program> program = {};
};

/// Those that the scene has; none where one is missing.
[[nodiscard]] std::optional<Program> known_parts(const CheckedModel& checked,
                                                 const Program& recursive);

/// Those that the scene has not are derived. Always in recursive form: what is closed has cancelled
/// terms that solutions do not.
[[nodiscard]] Result<SolutionParts> parts(const Lagrangian& lagrangian, const CheckedModel& checked,
                                          const Program& recursive, const Limits& limits);

}  // namespace elgen
