// chosen: the functions of a scene in the forms in which they are emitted, and the step that is
// made of some.
#pragma once

#include "elgen/choose.hpp"
#include "elgen/closed_forms.hpp"
#include "elgen/lagrangian.hpp"
#include "elgen/limits.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// Errors of choose() and add_step(). Cost: what `step` calls is derived once more, in its own
/// name.
[[nodiscard]] Result<Choice> chosen(const Lagrangian& lagrangian, const Program& recursive,
                                    const ClosedForms& forms, const CheckedModel& checked,
                                    const Limits& limits);

}  // namespace elgen
