// The checks of the inspection, each from a subject to the diagnostics it deserves.
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

/// Matrices of more coordinates are not sampled: n^2 directional derivatives each as long as the
/// chain.
inline constexpr std::size_t most_coordinates_sampled = 24;

/// Charts are searched for singular configurations up to this many coordinates.
inline constexpr std::size_t most_coordinates_searched = 3;

/// E312, E313, E314, E910: constants without a value and powers beyond all sizes, through names.
[[nodiscard]] Diagnostics inspect_constants(const Inspected& subject);

/// E501: M x = 0 at every sampled state; or M_ii = 0 where an output solves for accelerations.
/// E524: M is not positive definite at one.
[[nodiscard]] Diagnostics inspect_mass_matrix(const Inspected& subject);

/// E536: an equation that no motion changes. E537: one that follows from others wherever they hold.
/// E538: no pose near the start.
[[nodiscard]] Diagnostics inspect_constraints(const Inspected& subject);

/// E603: an [[output]] whose Jacobian never has full rank, where its equation of motion is wanted.
[[nodiscard]] Diagnostics inspect_tasks(const Inspected& subject);

/// E507: a planar spin that is not the rate of an angle(q, t).
[[nodiscard]] Diagnostics inspect_spins(const Inspected& subject);

/// E508: an inertia that no distribution of mass has.
[[nodiscard]] Diagnostics inspect_inertias(const Inspected& subject);

/// E511: configurations at which M loses rank.
[[nodiscard]] Diagnostics inspect_charts(const Inspected& subject);

/// E512: the written potential falls as a point with a mass rises.
[[nodiscard]] Diagnostics inspect_potential(const Inspected& subject);

/// E523, E525: a mass or a dissipation that is negative.
[[nodiscard]] Diagnostics inspect_signs(const Inspected& subject);

/// E526: the written potential holds a weight that [gravity] gives.
[[nodiscard]] Diagnostics inspect_weights(const Inspected& subject);

/// E527: the written kinetic energy holds that of a mass.
[[nodiscard]] Diagnostics inspect_kinetic_energies(const Inspected& subject);

/// E627: a force with tanh in a linearization that the scene names.
[[nodiscard]] Diagnostics inspect_smoothed(const Inspected& subject);

/// E522: parameters in no expression, inputs that act on nothing.
[[nodiscard]] Diagnostics inspect_unused(const Inspected& subject);

/// E619: outputs of the model that the built-in scene `full` leaves out.
[[nodiscard]] Diagnostics inspect_left_out(const Inspected& subject);

/// E613: an [[equilibrium]] at which the system does not stay at rest.
[[nodiscard]] Diagnostics inspect_equilibria(const Inspected& subject);

/// E613, E614: a scene that expands about a point where the system does not stay at rest, or where
/// energies and forces have no derivatives. The other checks see the exact model.
[[nodiscard]] Diagnostics inspect_equilibrium(const Inspected& subject);

}  // namespace elgen
