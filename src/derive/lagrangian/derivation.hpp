// Derivation: a Lagrangian, and the data that all its outputs share: directions of differentiation,
// energies by degree in v, and the tree of frames.
//
// Equations (v = dq/dt; T = T2 + T1 + T0 and V = V1 + V0 by their degree in v):
//
//     M a + C v + drift + g + dD/dv = B u + Q
//     tau = M a + bias,   bias = C v + drift + g + dD/dv - Q
//
// Routes. Forces of bodies in frames are computed from twists along the tree of frames
// (tree_dynamics.hpp, tree_matrices.hpp). Inertial forces m p'' of point masses are pulled back by
// one reverse pass: sum m p''.dp/dq (d'Alembert-Lagrange; Goldstein, Poole, Safko, 3rd ed., sec.
// 1.4). All other energies use Lagrange's equation d/dt dL/dv - dL/dq: a reverse pass over the
// energy, then a forward pass in time.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "derive/formulate/chain_rule.hpp"

namespace elgen {

using Terms = std::vector<GiNaC::ex>;
using RealVector = std::vector<GiNaC::ex>;

/// Terms of the energies by degree in v; point masses and bodies in frames are not included. If the
/// model gives L, then V1 = -L1 and V0 = -L0.
struct GradedEnergies {
  Terms kinetic2 = {};
  Terms kinetic1 = {};
  Terms kinetic0 = {};
  Terms potential1 = {};
  Terms potential0 = {};
};

class KinematicTree;

class Derivation {
 public:
  explicit Derivation(const Lagrangian& source);
  Derivation(const Derivation&) = delete;
  Derivation& operator=(const Derivation&) = delete;

  Lagrangian lagrangian;     ///< a copy, because derivation appends definitions
  Definitions& definitions;  ///< the definitions of `lagrangian`
  const Symbols& symbols;

  Tangent motion_rate;                ///< d/dt along the motion: q -> dq/dt, v -> a, t -> 1
  Tangent rate_without_acceleration;  ///< q -> dq/dt, v -> 0, t -> 1
  Tangent rate_at_fixed_time;         ///< q -> dq/dt, v -> 0, t -> 0
  Tangent time_partial;               ///< q -> 0, v -> 0, t -> 1: partial d/dt

  /// Terms of T - V, or of a given L; point masses and bodies in frames are not included.
  [[nodiscard]] const std::vector<WeightedTerm>& lagrangian_without_bodies() const {
    return lagrangian_terms_;
  }

  [[nodiscard]] const GradedEnergies& graded_energies();

  /// N^T sum weight dvalue/dq with dq/dt = N v: one entry per velocity.
  [[nodiscard]] RealVector gradient_by_position(const std::vector<WeightedTerm>& sum);
  /// sum weight dvalue/dv; each entry is a definition.
  [[nodiscard]] RealVector gradient_by_velocity(const std::vector<WeightedTerm>& sum);

  /// The position components of all point masses, each with the weight force(mass, axis).
  template <class Force>
  [[nodiscard]] std::vector<WeightedTerm> weighted_positions(const Force& force);

  /// d/ds along dq = N e_j (`displacement_tangent`) or along dv = e_j (`velocity_tangent`); e_j is
  /// the unit vector of velocity j.
  [[nodiscard]] Tangent displacement_tangent(std::size_t velocity);
  [[nodiscard]] Tangent velocity_tangent(std::size_t velocity);

  /// C++ identifier of a velocity.
  [[nodiscard]] std::string velocity_identifier(std::size_t velocity) const;

  [[nodiscard]] std::size_t size() const { return symbols.v.size(); }

 private:
  friend KinematicTree& tree_of(Derivation& derivation);

  std::vector<WeightedTerm> lagrangian_terms_;
  std::optional<GradedEnergies> graded_;
  std::shared_ptr<KinematicTree> tree_;  ///< no unique_ptr: KinematicTree is incomplete here
};

template <class Force>
std::vector<WeightedTerm> Derivation::weighted_positions(const Force& force) {
  std::vector<WeightedTerm> result;
  for (const PointMass& mass : lagrangian.masses) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.push_back({mass.position[axis], force(mass, axis)});
    }
  }
  return result;
}

/// The terms, each with the weight `weight`.
[[nodiscard]] std::vector<WeightedTerm> weighted_terms(const Terms& terms, int weight);
[[nodiscard]] std::vector<WeightedTerm> weighted_terms(const EnergyTerms& terms, int weight);

void append_terms(std::vector<WeightedTerm>& to, const std::vector<WeightedTerm>& from);

[[nodiscard]] RealVector negate(RealVector values);

/// left + right. If both arguments append definitions, evaluate them in separate statements:
/// compilers evaluate arguments in different orders.
[[nodiscard]] RealVector vector_sum(RealVector left, const RealVector& right);

/// The result of `derive` for a Derivation of `other`. New definitions are appended to the list of
/// `derivation`, so that earlier results of `derivation` stay valid.
template <class Derive>
[[nodiscard]] RealVector derive_with_shared_definitions(Derivation& derivation, Lagrangian other,
                                                        const Derive& derive) {
  other.definitions = derivation.definitions;
  Derivation other_derivation(other);
  RealVector result = derive(other_derivation);
  derivation.definitions = std::move(other_derivation.definitions);
  return result;
}

/// `values` after the substitution `leaves`. Each value first becomes a definition.
[[nodiscard]] RealVector define_and_substitute(Substitution& leaves, Definitions& definitions,
                                               const RealVector& values);

}  // namespace elgen
