// Columns: what a unit twist of one variable asks of everything it carries, passed on to the steps
// below. The mass matrix, the Coriolis matrix and the derivatives of inverse dynamics are products
// of such columns with the unit twists met on the way to the root.
#pragma once

#include <functional>

#include "derive/composite_rate.hpp"
#include "derive/tree_dynamics.hpp"
#include "derive/tree_variables.hpp"

namespace elgen {

/// With S the unit twist, S' its rate twist x S, I and B the composites (see tree_matrices.hpp).
enum class ColumnKind : unsigned char {
  inertia,     ///< I S
  rate,        ///< I S' + B S
  transposed,  ///< B^T S
};

/// Columns of `upper` where its way to the root meets `lower`. `is_mutual`: both belong to one
/// step, and the pair comes in both orders.
struct ColumnPair {
  std::size_t upper = 0;
  std::size_t lower = 0;
  bool is_mutual = false;
  const std::vector<SpatialForce>& columns;
};

class TreeColumns {
 public:
  TreeColumns(Tree& tree, const std::vector<TreeVariable>& variables);

  /// Calls for every variable with itself, its step's others, and every variable below.
  void for_each_pair(const std::vector<ColumnKind>& kinds,
                     const std::function<void(const ColumnPair&)>& visit);

  /// S . column and S' . column of a variable.
  [[nodiscard]] GiNaC::ex along(std::size_t variable, const SpatialForce& column);
  [[nodiscard]] GiNaC::ex along_rate(std::size_t variable, const SpatialForce& column);

 private:
  [[nodiscard]] SpatialForce column(ColumnKind kind, const TreeVariable& variable);
  void visit_below(std::size_t upper, std::vector<SpatialForce> columns,
                   const std::function<void(const ColumnPair&)>& visit);
  [[nodiscard]] SpatialForce before(std::uint32_t step, const SpatialForce& column);
  [[nodiscard]] Twist unit_rate(const TreeVariable& variable, const Twist& twist);
  [[nodiscard]] Twist twist_below(std::uint32_t step) const;
  void make_rates();

  Tree& tree_;
  VectorAlgebra& algebra_;
  const std::vector<TreeVariable>& variables_;
  std::vector<std::vector<std::size_t>> on_step_;  ///< variables of each step
  std::vector<bool> has_below_;                    ///< whether the way to the root meets any
  std::vector<CompositeInertia> inertias_;
  std::vector<Twist> twists_;         ///< made with the rates
  std::vector<CompositeRate> rates_;  ///< of every step, on first demand
};

}  // namespace elgen
