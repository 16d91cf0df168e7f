// definiteness: whether M without its small terms stays positive definite.
#pragma once

#include "elgen/model.hpp"
#include "elgen/reduction.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// E618 where what was dropped from M may be more than half its smallest eigenvalue, M scaled to a
/// diagonal of 1, at a state sampled over the ranges: the reduced M could then be indefinite.
[[nodiscard]] Diagnostics check_definiteness(const Model& model, const Scene& scene,
                                             const Reduction& reduction);

}  // namespace elgen
