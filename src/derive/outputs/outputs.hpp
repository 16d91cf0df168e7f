// The outputs: each output is derived by the function of the same name.
#pragma once

#include <optional>

#include "derive/lagrangian/derivation.hpp"
#include "elgen/scene.hpp"

namespace elgen {

// N is defined by dq/dt = N v; without rotations, N is the identity.

// Generalised forces and momenta: vectors of n_v entries. Unit: J per unit of the coordinate, for
// momenta J s per unit.

enum class InputForces : unsigned char { absent, acting };
enum class BodySelection : unsigned char { all, outside_frames };

/// tau = M a + bias.
[[nodiscard]] RealVector inverse_dynamics(Derivation& derivation);

/// tau - B u; tau if the inputs are absent. BodySelection::outside_frames omits the inertial forces
/// and weights of bodies in frames.
[[nodiscard]] RealVector dynamics_residual(Derivation& derivation, InputForces inputs,
                                           BodySelection bodies);

/// C v + drift + g + dD/dv - Q - B u; without B u if the inputs are absent.
[[nodiscard]] RealVector bias(Derivation& derivation, InputForces inputs = InputForces::absent,
                              BodySelection bodies = BodySelection::all);

/// C v: the part quadratic in v. Requires L quadratic in v.
[[nodiscard]] RealVector velocity_force(Derivation& derivation,
                                        BodySelection bodies = BodySelection::all);

/// dT/dv of the bodies in frames.
[[nodiscard]] RealVector momentum_of_frames(Derivation& derivation);

/// (dM/dt) v + (db/dq - (db/dq)^T) v + db/dt - dT0/dq with b.v = T1 - V1, d/dt at fixed q.
/// Requires L quadratic in v.
[[nodiscard]] RealVector drift(Derivation& derivation);

/// g = dV0/dq. Requires L quadratic in v.
[[nodiscard]] RealVector gravity(Derivation& derivation);

/// dD/dv.
[[nodiscard]] RealVector dissipation(Derivation& derivation);

/// Q, the declared forces at u = 0; Q + B u if the inputs act.
[[nodiscard]] RealVector applied_force(Derivation& derivation,
                                       InputForces inputs = InputForces::absent);

/// dL/dv = M v + b.
[[nodiscard]] RealVector momentum(Derivation& derivation);

/// N^T dL/dq. For a rotation, the entries are derivatives of L along the rotation vector.
[[nodiscard]] RealVector position_gradient(Derivation& derivation);

/// For each locked coordinate whose reaction is requested, the force that holds the coordinate in
/// addition to the inputs: d/dt dL/dv - dL/dq + dD/dv - Q - B u with L before locking, at q = s(t),
/// v = ds/dt, a = d2s/dt2.
[[nodiscard]] RealVector reaction(Derivation& derivation);

/// v_c, the velocities of the cyclic coordinates that specialise removed.
[[nodiscard]] RealVector cyclic_rates(Derivation& derivation);

// Energies, in J.

/// T. Requires L quadratic in v.
[[nodiscard]] GiNaC::ex kinetic_energy(Derivation& derivation);

/// V0, the potential energy at zero rates. Requires L quadratic in v.
[[nodiscard]] GiNaC::ex potential_energy(Derivation& derivation);

/// T of the point masses and of the bodies in frames, without the terms of [energy].
[[nodiscard]] GiNaC::ex kinetic_energy_of_masses(Derivation& derivation);

/// V = -sum m gravity.p of the point masses and of the bodies in frames.
[[nodiscard]] GiNaC::ex potential_energy_of_masses(Derivation& derivation);

/// T + V = T + V0 + V1.v. Requires L quadratic in v.
[[nodiscard]] GiNaC::ex total_energy(Derivation& derivation);

/// E = sum v dL/dv - L, which is T2 - T0 + V0 if L is quadratic in v.
[[nodiscard]] GiNaC::ex energy_function(Derivation& derivation);

/// V0 - T0, which is E at v = 0. Requires L quadratic in v.
[[nodiscard]] GiNaC::ex energy_at_rest(Derivation& derivation);

// Matrices, row-major.

/// M = d2L/dv2, n_v x n_v, symmetric: entries ij and ji are the same expression. A point mass adds
/// m dp/dq_i . dp/dq_j. Cost: one forward and one reverse pass per column.
[[nodiscard]] RealVector mass_matrix(Derivation& derivation);

/// C_ij = 1/2 d(C v)_i/dv_j, the Christoffel form: (sum dM/dq_k v_k) - 2 C is skew. For rotations
/// see turning.hpp. Cost: n_v forward passes over C v, and one tree_coriolis_matrix().
[[nodiscard]] RealVector coriolis_matrix(Derivation& derivation);

/// B = dQ/du, n_v x n_u.
[[nodiscard]] RealVector input_matrix(Derivation& derivation);

/// tau = Y pi + rest with the inertial parameters pi. Y is n_v x n_pi; column k is the part of tau
/// per unit of parameter k. `rest` is tau at pi = 0. Cost: a reverse pass per parameter of a body.
struct Regressor {
  RealVector matrix;
  RealVector rest;
};
[[nodiscard]] Regressor regressor(Derivation& derivation);

/// The regressor of M a + C(q, v) r + drift(r) + g + dD/dv(r) - Q with a reference velocity r. C is
/// coriolis_matrix(). Requires L quadratic in v.
[[nodiscard]] Regressor regressor_reference(Derivation& derivation);

/// pi, the values of the inertial parameters.
[[nodiscard]] RealVector regressor_parameters(Derivation& derivation);

/// dy/dq N of each value y. Cost: one reverse pass per row.
[[nodiscard]] RealVector jacobian(Derivation& derivation, const Terms& values);

/// dy/dq N, dy/dv, dy/da and dy/du of each value y. Cost: one reverse pass per value and field.
struct OutputDerivatives {
  RealVector by_position;
  RealVector by_velocity;
  RealVector by_acceleration;
  RealVector by_input;
};
[[nodiscard]] OutputDerivatives output_derivatives(Derivation& derivation, const Terms& values);

/// d(B u)/dq N, n_v x n_v. Cost: one forward pass per velocity.
[[nodiscard]] RealVector input_force_derivatives(Derivation& derivation);

/// M^-1, n_v x n_v; entries are definitions. Throws ZeroPivot.
[[nodiscard]] RealVector inverse_mass_matrix(Derivation& derivation);

/// Operational-space dynamics of a task y with k entries, J = dy/dq N:
///
///     inertia           Lambda = (J M^-1 J^T)^-1                      k x k
///     inverse_jacobian  M^-1 J^T Lambda                               n_v x k
///     bias              Lambda (J M^-1 bias - bias of y)              k
///     relative_pivots   D_i / S_ii of J M^-1 J^T = S = L D L^T        k
///
/// One factorisation of M and one of S. Throws ZeroPivot.
struct OperationalDynamics {
  RealVector inertia;
  RealVector inverse_jacobian;
  RealVector bias;
  RealVector relative_pivots;
};
[[nodiscard]] OperationalDynamics operational_dynamics(Derivation& derivation,
                                                       const RealVector& jacobian,
                                                       const RealVector& bias_of_task);

/// d2y/dt2 at a = 0.
[[nodiscard]] RealVector second_rate(Derivation& derivation, const Terms& values);

/// The twist of a frame is (angular velocity; velocity of its origin). twist_jacobian() is
/// d twist/dv, 6 x n_v; twist_bias() is d twist/dt at a = 0.
[[nodiscard]] RealVector twist_jacobian(Derivation& derivation, const TwistOutput& output);
[[nodiscard]] RealVector twist_bias(Derivation& derivation, const TwistOutput& output);

// Constraints f(q, t) = 0 with r = df/dt, and phi(q, v, t) = 0 with r = phi (elgen/outputs.hpp).

/// r of each constraint, n_c entries.
[[nodiscard]] RealVector constraint_rates(Derivation& derivation);

/// f of the position constraints, and r of all constraints.
struct ConstraintResidual {
  RealVector position;
  RealVector rate;
};
[[nodiscard]] ConstraintResidual constraint_residual(Derivation& derivation);

/// A = dr/dv, n_c x n_v; for a position constraint this is df/dq N.
[[nodiscard]] RealVector constraint_jacobian(Derivation& derivation);

/// gamma = dr/dt at a = 0.
[[nodiscard]] RealVector constraint_bias(Derivation& derivation);

/// A^T lambda, n_v entries.
[[nodiscard]] RealVector constraint_force(Derivation& derivation, const RealVector& multipliers);

/// `rates_of_rates` + 2 zeta omega r + omega^2 f. Along the motion, this sum is 0 if
/// `rates_of_rates` is dr/dt, and -A a if `rates_of_rates` is gamma = dr/dt at a = 0.
[[nodiscard]] RealVector with_stabilisation(Derivation& derivation, RealVector rates_of_rates);

/// One Newton step onto the constraints, with S = A M^-1 A^T. The position constraints change q to
/// q - N M^-1 A^T S^-1 f. Then all constraints, at the new q, change v to v - M^-1 A^T S^-1 r.
/// Throws ZeroPivot.
struct ProjectedState {
  RealVector coordinates;
  RealVector rates;
};
[[nodiscard]] ProjectedState projected(Derivation& derivation);

/// Inverse dynamics with constraints. tau = M a + bias, S = A M^-1 A^T and
/// G = M^-1 - M^-1 A^T S^-1 A M^-1:
///
///     inputs      u = (B^T G B)^-1 B^T G tau
///     multipliers lambda = S^-1 A M^-1 (tau - B u)
///     unbalanced  tau - B u - A^T lambda
///
/// Throws ZeroPivot.
struct ConstrainedInverseDynamics {
  RealVector inputs;
  RealVector multipliers;
  RealVector unbalanced;
};
[[nodiscard]] ConstrainedInverseDynamics constrained_inverse_dynamics(Derivation& derivation);

/// All velocities and accelerations, from the entries with independent indices i
/// (OutputRequest::independent). The entries with dependent indices d solve A_d v_d = -r(v_d = 0)
/// and A_d a_d = -(A_i a_i + gamma); A_d is square. The solution factorises A_d A_d^T, whose
/// condition number is cond(A_d)^2. Throws ZeroPivot.
struct CompletedMotion {
  RealVector rates;
  RealVector accelerations;
};
[[nodiscard]] CompletedMotion completed(Derivation& derivation, const OutputRequest& request);

// Forward dynamics M a = B u - bias + A^T lambda, A a = -gamma - 2 zeta omega r - omega^2 f, and
// derivatives of the dynamics. With constraints these equations are differentiated for all (q, v),
// including the change of lambda:
//
//     M da = A^T dlambda - d(M a + bias - B u - A^T lambda),   A da = -d(A a + gamma + …)
//
//     inverse    tau = M a + bias:            d tau/dq, d tau/dv
//     forward    M a = B u - bias:            da/dq = -M^-1 d(M a + bias - B u)/dq at that a,
//                                             da/dv = -M^-1 d bias/dv,  da/du = M^-1 B
//     linear     x = (dq, dv):                dx/dt = A x + B du,  A = [0 1; da/dq da/dv],
//                                             B = [0; da/du]
//
// For a rotation, dq is the rotation vector in the rotated axes; its rate is dv - w x dq, so the
// upper left block of A contains -[w]x.
//
// If has_linear_variables(), tree_derivatives() differentiates the forces of bodies in frames. All
// other terms are differentiated by one forward pass per unit direction.

struct ForwardDynamics {
  RealVector acceleration;
  RealVector relative_pivots;  ///< of M, then of S = A M^-1 A^T
  RealVector multipliers;
  RealVector diagonal;  ///< of M and S; if an entry is 0, its relative pivot is undefined
};
[[nodiscard]] ForwardDynamics forward_dynamics(Derivation& derivation);

/// Forward dynamics that does not form M (tree/articulated.hpp), and the number of operations that
/// factorising M would need. None, unless all of this holds: bodies in frames; no constraints and
/// no point masses outside frames; T and V (not L), quadratic in v; a T of [energy] that adds at
/// most a diagonal to M; joints that tree_joints() accepts; M eliminated from the last velocity,
/// because other orders have other pivots. If `has_pivots` is false, M_ii and the relative pivots
/// are not computed.
struct ArticulatedDynamics {
  ForwardDynamics solution;
  std::size_t factorisation_operations = 0;
};
[[nodiscard]] std::optional<ArticulatedDynamics> articulated_dynamics(Derivation& derivation,
                                                                      bool has_pivots = true);

/// `values` after a and lambda are replaced by the solution of the forward dynamics.
[[nodiscard]] RealVector values_along_motion(Derivation& derivation, const RealVector& values);

/// n_v x n_v each, row-major.
struct InverseDerivatives {
  RealVector by_position;
  RealVector by_velocity;
};
[[nodiscard]] InverseDerivatives inverse_dynamics_derivatives(Derivation& derivation);

/// Row-major; n_v x n_v, n_v x n_v and n_v x n_u.
struct ForwardDerivatives {
  RealVector by_position;
  RealVector by_velocity;
  RealVector by_input;
};
[[nodiscard]] ForwardDerivatives forward_dynamics_derivatives(Derivation& derivation);

/// The parts from which elgen/compose.hpp computes derivatives of forward dynamics and the
/// linearization.
struct ForwardDynamicsTerms {
  RealVector mass;
  RealVector force;
  ForwardDerivatives forces;  ///< with r = M a + bias - B u: -dr/dq, -dr/dv, B
  RealVector rates;           ///< the upper rows of A
};

/// The parts; none if the model has constraints or fewer than min_composed_velocities velocities.
/// Throws ZeroPivot if an M_ii is 0.
[[nodiscard]] std::optional<ForwardDynamicsTerms> forward_dynamics_terms(Derivation& derivation);

/// Row-major: A is 2 n_v x 2 n_v, and B is 2 n_v x n_u.
struct Linearization {
  RealVector a;
  RealVector b;
};
[[nodiscard]] Linearization linearization(Derivation& derivation);

// Functions of q and of momenta p = M v + b, b = dL/dv at v = 0. Requires L quadratic in v. v is
// computed from p and substituted in functions of (q, v), so no function is differentiated again.
// Each function throws ZeroPivot. Goldstein, Poole, Safko, 3rd ed., sec. 8.1.
//
//     v = M^-1 (p - b)
//     H = p.v - L = 1/2 (p - b).v + V0 - T0
//     dq/dt = N v,   dp/dt = N^T dL/dq - [w]x p + B u + Q - dD/dv   at that v

/// H(q, p).
[[nodiscard]] GiNaC::ex hamiltonian(Derivation& derivation);

/// v = M^-1 (p - b).
[[nodiscard]] RealVector velocities_of_momenta(Derivation& derivation);

/// `coordinate_rates` has n_q entries, `momentum_rates` n_v entries.
struct HamiltonEquations {
  RealVector coordinate_rates;
  RealVector momentum_rates;
};
[[nodiscard]] HamiltonEquations hamilton_equations(Derivation& derivation);

}  // namespace elgen
