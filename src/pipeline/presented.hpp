// presented: the closed forms of a program, and those without small terms where the scene wants
// that.
#pragma once

#include <optional>

#include "elgen/closed_forms.hpp"
#include "elgen/drop.hpp"
#include "elgen/equations_of_motion.hpp"
#include "elgen/scene.hpp"

namespace elgen {

struct Presented {
  ClosedForms exact = {};
  std::optional<ReducedForms> reduced = {};
};

/// Errors of drop_terms().
[[nodiscard]] Result<Presented> presented(const Lagrangian& lagrangian, const CheckedModel& checked,
                                          const Program& recursive, const Limits& limits);

}  // namespace elgen
