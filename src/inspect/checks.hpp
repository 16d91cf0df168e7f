// The checks of the inspection. Each function returns the diagnostics of one check.
#pragma once

#include <string>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "elgen/oracle.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The subject of an inspection: a model with the parameter values of a scene.
struct InspectedModel {
  const Model& model;
  const Scene& scene;
};

/// Matrices of models with more coordinates are not sampled: n coordinates need n^2 directional
/// derivatives, each with a cost linear in the length of the kinematic chain.
inline constexpr std::size_t most_coordinates_sampled = 24;

/// Models with more coordinates are not searched for singular configurations.
inline constexpr std::size_t most_coordinates_searched = 3;

/// E312, E313, E314, E910: constants without a value and too large powers that are found only if
/// names are replaced by their expressions.
[[nodiscard]] Diagnostics inspect_constants(const InspectedModel& subject);

/// E501: M is singular at every sampled state, or M_ii = 0 at every sampled state and an output
/// divides by M. E524: M is not positive definite at a sampled state.
[[nodiscard]] Diagnostics inspect_mass_matrix(const InspectedModel& subject);

/// E536: an equation with no effect on the motion. E537: an equation that follows from other
/// equations at every pose. E538: no pose near the start satisfies the constraints. E603: the scene
/// requests `completed`, but the constraints determine the dependent velocities at no pose; or the
/// scene requests constrained inverse dynamics, but the inputs are determined at no pose.
[[nodiscard]] Diagnostics inspect_constraints(const InspectedModel& subject);

/// E603: an [[output]] whose Jacobian has full rank at no sampled state, although the scene
/// requests its operational-space equation of motion.
[[nodiscard]] Diagnostics inspect_tasks(const InspectedModel& subject);

/// E507: a planar spin that is not the time derivative of a function of q and t.
[[nodiscard]] Diagnostics inspect_spins(const InspectedModel& subject);

/// E508: an inertia that no rigid body has.
[[nodiscard]] Diagnostics inspect_inertias(const InspectedModel& subject);

/// E511: configurations at which M loses rank.
[[nodiscard]] Diagnostics inspect_charts(const InspectedModel& subject);

/// E512: gravity or V pushes a mass upwards.
[[nodiscard]] Diagnostics inspect_potential(const InspectedModel& subject);

/// E523, E525: a negative mass or a negative dissipation.
[[nodiscard]] Diagnostics inspect_signs(const InspectedModel& subject);

/// E526: `[energy] V` contains a weight that [gravity] already adds.
[[nodiscard]] Diagnostics inspect_weights(const InspectedModel& subject);

/// E527: `[energy] T` contains the energy of a point with a mass, which elgen already adds.
[[nodiscard]] Diagnostics inspect_kinetic_energies(const InspectedModel& subject);

/// E627: a force with tanh in a linearization that the scene requests by name.
[[nodiscard]] Diagnostics inspect_smoothed_friction(const InspectedModel& subject);

/// E522: parameters that occur in no expression, and inputs without effect.
[[nodiscard]] Diagnostics inspect_unused_names(const InspectedModel& subject);

/// E619: outputs of the model that the built-in scene `full` omits. E616: inputs on locked
/// coordinates.
[[nodiscard]] Diagnostics inspect_omissions(const InspectedModel& subject);

/// E613: an [[equilibrium]] at which the system does not stay at rest.
[[nodiscard]] Diagnostics inspect_equilibria(const InspectedModel& subject);

/// E613: the point about which the scene expands is not an equilibrium. E614: energies or forces
/// have no derivatives at this point. All other checks use the exact model.
[[nodiscard]] Diagnostics inspect_expansion_point(const InspectedModel& subject);

}  // namespace elgen
