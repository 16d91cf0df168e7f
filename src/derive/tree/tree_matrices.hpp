// Matrices of bodies in frames, by composite inertias: one column for every angle and offset,
// passed on to the steps below it.
//
// A variable x of the tree (an angle, one component of an offset, a velocity of a rotation) moves
// everything its step carries with the unit twist S. With composites at its step:
//
//     M_kl = S_l . (I_k S_k)                                     l below k
//     C_lk = S_l . (I_k S'_k + B_k S_k),   C_kl = (I_k S_k) . S'_l + (B_k^T S_k) . S_l
//
// S' is the rate of S as seen from the world, twist x S, and B = [A 0; -[P]x 0] the part of the
// momentum's rate that is linear in the twist, with P = m v + w x h and
// A = [Sigma w]x - I [w]x - [h]x [v]x of each body, Sigma = 1/2 tr(I) 1 - I. Then C is that of the
// Christoffel symbols: for a mass point m dp/dq^T d/dt(dp/dq). Echeandia, Wensing, Numerical
// Methods to Compute the Coriolis Matrix and Christoffel Symbols for Rigid-Body Systems (2021).
//
// Variables x(q, t) are mapped to coordinates by J = dx/dq: M = J^T M_x J, and
// C = J^T (C_x J + M_x dJ/dt).
//
// Columns: what a unit twist of one variable asks of everything it carries, passed on to the steps
// below. The mass matrix, the Coriolis matrix and the derivatives of inverse dynamics are products
// of such columns with the unit twists met on the way to the root.
#pragma once

#include <functional>
#include <map>

#include "derive/tree/composite.hpp"

namespace elgen {

/// A unit twist (angular; linear) in the axes after a step.
struct TreeVariable {
  std::uint32_t step = 0;
  ExVector3 spin{0, 0, 0};
  ExVector3 velocity{0, 0, 0};
  GiNaC::ex value = 0;                               ///< x(q, t)
  std::optional<std::uint32_t> velocity_index = {};  ///< of a rotation instead of x
};

/// One entry of dx/dq.
struct Coefficient {
  std::size_t velocity = 0;
  GiNaC::ex value = 0;
};

/// Variables that depend on coordinates, steps ascending. Quaternions written over coordinates have
/// none: then `is_complete` is false, and matrices are derived from forces.
struct TreeVariables {
  std::vector<TreeVariable> list = {};
  bool is_complete = true;
};

[[nodiscard]] TreeVariables tree_variables(const Tree& tree);

/// dx/dq without its zeros.
[[nodiscard]] std::vector<Coefficient> jacobian_row(Tree& tree, const TreeVariable& variable);

/// Whether no entry of any row depends on coordinates or time.
[[nodiscard]] bool is_constant(const Definitions& definitions, const std::vector<Coefficient>& row);

/// With S the unit twist of a variable, I and B the composites (see above), v and a the
/// twist and acceleration of the step before, v_own that of its own step, and f the force on all
/// that is carried:
///
///     S'  = v_own x S    rate of S             R1 = v x S,   R2 = a x S + v x R1
enum class ColumnKind : unsigned char {
  inertia,      ///< I S
  rate,         ///< I S' + B S
  transposed,   ///< B^T S
  by_position,  ///< I R2 + 2 B R1 + S x* f
  by_velocity,  ///< I (R1 + S') + 2 B S
};

/// The motions (angular; linear) of a variable that columns are multiplied with.
enum class UnitKind : unsigned char {
  unit,    ///< S
  rate,    ///< S'
  first,   ///< R1
  second,  ///< R2
};

/// Columns of `upper` where its way to the root meets `lower`, in the axes of `lower`'s home.
/// `is_mutual`: both belong to one step, and the pair comes in both orders.
struct ColumnPair {
  std::size_t upper = 0;
  std::size_t lower = 0;
  bool is_mutual = false;
  const std::vector<SpatialForce>& columns;
};

class TreeColumns {
 public:
  TreeColumns(Tree& tree, const std::vector<TreeVariable>& variables, const Acceleration& by);

  /// Calls for every variable with itself, its step's others, and every variable below.
  void for_each_pair(const std::vector<ColumnKind>& kinds,
                     const std::function<void(const ColumnPair&)>& visit);

  /// Motion . column.
  [[nodiscard]] GiNaC::ex along(std::size_t variable, UnitKind kind, const SpatialForce& column);

 private:
  /// A step's motion and what it carries, in the axes before it, or after it for rotations.
  struct Home {
    CompositeInertia inertia = {};
    CompositeRate rate = {};
    Twist own = {};          ///< of the step itself
    Twist below = {};        ///< of the step before
    StepMotion motion = {};  ///< of the step before
    SpatialForce carried = {};
  };

  [[nodiscard]] const Home& home(const TreeVariable& variable);
  [[nodiscard]] Home home_after(std::uint32_t step);
  [[nodiscard]] Home home_before(std::uint32_t step);
  void make_motions();
  [[nodiscard]] Twist motion(UnitKind kind, const TreeVariable& variable);
  [[nodiscard]] Twist crossed(const Twist& twist, const Twist& with);
  [[nodiscard]] Twist second(const Home& home, const TreeVariable& variable);
  [[nodiscard]] SpatialForce column(ColumnKind kind, const TreeVariable& variable);
  [[nodiscard]] SpatialForce of_inertia(const TreeVariable& variable, const Twist& twist);
  [[nodiscard]] SpatialForce of_rate(const TreeVariable& variable, const Twist& twist);
  [[nodiscard]] SpatialForce of_rate_transposed(const TreeVariable& variable);
  void visit_below(std::size_t upper, std::vector<SpatialForce> columns,
                   const std::function<void(const ColumnPair&)>& visit);

  Tree& tree_;
  VectorAlgebra& algebra_;
  const std::vector<TreeVariable>& variables_;
  Acceleration by_;
  std::vector<std::vector<std::size_t>> on_step_;  ///< variables of each step
  std::vector<bool> has_below_;                    ///< whether the way to the root meets any
  std::vector<CompositeInertia> inertias_;
  // On first demand, of every step:
  std::vector<Twist> twists_;
  std::vector<CompositeRate> rates_;
  std::vector<StepMotion> motions_;
  std::vector<SpatialForce> carried_;
  std::vector<std::optional<Home>> homes_;
};

/// Entries of an n_v x n_v matrix that may differ from zero, by row and column.
using SparseMatrix = std::map<std::pair<std::size_t, std::size_t>, GiNaC::ex>;

/// entries += matrix, of n columns.
void add(const SparseMatrix& matrix, Vector& entries, std::size_t n);

[[nodiscard]] SparseMatrix tree_mass_matrix(Tree& tree);
[[nodiscard]] SparseMatrix tree_coriolis_matrix(Tree& tree);

/// Whether every variable is linear in the coordinates, with constant coefficients.
[[nodiscard]] bool has_linear_variables(Tree& tree);

/// d tau/dq and d tau/dv of the inertial forces and weights; for linear variables. With
/// R1 = v x S, R2 = a x S + v x R1 (v, a of the step below, gravity an acceleration of the base):
///
///     dtau_k/dq_l = (I_k S_k).R2_l + 2 (B_k^T S_k).R1_l         l below k, or k
///     dtau_l/dq_k = S_l.(I_k R2_k + 2 B_k R1_k + S_k x* f_k)
///     dtau_k/dv_l = (I_k S_k).(R1_l + S'_l) + 2 (B_k^T S_k).S_l,   and so on
///
/// For a rotation d/dq is along the rotation vector in its own axes. Singh, Russell, Wensing,
/// Efficient Analytical Derivatives of Rigid-Body Dynamics (2022).
struct TreeDerivatives {
  SparseMatrix by_position = {};
  SparseMatrix by_velocity = {};
};
[[nodiscard]] TreeDerivatives tree_derivatives(Tree& tree, Tangent& second);

}  // namespace elgen
