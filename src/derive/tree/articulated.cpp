// The inward pass computes articulated inertias and eliminates the joints; the outward pass
// computes accelerations. Bodies that no joint separates are summed as composite inertias, which
// have 10 entries instead of 21.
#include "derive/tree/articulated.hpp"

#include <algorithm>
#include <utility>

#include "derive/lagrangian/symmetric_solve.hpp"
#include "derive/tree/tree_matrices.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// (moment; force) = [A H; H^T M] (angular; linear).
struct ArticulatedInertia {
  Symmetric3 spin{0, 0, 0, 0, 0, 0};
  ExMatrix3 coupling = {0, 0, 0, 0, 0, 0, 0, 0, 0};
  Symmetric3 mass{0, 0, 0, 0, 0, 0};

  /// Entry of the 6 x 6 matrix, i <= j.
  [[nodiscard]] ex& entry(std::size_t i, std::size_t j) {
    if (j < 3) return spin[symmetric_index(i, j)];
    return i < 3 ? coupling[3 * i + j - 3] : mass[symmetric_index(i - 3, j - 3)];
  }
};

void accumulate(VectorAlgebra& algebra, const ArticulatedInertia& from, ArticulatedInertia& to) {
  for (std::size_t i = 0; i < 6; ++i) {
    to.spin[i] = algebra.define(to.spin[i] + from.spin[i]);
    to.mass[i] = algebra.define(to.mass[i] + from.mass[i]);
  }
  for (std::size_t i = 0; i < 9; ++i) {
    to.coupling[i] = algebra.define(to.coupling[i] + from.coupling[i]);
  }
}

/// Adds the rigid body `from` to `to`: A += I, H += [h]x, M += m 1.
void accumulate(VectorAlgebra& algebra, const CompositeInertia& from, ArticulatedInertia& to) {
  for (std::size_t i = 0; i < 6; ++i) {
    to.spin[i] = algebra.define(to.spin[i] + from.inertia[i]);
  }
  for (const auto& [i, j, k] : cyclic_axes) {
    to.mass[i] = algebra.define(to.mass[i] + from.mass);
    to.coupling[3 * i + j] = algebra.define(to.coupling[3 * i + j] - from.moment[k]);
    to.coupling[3 * j + i] = algebra.define(to.coupling[3 * j + i] + from.moment[k]);
  }
}

/// `c` re-expressed in the parent frame of a translation by p (equations in articulated.hpp).
ArticulatedInertia translate_inertia(VectorAlgebra& algebra, const ArticulatedInertia& c,
                                     const ExVector3& p) {
  ArticulatedInertia result = c;
  ExMatrix3& moved = result.coupling;
  for (std::size_t column = 0; column < 3; ++column) {
    ExVector3 of_mass;
    for (std::size_t row = 0; row < 3; ++row) of_mass[row] = c.mass[symmetric_index(row, column)];
    const ExVector3 lever = algebra.cross(p, of_mass);
    for (std::size_t row = 0; row < 3; ++row) {
      moved[3 * row + column] = algebra.define(moved[3 * row + column] + lever[row]);
    }
  }
  const ExMatrix3& own = c.coupling;
  for (const auto& [i, j, k] : cyclic_axes) {
    const ex beside_j = algebra.define(own[3 * i + j] + moved[3 * i + j]);
    const ex beside_k = algebra.define(own[3 * i + k] + moved[3 * i + k]);
    result.spin[i] = algebra.define(c.spin[i] + p[j] * beside_k - p[k] * beside_j);
    const ex of_moved = p[j] * moved[3 * j + k] - p[k] * moved[3 * j + j];
    const ex of_own = p[k] * own[3 * i + i] - p[i] * own[3 * i + k];
    ex& across = result.spin[symmetric_index(i, j)];
    across = algebra.define(across + of_moved + of_own);
  }
  return result;
}

ArticulatedInertia to_parent(KinematicTree& tree, std::size_t transform,
                             const ArticulatedInertia& c) {
  if (tree.transform(transform).kind == TransformKind::translation) {
    return translate_inertia(tree.algebra, c, tree.transform(transform).vector);
  }
  ArticulatedInertia result;
  result.spin = to_parent(tree, transform, c.spin);
  result.coupling = to_parent(tree, transform, c.coupling);
  result.mass = to_parent(tree, transform, c.mass);
  return result;
}

/// I S
SpatialForce inertia_times_twist(VectorAlgebra& algebra, const ArticulatedInertia& c,
                                 const Twist& s) {
  SpatialForce result;
  const ExVector3 moment_of_spin = product(algebra, c.spin, s.spin);
  const ExVector3 moment_of_shift = algebra.product(c.coupling, s.velocity);
  result.moment = algebra.add(moment_of_spin, moment_of_shift);
  const ExVector3 force_of_spin = algebra.product(transposed(c.coupling), s.spin);
  const ExVector3 force_of_shift = product(algebra, c.mass, s.velocity);
  result.force = algebra.add(force_of_spin, force_of_shift);
  return result;
}

/// S.p
ex scalar_product(VectorAlgebra& algebra, const Twist& s, const SpatialForce& p) {
  const ex turning = algebra.dot(s.spin, p.moment);
  return algebra.define(turning + algebra.dot(s.velocity, p.force));
}

/// Three angular components, then three linear components.
using SpatialComponents = std::array<ex, 6>;

SpatialComponents components(const ExVector3& angular, const ExVector3& linear) {
  return {angular[0], angular[1], angular[2], linear[0], linear[1], linear[2]};
}

SpatialForce to_spatial_force(const SpatialComponents& p) {
  return {{p[3], p[4], p[5]}, {p[0], p[1], p[2]}};
}

/// Index of the only non-zero component; none if the number of non-zero components is not 1.
std::optional<std::size_t> single_component(const SpatialComponents& s) {
  std::optional<std::size_t> single;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s[i].is_zero()) continue;
    if (single) return std::nullopt;
    single = i;
  }
  return single;
}

/// For each transform, the indices of the velocities that move it, ascending.
std::vector<std::vector<std::uint32_t>> velocities_by_transform(
    const KinematicTree& tree, const std::vector<TreeJoint>& joints) {
  std::vector<std::vector<std::uint32_t>> result(tree.size());
  for (std::uint32_t i = 0; i < joints.size(); ++i) result[joints[i].transform].push_back(i);
  return result;
}

bool ancestors_come_first(const KinematicTree& tree, const std::vector<TreeJoint>& joints) {
  const auto velocities_of = velocities_by_transform(tree, joints);
  std::vector<std::uint32_t> next(tree.size(), 0);  // 1 + the last velocity that moves it
  for (std::size_t k = 0; k < tree.size(); ++k) {
    const auto& parent = tree.transform(k).parent;
    if (parent) next[k] = next[*parent];
    if (velocities_of[k].empty()) continue;
    if (velocities_of[k].front() < next[k]) return false;
    next[k] = velocities_of[k].back() + 1;
  }
  return true;
}

class ArticulatedRecursion {
 public:
  ArticulatedRecursion(KinematicTree& tree, const std::vector<TreeJoint>& joints,
                       const RealVector& forces, const RealVector& armatures)
      : tree_(tree),
        algebra_(tree.algebra),
        joints_(joints),
        forces_(forces),
        armatures_(armatures),
        velocities_by_transform_(velocities_by_transform(tree, joints)),
        inertias_(tree.size()),
        eliminated_joints_(joints.size()) {}

  ArticulatedMotion run(bool has_diagonal) {
    ArticulatedMotion motion;
    if (has_diagonal) motion.diagonal = diagonal_of_mass();
    initialise_inertias();
    for (std::size_t k = tree_.size(); k-- > 0;) {
      const NameScope articulated = tree_.name_scope("articulated", k);
      if (!velocities_by_transform_[k].empty()) {
        accumulate(algebra_, std::exchange(rigid_inertias_[k], {}), inertias_[k]);
      }
      for (auto i = velocities_by_transform_[k].rbegin(); i != velocities_by_transform_[k].rend();
           ++i) {
        eliminate_velocity(*i);
      }
      add_to_parent(k);
    }
    motion.acceleration = outward_pass();
    for (const EliminatedJoint& joint : eliminated_joints_) motion.pivots.push_back(joint.pivot);
    return motion;
  }

 private:
  struct EliminatedJoint {
    ex pivot = 0;             ///< D
    ex own_acceleration = 0;  ///< e/D
    SpatialForce gain = {};   ///< L
  };

  RealVector diagonal_of_mass() {
    const std::vector<CompositeInertia> carried = composite_inertias(tree_);
    RealVector result;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const NameScope diagonal = tree_.name_scope("diagonal", joints_[i].transform);
      const Twist& s = joints_[i].unit_twist;
      const SpatialForce column =
          spatial_momentum(algebra_, carried[joints_[i].transform], s.spin, s.velocity);
      result.push_back(algebra_.define(scalar_product(algebra_, s, column) + armatures_[i]));
    }
    return result;
  }

  /// Initialises I and p of each transform from the bodies on that transform.
  void initialise_inertias() {
    Tangent& coasting = tree_.derivation().rate_without_acceleration;
    const std::vector<TransformMotion> motions = tree_motions(tree_, {coasting, coasting, true});
    bias_forces_ = inertial_forces_on_transforms(tree_, tree_.bodies(), motions);
    rigid_inertias_ = sum_over_bodies<CompositeInertia>(
        tree_, [&](const RigidBody& body) { return inertia_about_origin(algebra_, body); });
  }

  /// Computes I -= L U^T and p += L e for the joint of `velocity`. If S has a single non-zero
  /// component s, at index k, row and column k of the new I are J/D times row and column k of I, so
  /// that no difference cancels. If the armature J is also 0, this row and column are 0, and
  /// component k of the new p is Q/s.
  void eliminate_velocity(std::uint32_t velocity) {
    const TreeJoint& joint = joints_[velocity];
    const ex& armature = armatures_[velocity];
    ArticulatedInertia& inertia = inertias_[joint.transform];
    const SpatialForce moving = inertia_times_twist(algebra_, inertia, joint.unit_twist);
    const ex pivot = algebra_.define(scalar_product(algebra_, joint.unit_twist, moving) + armature);
    if (pivot.is_zero()) throw ZeroPivot(RowKind::velocities, velocity, false);
    const ex reciprocal = algebra_.define(1 / pivot);
    const SpatialComponents unit = components(joint.unit_twist.spin, joint.unit_twist.velocity);
    const SpatialComponents u = components(moving.moment, moving.force);
    const auto axis = single_component(unit);
    const bool is_free_axis = axis && armature.is_zero();
    SpatialComponents share;
    for (std::size_t i = 0; i < 6; ++i) share[i] = algebra_.define(u[i] * reciprocal);
    if (is_free_axis) share[*axis] = algebra_.define(1 / unit[*axis]);
    const ex held = algebra_.define(armature * reciprocal);
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = i; j < 6; ++j) {
        ex& entry = inertia.entry(i, j);
        const bool is_along = axis == i || axis == j;
        entry = algebra_.define(is_along ? held * entry : entry - share[i] * u[j]);
      }
    }
    SpatialForce& force = bias_forces_[joint.transform];
    const ex joint_residual =
        algebra_.define(forces_[velocity] - scalar_product(algebra_, joint.unit_twist, force));
    SpatialComponents passed = components(force.moment, force.force);
    for (std::size_t i = 0; i < 6; ++i)
      passed[i] = algebra_.define(passed[i] + share[i] * joint_residual);
    if (is_free_axis) passed[*axis] = algebra_.define(forces_[velocity] / unit[*axis]);
    force = to_spatial_force(passed);
    eliminated_joints_[velocity] = {pivot, algebra_.define(joint_residual * reciprocal),
                                    to_spatial_force(share)};
  }

  void add_to_parent(std::size_t k) {
    const auto& parent = tree_.transform(k).parent;
    if (!parent) return;
    accumulate(algebra_, tree_.force_to_parent(k, bias_forces_[k]), bias_forces_[*parent]);
    accumulate(algebra_, to_parent(tree_, k, rigid_inertias_[k]), rigid_inertias_[*parent]);
    accumulate(algebra_, to_parent(tree_, k, inertias_[k]), inertias_[*parent]);
  }

  /// `from`, a twist of the parent frame of transform k, re-expressed in the child frame of k.
  Twist to_child_frame(std::size_t k, const Twist& from) {
    if (tree_.transform(k).kind == TransformKind::translation) {
      const ExVector3 lever = algebra_.cross(from.spin, tree_.transform(k).vector);
      return {from.spin, algebra_.add(from.velocity, lever)};
    }
    return {tree_.to_child(k, from.spin), tree_.to_child(k, from.velocity)};
  }

  RealVector outward_pass() {
    RealVector accelerations(joints_.size());
    std::vector<Twist> motions;  // d
    for (std::size_t k = 0; k < tree_.size(); ++k) {
      const NameScope outward = tree_.name_scope("outward", k);
      const auto& parent = tree_.transform(k).parent;
      Twist motion = parent ? to_child_frame(k, motions[*parent]) : Twist{};
      for (const std::uint32_t i : velocities_by_transform_[k]) {
        const Twist& unit = joints_[i].unit_twist;
        const ex of_carrier = scalar_product(algebra_, motion, eliminated_joints_[i].gain);
        const ex& a = accelerations[i] =
            algebra_.define(eliminated_joints_[i].own_acceleration - of_carrier);
        motion.spin = algebra_.add(motion.spin, algebra_.scale(a, unit.spin));
        motion.velocity = algebra_.add(motion.velocity, algebra_.scale(a, unit.velocity));
      }
      motions.push_back(motion);
    }
    return accelerations;
  }

  KinematicTree& tree_;
  VectorAlgebra& algebra_;
  const std::vector<TreeJoint>& joints_;
  const RealVector& forces_;
  const RealVector& armatures_;
  std::vector<std::vector<std::uint32_t>> velocities_by_transform_;
  std::vector<SpatialForce> bias_forces_;  ///< p
  std::vector<CompositeInertia>
      rigid_inertias_;  ///< of bodies that no joint separates from the transform
  std::vector<ArticulatedInertia> inertias_;        ///< of the other bodies in the subtree
  std::vector<EliminatedJoint> eliminated_joints_;  ///< by velocity
};

}  // namespace

std::optional<std::vector<TreeJoint>> tree_joints(KinematicTree& tree) {
  const TreeVariables variables = tree_variables(tree);
  if (!variables.is_complete) return std::nullopt;
  std::vector<std::optional<TreeJoint>> known(tree.derivation().size());
  VectorAlgebra& algebra = tree.algebra;
  for (const TreeVariable& variable : variables.list) {
    for (const JacobianEntry& slope : jacobian_row(tree, variable)) {
      std::optional<TreeJoint>& joint = known[slope.velocity];
      if (!joint) joint = TreeJoint{variable.transform};
      if (joint->transform != variable.transform) return std::nullopt;
      const ExVector3 spin = algebra.scale(slope.value, variable.spin);
      const ExVector3 velocity = algebra.scale(slope.value, variable.velocity);
      joint->unit_twist.spin = algebra.add(joint->unit_twist.spin, spin);
      joint->unit_twist.velocity = algebra.add(joint->unit_twist.velocity, velocity);
    }
  }
  std::vector<TreeJoint> joints;
  for (const std::optional<TreeJoint>& joint : known) {
    if (!joint) return std::nullopt;
    joints.push_back(*joint);
  }
  if (!ancestors_come_first(tree, joints)) return std::nullopt;
  return joints;
}

ArticulatedMotion articulated_motion(KinematicTree& tree, const std::vector<TreeJoint>& joints,
                                     const RealVector& forces, const RealVector& armatures,
                                     bool has_diagonal) {
  return ArticulatedRecursion(tree, joints, forces, armatures).run(has_diagonal);
}

std::size_t count_factorisation_operations(const KinematicTree& tree,
                                           const std::vector<TreeJoint>& joints) {
  const auto velocities_of = velocities_by_transform(tree, joints);
  std::vector<std::size_t> moving(tree.size(), 0);  // number of velocities that move transform k
  std::size_t total = 0;
  for (std::size_t k = 0; k < tree.size(); ++k) {
    const auto& parent = tree.transform(k).parent;
    if (parent) moving[k] = moving[*parent];
    for (std::size_t i = 0; i < velocities_of[k].size(); ++i) {
      total += moving[k] * (moving[k] + 2);
      ++moving[k];
    }
  }
  return total;
}

}  // namespace elgen
