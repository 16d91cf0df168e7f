// The outputs: the function that bears the name of an output derives it, at the caller's state.
#pragma once

#include <optional>

#include "derive/lagrangian/derivation.hpp"
#include "elgen/scene.hpp"

namespace elgen {

// Generalized forces, and the momentum: vectors of n_v, each J per unit of the coordinate
// (momentum: J s per unit).

enum class InputForces : unsigned char { absent, acting };
enum class Bodies : unsigned char { all, without_frames };

/// tau = M a + bias.
[[nodiscard]] Vector inverse_dynamics(Derivation& derivation);

/// The same less B u where the inputs act; without what the bodies in frames add, where asked so.
[[nodiscard]] Vector residual(Derivation& derivation, InputForces inputs, Bodies bodies);

/// C v + drift + g + dD/dv - Q; with the inputs acting, - Q - B u.
[[nodiscard]] Vector bias(Derivation& derivation, InputForces inputs = InputForces::absent,
                          Bodies bodies = Bodies::all);

/// C v: the part quadratic in v. L quadratic in v.
[[nodiscard]] Vector velocity_force(Derivation& derivation, Bodies bodies = Bodies::all);

/// dT/dv of the bodies in frames.
[[nodiscard]] Vector momentum_of_frames(Derivation& derivation);

/// (dM/dt) v + (db/dq - (db/dq)^T) v + db/dt - dT0/dq with b = b_T - V1. L quadratic in v.
[[nodiscard]] Vector drift(Derivation& derivation);

/// g = dV0/dq. L quadratic in v.
[[nodiscard]] Vector gravity(Derivation& derivation);

/// dD/dv.
[[nodiscard]] Vector dissipation(Derivation& derivation);

/// Q: the declared forces with u = 0; with the inputs acting, Q + B u.
[[nodiscard]] Vector applied_force(Derivation& derivation,
                                   InputForces inputs = InputForces::absent);

/// dL/dv = M v + b.
[[nodiscard]] Vector momentum(Derivation& derivation);

/// dL/dq; along the rotation vector, N^T dL/dq, where rotations turn.
[[nodiscard]] Vector position_gradient(Derivation& derivation);

/// (d/dt dL/dv - dL/dq + dD/dv - Q - B u) of the locked coordinates that want it, L before locking,
/// at q = s(t), v = ds/dt, a = d2s/dt2: what must act beside the inputs to hold them.
[[nodiscard]] Vector reaction(Derivation& derivation);

/// v_c of the cyclic coordinates that specialise took out.
[[nodiscard]] Vector cyclic_rates(Derivation& derivation);

// Energies, in J.

/// T. L quadratic in v.
[[nodiscard]] GiNaC::ex kinetic_energy(Derivation& derivation);

/// V0, the potential energy at zero rates. L quadratic in v.
[[nodiscard]] GiNaC::ex potential_energy(Derivation& derivation);

/// T of the point masses and of the bodies in frames, without further terms.
[[nodiscard]] GiNaC::ex kinetic_energy_of_masses(Derivation& derivation);

/// V of the same: -m gravity.p of each.
[[nodiscard]] GiNaC::ex weight_of_masses(Derivation& derivation);

/// T + V = T + V0 + V1.v. L quadratic in v.
[[nodiscard]] GiNaC::ex total_energy(Derivation& derivation);

/// E = sum v dL/dv - L; T2 - T0 + V0 where L is quadratic in v.
[[nodiscard]] GiNaC::ex energy_function(Derivation& derivation);

/// V0 - T0: E at zero rates. L quadratic in v.
[[nodiscard]] GiNaC::ex energy_at_rest(Derivation& derivation);

// Matrices, row-major.

/// M = d2L/dv2, n_v x n_v, symmetric: both halves hold the same expressions. One forward and one
/// reverse pass per column; a point mass gives sum m dp/dq_i . dp/dq_j.
[[nodiscard]] Vector mass_matrix(Derivation& derivation);

/// C_ij = 1/2 d(C v)_i/dv_j, the Christoffel form, for which (sum dM/dq_k v_k) - 2 C is skew.
/// n forward passes over C v.
[[nodiscard]] Vector coriolis_matrix(Derivation& derivation);

/// B = dQ/du, n_v x n_u.
[[nodiscard]] Vector input_matrix(Derivation& derivation);

/// Y, n_v x the number of inertial parameters, and tau - Y pi: forces of the unit of each
/// parameter, and what is left where all are 0. Cost: a reverse pass for each body's parameter.
struct Regressor {
  Vector matrix;
  Vector rest;
};
[[nodiscard]] Regressor regressor(Derivation& derivation);

/// The same with C(q, v) times a reference velocity r, and drift and dD/dv of r. L quadratic in v.
/// For rotations C is that of coriolis_matrix.
[[nodiscard]] Regressor regressor_reference(Derivation& derivation);

/// pi.
[[nodiscard]] Vector regressor_parameters(Derivation& derivation);

/// dy/dq of each value, one reverse pass per row.
[[nodiscard]] Vector jacobian(Derivation& derivation, const Terms& values);

/// dy/dq (along N where dq/dt = N v), dy/dv, dy/da and dy/du of each value, one reverse pass each.
struct OutputDerivatives {
  Vector by_position;
  Vector by_velocity;
  Vector by_acceleration;
  Vector by_input;
};
[[nodiscard]] OutputDerivatives output_derivatives(Derivation& derivation, const Terms& values);

/// d(B u)/dq along N, n_v x n_v: a forward pass for each direction.
[[nodiscard]] Vector input_force_derivatives(Derivation& derivation);

/// M^-1, n_v x n_v; entries are definitions. Throws ZeroPivot.
[[nodiscard]] Vector inverse_mass_matrix(Derivation& derivation);

/// The equation of motion along a task y of k entries, J = dy/dq:
///
///     inertia           Lambda = (J M^-1 J^T)^-1                      k x k
///     inverse_jacobian  M^-1 J^T Lambda                               n_v x k
///     bias              Lambda (J M^-1 bias - bias of y)              k
///     relative_pivots   D_i / S_ii of J M^-1 J^T = S = L D L^T        k
///
/// One factorisation of M and one of S. Throws ZeroPivot.
struct OperationalDynamics {
  Vector inertia;
  Vector inverse_jacobian;
  Vector bias;
  Vector relative_pivots;
};
[[nodiscard]] OperationalDynamics operational_dynamics(Derivation& derivation,
                                                       const Vector& jacobian,
                                                       const Vector& bias_of_task);

/// d2y/dt2 at a = 0.
[[nodiscard]] Vector second_rate(Derivation& derivation, const Terms& values);

/// d twist/dv, 6 x n_v, of a frame's twist (angular velocity; velocity of its origin), and the rate
/// of the twist at a = 0.
[[nodiscard]] Vector twist_jacobian(Derivation& derivation, const TwistOutput& output);
[[nodiscard]] Vector twist_bias(Derivation& derivation, const TwistOutput& output);

// Constraints f(q, t) = 0 with r = df/dt, and phi(q, v, t) = 0 with r = phi (elgen/outputs.hpp).

/// r, by constraint; entries are definitions.
[[nodiscard]] Vector constraint_rates(Derivation& derivation);

/// f of positions, and r of all.
struct ConstraintResidual {
  Vector position;
  Vector rate;
};
[[nodiscard]] ConstraintResidual constraint_residual(Derivation& derivation);

/// A = dr/dv, n_c x n_v: df/dq along velocities of positions.
[[nodiscard]] Vector constraint_jacobian(Derivation& derivation);

/// gamma = dr/dt at a = 0.
[[nodiscard]] Vector constraint_bias(Derivation& derivation);

/// A^T lambda.
[[nodiscard]] Vector constraint_force(Derivation& derivation, const Vector& multipliers);

/// The rates of r, or gamma, and 2 zeta omega r + omega^2 f: 0, or -A a, along the motion.
[[nodiscard]] Vector stabilised(Derivation& derivation, Vector rates_of_rates);

/// q - N M^-1 A^T S^-1 f with S = A M^-1 A^T of positions, and there v - M^-1 A^T S^-1 r of all.
/// Throws ZeroPivot.
struct ProjectedState {
  Vector coordinates;
  Vector rates;
};
[[nodiscard]] ProjectedState projected(Derivation& derivation);

/// u = (B^T G B)^-1 B^T G tau with G = M^-1 - M^-1 A^T S^-1 A M^-1 and tau = M a + bias, lambda =
/// S^-1 A M^-1 (tau - B u), and tau - B u - A^T lambda. Throws ZeroPivot.
struct ConstrainedInverse {
  Vector inputs;
  Vector multipliers;
  Vector unbalanced;
};
[[nodiscard]] ConstrainedInverse constrained_inverse_dynamics(Derivation& derivation);

/// All rates and accelerations from those of OutputRequest::independent, i, with d the others and
/// A_d square: A_d v_d = -r(v_d = 0), A_d a_d = -(A_i a_i + gamma). Solved by A_d A_d^T, whose
/// condition is that of A_d squared, as that of S is. Throws ZeroPivot.
struct Completed {
  Vector rates;
  Vector accelerations;
};
[[nodiscard]] Completed completed(Derivation& derivation, const OutputRequest& request);

// Forward dynamics M a = B u - bias + A^T lambda, A a = -gamma - 2 zeta omega r - omega^2 f, and
// derivatives of the dynamics. With constraints they are those of these equations, in all (q, v),
// lambda among what changes:
//
//     M da = A^T dlambda - d(M a + bias - B u - A^T lambda),   A da = -d(A a + gamma + …)
//
//     inverse    tau = M a + bias:            d tau/dq, d tau/dv
//     forward    M a = B u - bias:            da/dq = -M^-1 d(M a + bias - B u)/dq at that a,
//                                             da/dv = -M^-1 d bias/dv,  da/du = M^-1 B
//     linear     x = (dq, dv):                dx/dt = A x + B du,  A = [0 1; da/dq da/dv],
//                                             B = [0; da/du]
//
// For a rotation dq is the rotation vector in its own axes; its rate is dv - w x dq, so the upper
// left block of A holds -[w]x there.
//
// Bodies in frames go by columns (tree_matrices.hpp) where every angle and offset is linear in the
// coordinates, everything else by a forward pass along each unit direction.

struct ForwardDynamics {
  Vector acceleration;
  Vector relative_pivots;  ///< of M, then of S = A M^-1 A^T
  Vector multipliers;
  Vector diagonal;  ///< of M and S: pivots mean nothing where it is 0
};
[[nodiscard]] ForwardDynamics forward_dynamics(Derivation& derivation);

/// The same without M (tree/articulated.hpp), and the operations that factorising M would take.
/// None where L is given whole, where there are constraints, masses beside frames, or more than a
/// diagonal in what [energy] T adds to M, where a velocity moves no step or several, or where M is
/// eliminated from the first velocity to the last: then the pivots would be others. Without pivots
/// M_ii is not computed.
struct ArticulatedDynamics {
  ForwardDynamics solution;
  std::size_t operations_of_factorisation = 0;
};
[[nodiscard]] std::optional<ArticulatedDynamics> articulated_dynamics(Derivation& derivation,
                                                                      bool has_pivots = true);

/// Values with the accelerations and multipliers of the motion in the place of their leaves.
[[nodiscard]] Vector along_motion(Derivation& derivation, const Vector& values);

/// n_v x n_v each, row-major.
struct InverseDerivatives {
  Vector by_position;
  Vector by_velocity;
};
[[nodiscard]] InverseDerivatives inverse_dynamics_derivatives(Derivation& derivation);

/// n_v x n_v, n_v x n_v, n_v x n_u.
struct ForwardDerivatives {
  Vector by_position;
  Vector by_velocity;
  Vector by_input;
};
[[nodiscard]] ForwardDerivatives forward_dynamics_derivatives(Derivation& derivation);

/// The parts that the derivatives, and the linearization, of many velocities are composed of.
struct ResponseParts {
  Vector mass;
  Vector force;
  ForwardDerivatives forces;  ///< -dr/dq, -dr/dv, B
  Vector rates;               ///< the upper rows of A
};

/// None below least_of_composed velocities, and where there are constraints. Throws ZeroPivot where
/// an M_ii is 0.
[[nodiscard]] std::optional<ResponseParts> response_parts(Derivation& derivation);

/// 2 n_v x 2 n_v and 2 n_v x n_u.
struct Linearization {
  Vector a;
  Vector b;
};
[[nodiscard]] Linearization linearization(Derivation& derivation);

// Functions of q and of momenta p = M v + b, b = dL/dv at v = 0. L quadratic in v. Velocities are
// solved for, and stand in the place of v in what is known as a function of (q, v): nothing is
// differentiated again. Each throws ZeroPivot. Goldstein, Poole, Safko, 3rd ed., sec. 8.1.
//
//     v = M^-1 (p - b)
//     H = p.v - L = 1/2 (p - b).v + V0 - T0
//     dq/dt = N v,   dp/dt = N^T dL/dq - [w]x p + B u + Q - dD/dv   at that v

/// H.
[[nodiscard]] GiNaC::ex hamiltonian(Derivation& derivation);

/// v.
[[nodiscard]] Vector velocities_of_momenta(Derivation& derivation);

/// n_q and n_v entries.
struct HamiltonEquations {
  Vector coordinate_rates;
  Vector momentum_rates;
};
[[nodiscard]] HamiltonEquations hamilton_equations(Derivation& derivation);

}  // namespace elgen
