// Inspection: mechanical plausibility of a Model, by sampling the oracle at exact random points.
//
// Finds faults of a model that the parser and the checks of names and units cannot find. Examples:
// a mass matrix that is singular everywhere, with its null vector; a planar spin that is not the
// rate of an angle; configurations with det M = 0; a potential that pushes a mass upwards; an
// inertia that no body has; unused names. Also lists the outputs that the built-in scene `full`
// omits.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "elgen/oracle.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The errors, warnings and notes on a model: E312 to E314, E501, E507, E508, E511, E512, E522 to
/// E527, E536 to E538, E603, E613, E614, E616, E619, E627 and E910.
[[nodiscard]] Diagnostics inspect(const Model& model, const Scene& scene);

/// At most four exact states of rest, at which inspect() checks `equilibrium`. The first state has
/// the parameters of the model, the others have random parameters. Parameters that violate the
/// condition of `equilibrium` are not used. Empty if no parameters meet the condition, or if bias
/// or B has no value at the states.
[[nodiscard]] std::vector<State> sample_equilibrium(const CheckedModel& checked,
                                                    const Equilibrium& equilibrium);

/// Sets each momentum of `[routh]` that has no value yet: to the declared value, or to the value at
/// the start if none is declared. E635: L depends on a coordinate of `[routh]` at one of 8 sampled
/// states, the momenta do not determine the rates, or a momentum has no value. Cost: a few
/// evaluations of L for each momentum.
[[nodiscard]] Diagnostics set_routh_momenta(CheckedModel& checked);

/// True if `[routh]` can eliminate the coordinate (see E635): L does not depend on it, no force of
/// an input, of an entry [[force]] or of D acts on it, and none of these forces depends on it.
/// Cost: as set_routh_momenta().
[[nodiscard]] bool is_cyclic(const CheckedModel& checked, std::uint32_t coordinate);

/// A hint that recommends `sinc` and `cosc`: "`sin(c)/c` is 0/0 there; …". Empty if no quotient of
/// sines or cosines is 0/0 at the state. Cost: the oracle for each quotient.
[[nodiscard]] std::string quotient_hint(const Model& model, const State& state);

/// The residuals after the assembly `at`, as text: "0.5 m of `loop_x`, 0.1 m of `loop_y`". If `at`
/// has a pose, the numbers are |r|, else |f| (see Constraint).
[[nodiscard]] std::string residual_text(const Model& model, const Assembly& at);

}  // namespace elgen
