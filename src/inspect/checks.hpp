// The checks of the inspection; each maps a subject to its diagnostics.
#pragma once

#include <string>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "elgen/oracle.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The subject of an inspection: a model with the parameter values of a scene.
struct Inspected {
  const Model& model;
  const Scene& scene;
};

/// Matrices of more coordinates are not sampled: they need n^2 directional derivatives, each as
/// long as the chain.
inline constexpr std::size_t most_coordinates_sampled = 24;

/// Largest number of coordinates for which we search singular configurations.
inline constexpr std::size_t most_coordinates_searched = 3;

/// E312, E313, E314, E910: constants without a value and too large powers that only names reveal.
[[nodiscard]] Diagnostics inspect_constants(const Inspected& subject);

/// E501: M x = 0 at every sampled state, or M_ii = 0 if an output solves for accelerations. E524: M
/// is not positive definite at a sampled state.
[[nodiscard]] Diagnostics inspect_mass_matrix(const Inspected& subject);

/// E536: an equation with no effect on the motion. E537: an equation that follows from other
/// equations at every pose. E538: no pose near the start. E603: `completed` or inputs that the
/// constraints leave undetermined.
[[nodiscard]] Diagnostics inspect_constraints(const Inspected& subject);

/// E603: an [[output]] whose Jacobian never has full rank, if the scene requests its equation of
/// motion.
[[nodiscard]] Diagnostics inspect_tasks(const Inspected& subject);

/// E507: a planar spin that is not the time derivative of an angle(q, t).
[[nodiscard]] Diagnostics inspect_spins(const Inspected& subject);

/// E508: an inertia that no rigid body has.
[[nodiscard]] Diagnostics inspect_inertias(const Inspected& subject);

/// E511: configurations at which M loses rank.
[[nodiscard]] Diagnostics inspect_charts(const Inspected& subject);

/// E512: gravity or V pushes a mass upwards.
[[nodiscard]] Diagnostics inspect_potential(const Inspected& subject);

/// E523, E525: a negative mass or a negative dissipation.
[[nodiscard]] Diagnostics inspect_signs(const Inspected& subject);

/// E526: the written potential contains a weight that [gravity] already adds.
[[nodiscard]] Diagnostics inspect_weights(const Inspected& subject);

/// E527: the written kinetic energy contains the energy of a mass, which is already added.
[[nodiscard]] Diagnostics inspect_kinetic_energies(const Inspected& subject);

/// E627: a force with tanh in a linearization that the scene requests by name.
[[nodiscard]] Diagnostics inspect_smoothed(const Inspected& subject);

/// E522: parameters in no expression, and inputs without effect.
[[nodiscard]] Diagnostics inspect_unused(const Inspected& subject);

/// E619: outputs of the model that the built-in scene `full` omits. E616: inputs on locked
/// coordinates.
[[nodiscard]] Diagnostics inspect_left_out(const Inspected& subject);

/// E613: an [[equilibrium]] at which the system does not stay at rest.
[[nodiscard]] Diagnostics inspect_equilibria(const Inspected& subject);

/// E613: the scene expands about a point at which the system does not stay at rest. E614: energies
/// and forces have no derivatives there. All other checks use the exact model.
[[nodiscard]] Diagnostics inspect_equilibrium(const Inspected& subject);

}  // namespace elgen
