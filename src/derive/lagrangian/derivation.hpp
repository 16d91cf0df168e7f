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
using Vector = std::vector<GiNaC::ex>;

/// Terms of the energies without point masses and bodies in frames, by degree in v. If the model
/// gives L, then V1 = -L1 and V0 = -L0.
struct GradedEnergies {
  Terms kinetic2 = {};
  Terms kinetic1 = {};
  Terms kinetic0 = {};
  Terms potential1 = {};
  Terms potential0 = {};
};

class Tree;

class Derivation {
 public:
  explicit Derivation(const Lagrangian& source);
  Derivation(const Derivation&) = delete;
  Derivation& operator=(const Derivation&) = delete;

  Lagrangian lagrangian;     ///< a copy, because derivation appends definitions
  Definitions& definitions;  ///< of `lagrangian`
  const Symbols& symbols;

  Tangent motion;             ///< d/dt along the motion: q -> dq/dt, v -> a, t -> 1
  Tangent zero_acceleration;  ///< q -> dq/dt, v -> 0, t -> 1
  Tangent fixed_time;         ///< q -> dq/dt, v -> 0, t -> 0
  Tangent time_partial;       ///< q -> 0, v -> 0, t -> 1: partial d/dt

  /// Terms of T - V, or of L, without point masses and bodies in frames.
  [[nodiscard]] const std::vector<Weighted>& other_lagrangian() const { return other_; }

  [[nodiscard]] const GradedEnergies& graded();

  /// N^T sum weight dvalue/dq with dq/dt = N v: one entry per velocity.
  [[nodiscard]] Vector by_position(const std::vector<Weighted>& sum);
  /// sum weight dvalue/dv; each entry is a definition.
  [[nodiscard]] Vector by_velocity(const std::vector<Weighted>& sum);

  /// The position components of all point masses, each with the weight force(mass, axis).
  template <class Force>
  [[nodiscard]] std::vector<Weighted> weighted_positions(const Force& force);

  /// The directions dq = N e_j (`displacement`) and dv = e_j (`unit_velocity`); e_j is the unit
  /// vector of velocity j.
  [[nodiscard]] Tangent displacement(std::size_t velocity);
  [[nodiscard]] Tangent unit_velocity(std::size_t velocity);

  /// C++ identifier of a velocity.
  [[nodiscard]] std::string velocity_identifier(std::size_t velocity) const;

  [[nodiscard]] std::size_t size() const { return symbols.v.size(); }

 private:
  friend Tree& tree_of(Derivation& derivation);

  std::vector<Weighted> other_;
  std::optional<GradedEnergies> graded_;
  std::shared_ptr<Tree> tree_;  ///< not a unique_ptr, because Tree is incomplete here
};

template <class Force>
std::vector<Weighted> Derivation::weighted_positions(const Force& force) {
  std::vector<Weighted> result;
  for (const PointMass& mass : lagrangian.masses) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.push_back({mass.position[axis], force(mass, axis)});
    }
  }
  return result;
}

/// The terms, each with the weight `weight`.
[[nodiscard]] std::vector<Weighted> weighted(const Terms& terms, int weight);
[[nodiscard]] std::vector<Weighted> weighted(const EnergyTerms& terms, int weight);

void append(std::vector<Weighted>& to, const std::vector<Weighted>& from);

[[nodiscard]] Vector negative(Vector values);

/// left + right. If both arguments append definitions, evaluate them in separate statements:
/// compilers evaluate arguments in different orders.
[[nodiscard]] Vector plus(Vector left, const Vector& right);

/// The result of `derive` for a Derivation of `other` that appends its definitions to the list of
/// `derivation`. Earlier results of `derivation` stay valid, because definitions are only appended.
template <class Derive>
[[nodiscard]] Vector derive_with_shared_definitions(Derivation& derivation, Lagrangian other,
                                                    const Derive& derive) {
  other.definitions = derivation.definitions;
  Derivation apart(other);
  Vector result = derive(apart);
  derivation.definitions = std::move(apart.definitions);
  return result;
}

/// The values after a substitution of leaves. Each value becomes a definition first.
[[nodiscard]] Vector substituted(Substitution& leaves, Definitions& definitions,
                                 const Vector& values);

}  // namespace elgen
