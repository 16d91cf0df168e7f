// Inspection: mechanical sanity of a Model, found by sampling the oracle at exact random points.
//
// Finds what no reading of the text shows: a mass matrix singular everywhere (names the coordinate
// or null vector), a planar spin that is no angle's rate, charts that break where det M vanishes, a
// potential that pushes a mass up, inertias that no body can have, names used nowhere. Also says
// which outputs the built-in scene `full` does without.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "elgen/oracle.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// Errors, warnings and notes of E501 to E522, E613, E614 and E619; never changes the model.
[[nodiscard]] Diagnostics inspect(const Model& model, const Scene& scene);

/// The exact states of rest at which inspect() judges an [[equilibrium]]: at up to four values of
/// the parameters that meet its condition, the model's own first. Empty where no values that were
/// drawn meet it, or bias and B have no value there.
[[nodiscard]] std::vector<State> sampled_equilibrium(const CheckedModel& checked,
                                                     const Equilibrium& equilibrium);

/// Gives the momenta that a scene holds (`[routh]`) their values: as it says, or at the start.
/// E635: L changes with a coordinate at one of 8 sampled states, the momenta do not determine the
/// rates, or one has no value. Cost: a few evaluations of L for each.
[[nodiscard]] Diagnostics find_momenta(CheckedModel& checked);

/// Whether `[routh]` of a scene can take a coordinate out, as E635 judges: L does not change with
/// it, and no input, no force and no D acts on it or contains it. Cost: as of find_momenta().
[[nodiscard]] bool is_cyclic(const CheckedModel& checked, std::uint32_t coordinate);

/// "`sin(c)/c` is 0/0 there; …", which names `sinc` and `cosc`; "" if no quotient of sines or
/// cosines is 0/0 at the state. Cost: that of the oracle for each quotient.
[[nodiscard]] std::string quotient_hint(const Model& model, const State& state);

/// "0.5 m of `loop_x`, 0.1 m of `loop_y`": what f is, or where that is 0 what r is.
[[nodiscard]] std::string what_is_left(const Model& model, const Assembly& at);

}  // namespace elgen
