// Derivation: one Lagrangian with what several outputs share: directions, momenta, graded energies.
//
// Equations (v = dq/dt; T = T2 + T1 + T0 and V = V1 + V0 by their degree in v):
//
//     M a + C v + drift + g + dD/dv = B u + Q
//     tau = M a + bias,   bias = C v + drift + g + dD/dv - Q
//
// Routes. Bodies in frames go by twists along the tree of frames (tree_dynamics.hpp,
// tree_matrices.hpp). A point mass gives its inertial force m p'' at once, pulled back by one
// reverse pass: sum m p''.dp/dq (d'Alembert-Lagrange; Goldstein, Poole, Safko, 3rd ed., sec. 1.4).
// Everything else goes by Lagrange's equation: reverse over the energy, then forward in time, d/dt
// dL/dv - dL/dq.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "derive/formulate/chain_rule.hpp"

namespace elgen {

using Terms = std::vector<GiNaC::ex>;
using Vector = std::vector<GiNaC::ex>;

/// Energies that are not point masses', by degree in the rates. An L given whole has V1 = -L1, V0 =
/// -L0.
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

  Lagrangian lagrangian;     ///< grows by definitions
  Definitions& definitions;  ///< of `lagrangian`
  const Symbols& symbols;

  Tangent motion;    ///< d/dt along the motion: q -> dq/dt, v -> a, t -> 1
  Tangent coasting;  ///< the same with a = 0
  Tangent frozen;    ///< q -> dq/dt alone: time stands still
  Tangent passing;   ///< t -> 1 alone

  /// Terms of T - V beside those of point masses, or of L.
  [[nodiscard]] const std::vector<Weighted>& other_lagrangian() const { return other_; }

  [[nodiscard]] const GradedEnergies& graded();

  /// sum over `sum` of weight * dvalue/dq, along every velocity: N^T d/dq where dq/dt = N v.
  [[nodiscard]] Vector by_position(const std::vector<Weighted>& sum);
  /// The same by v, each entry a definition.
  [[nodiscard]] Vector by_velocity(const std::vector<Weighted>& sum);

  /// The point masses' positions, each weighted by what `force` gives for the mass and the axis.
  template <class Force>
  [[nodiscard]] std::vector<Weighted> on_masses(const Force& force);

  /// Along the unit virtual displacement, or the unit velocity, of one velocity.
  [[nodiscard]] Tangent displacement(std::size_t velocity);
  [[nodiscard]] Tangent unit_velocity(std::size_t velocity);

  /// C++ identifier of a velocity.
  [[nodiscard]] std::string velocity_identifier(std::size_t velocity) const;

  [[nodiscard]] std::size_t size() const { return symbols.v.size(); }

 private:
  friend Tree& tree_of(Derivation& derivation);

  std::vector<Weighted> other_;
  std::optional<GradedEnergies> graded_;
  std::shared_ptr<Tree> tree_;  ///< not unique: its type is known later
};

template <class Force>
std::vector<Weighted> Derivation::on_masses(const Force& force) {
  std::vector<Weighted> result;
  for (const PointMass& mass : lagrangian.masses) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.push_back({mass.position[axis], force(mass, axis)});
    }
  }
  return result;
}

/// `terms` with one weight for all.
[[nodiscard]] std::vector<Weighted> weighted(const Terms& terms, int weight);
[[nodiscard]] std::vector<Weighted> weighted(const EnergyTerms& terms, int weight);

void append(std::vector<Weighted>& to, const std::vector<Weighted>& from);

[[nodiscard]] Vector negative(Vector values);

/// Where both sides are derived, the left one is a variable: the order in which definitions are
/// made must not be the compiler's choice.
[[nodiscard]] Vector plus(Vector left, const Vector& right);

/// A vector of another Lagrangian over the definitions of a derivation. They are only appended to,
/// so that what the derivation knows of earlier ones stays true.
template <class Derive>
[[nodiscard]] Vector derived_apart(Derivation& derivation, Lagrangian other, const Derive& derive) {
  other.definitions = derivation.definitions;
  Derivation apart(other);
  Vector result = derive(apart);
  derivation.definitions = std::move(apart.definitions);
  return result;
}

/// The values with leaves replaced, by way of a definition of each.
[[nodiscard]] Vector substituted(Substitution& leaves, Definitions& definitions,
                                 const Vector& values);

}  // namespace elgen
