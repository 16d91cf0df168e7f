// readable_steps: a derivation step by step, as it is read.
#pragma once

#include "elgen/lagrangian.hpp"
#include "elgen/limits.hpp"
#include "elgen/render.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The steps go the way of every output: lowered, presented, and read in their closed forms.
[[nodiscard]] Result<ReadableSteps> readable_steps(const Lagrangian& lagrangian,
                                                   const CheckedModel& checked,
                                                   const Limits& limits);

}  // namespace elgen
