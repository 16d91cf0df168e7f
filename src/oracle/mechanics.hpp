// Mechanics: directional derivatives of the energies at one state, from which all outputs are
// computed.
//
// w, x, y are directions (virtual displacements or rates). A call costs a few evaluations of
// energies. Source of the equations: Goldstein, Poole, Safko, Classical Mechanics, 3rd ed., 1.5 and
// 8.1.
#pragma once

#include <optional>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/oracle.hpp"
#include "oracle/energies.hpp"
#include "oracle/rotations.hpp"

namespace elgen::oracle {

using Direction = std::vector<cln::cl_R>;

/// The unit vector e_i with n entries.
[[nodiscard]] Direction unit_direction(std::size_t n, std::size_t i);

/// The state, with rationals of more than max_leaf_bits bits converted to floats.
[[nodiscard]] State shorten_rationals(const State& state);

/// The state as jets without generators.
[[nodiscard]] Motion make_motion(const State& state);

/// quantity += direction * generators, entry by entry.
template <class Number>
void displace(std::vector<Jet>& quantity, const std::vector<Number>& direction,
              Generators generators) {
  for (std::size_t i = 0; i < quantity.size(); ++i) {
    quantity[i] = quantity[i] + Jet(direction[i]) * Jet(generators, 1);
  }
}

/// q += N(q) direction * generators, to first order, with dq/dt = N(q) v.
template <class Number>
void displace_position(const Model& model, Motion& motion, const std::vector<Number>& direction,
                       Generators generators) {
  const std::vector<Jet> direction_jets(direction.begin(), direction.end());
  displace(motion.q, coordinate_rates(model, motion.q, direction_jets), generators);
}

/// q += N v along, v += a along, t += along.
template <class Number>
void advance_time(const Model& model, Motion& motion, const std::vector<Number>& a,
                  Generators along) {
  displace_position(model, motion, motion.v, along);
  displace(motion.v, a, along);
  motion.t = motion.t + Jet(along, 1);
}

/// A change x of position and y of velocity.
struct Displacement {
  Direction position = {};
  Direction velocity = {};
};

/// The point about which a scene expands energies and forces. Quantities that are not small have no
/// value in q, v and u. The expansion is the Taylor polynomial in s, at s = 1, along the motion
///
///     q0 + s (q - q0),  s v,  s a,  u0 + s (u - u0)       for small quantities, others unchanged
///
/// The result equals the joint expansion in all deviations; no formula for its terms is needed.
struct ExpansionPoint {
  unsigned order = 1;
  std::vector<std::optional<cln::cl_R>> q = {};
  std::vector<std::optional<cln::cl_R>> v = {};
  std::vector<std::optional<cln::cl_R>> u = {};
};

/// The point, evaluated at the parameters of the state; empty if the scene does not expand the
/// model.
[[nodiscard]] std::optional<ExpansionPoint> expansion_point(const Model& model, const State& state);

/// `motion` scaled by s towards the point, as ExpansionPoint defines it. Powers of s beyond `order`
/// vanish.
[[nodiscard]] Motion scale_towards(const ExpansionPoint& point, const Motion& motion,
                                   unsigned order);

class Mechanics {
 public:
  /// Keeps the evaluations at the latest `evaluations` motions, at least two.
  Mechanics(const Model& model, const State& state, std::size_t evaluations = 2);

  [[nodiscard]] std::size_t size() const { return model_.velocities.size(); }
  [[nodiscard]] Direction unit(std::size_t i) const { return unit_direction(size(), i); }
  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const Model& model() const { return model_; }

  /// v x d on the velocities of rotations, 0 elsewhere.
  [[nodiscard]] Direction cross_velocity(const Direction& d) const;

  /// w.M y, M = d2L/dv2
  [[nodiscard]] cln::cl_R mass_product(const Direction& w, const Direction& y);

  /// M, n x n for n velocities, row-major.
  [[nodiscard]] std::vector<cln::cl_R> mass_matrix();

  /// (w x by).M y, with the cross product only on the velocities of rotations. For by = v this is
  /// w.([v]x M y).
  [[nodiscard]] cln::cl_R cross_mass_product(const Direction& w, const Direction& by,
                                             const Direction& y);

  /// d/dq (w.M y) along x. Only for Lagrangians that are quadratic in the rates.
  [[nodiscard]] cln::cl_R mass_gradient(const Direction& x, const Direction& w, const Direction& y);

  /// w.dL/dv
  [[nodiscard]] cln::cl_R momentum(const Direction& w);

  /// Sets p = dL/dv and E = v.dL/dv - L of a motion, which must not use generator 0.
  void set_momenta_and_energy(Motion& motion);

  /// w.dL/dq; for rotations w is a rotation vector.
  [[nodiscard]] cln::cl_R position_gradient(const Direction& w);

  /// w.(M a + bias) = w.(d/dt dL/dv + [omega]x dL/domega - dL/dq + dD/dv - Q) with acceleration a.
  /// The term [omega]x dL/domega is for angular velocities only.
  [[nodiscard]] cln::cl_R inverse_dynamics(const Direction& w, const Direction& a);

  /// Derivative of w.(M a + bias - B u) along `along`, a displacement of q and v; u = `inputs`. For
  /// a rotation, `along.position` is a rotation vector in body axes.
  [[nodiscard]] cln::cl_R residual_slope(const Direction& w, const Displacement& along,
                                         const Direction& a, const Direction& inputs);

  /// w.dV0/dq with V0 = V(q, 0, t), or V0 = -L(q, 0, t) if the file gives L.
  [[nodiscard]] cln::cl_R gravity(const Direction& w);

  /// w.dD/dv
  [[nodiscard]] cln::cl_R dissipation_force(const Direction& w);

  /// w.Q at u = 0
  [[nodiscard]] cln::cl_R applied_force(const Direction& w);

  /// w.B y, B = dQ/du; y is a direction of the inputs.
  [[nodiscard]] cln::cl_R input_force(const Direction& w, const Direction& y);

  /// T, or 1/2 v.M v if the file gives L.
  [[nodiscard]] cln::cl_R kinetic_energy();

  /// V(q, v, t), or -L(q, 0, t) if the file gives L.
  [[nodiscard]] cln::cl_R potential_energy();

  /// V(q, 0, t)
  [[nodiscard]] cln::cl_R potential_energy_at_rest();

  /// v.dL/dv - L
  [[nodiscard]] cln::cl_R energy_function();

  /// |E| plus the absolute values of the terms of V; only |E| if the file gives L.
  [[nodiscard]] cln::cl_R energy_magnitude();

 private:
  using EnergyFunction = Jet (*)(Evaluation& at);

  /// `quantity` at a motion, or its expansion to `order` if the scene expands the model.
  template <class Quantity>
  Jet evaluate_expanded(unsigned order, const Motion& motion, const Quantity& quantity) const;
  Jet energy_at(EnergyFunction energy, const Motion& motion);
  Jet potential_at(const Motion& motion);
  Jet friction_along(const Motion& motion, const Direction& w);
  Jet exact_force_along(const Motion& motion, const Direction& w);
  Jet work_of_forces(const Motion& motion, const Direction& w);
  Jet force_along(const Motion& motion, const Direction& w);
  Jet residual(const Motion& at, const Direction& w, const Direction& a);
  Motion motion_at_rest() const;

  const Model& model_;
  State state_;
  std::optional<ExpansionPoint> expansion_point_;
  Motion base_;  ///< the state with a = 0 and u = 0
  RecentEvaluations evaluations_;
};

/// w.([v]x M y + [y]x M v + M [v]x y), v the state's velocity. [.]x acts only on the velocities of
/// rotations.
[[nodiscard]] cln::cl_R rotation_terms(Mechanics& at, const Direction& w, const Direction& y);

/// w.C v = d/dq (w.M v) v - 1/2 d/dq (v.M v) w + w.[v]x M v
[[nodiscard]] cln::cl_R velocity_force(Mechanics& at, const Direction& w);

/// w.C y = 1/2 (d/dq (w.M y) v + d/dq (w.M v) y - d/dq (y.M v) w + rotation_terms). C y is half the
/// derivative of C v by v along y, which makes dM/dt - 2 C skew-symmetric.
[[nodiscard]] cln::cl_R coriolis_matrix_product(Mechanics& at, const Direction& w,
                                                const Direction& y);

/// w.bias: w.(M a + bias) at a = 0.
[[nodiscard]] cln::cl_R bias(Mechanics& at, const Direction& w);

/// w.tau at the acceleration of the state.
[[nodiscard]] cln::cl_R inverse_dynamics(Mechanics& at, const Direction& w);

/// w.drift with drift = bias - C v - g - dD/dv + Q.
[[nodiscard]] cln::cl_R drift(Mechanics& at, const Direction& w);

}  // namespace elgen::oracle
