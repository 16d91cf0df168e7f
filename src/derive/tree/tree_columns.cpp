// A column (tree_matrices.hpp) of a turn or a translation starts in the parent frame of its
// transform: the axis of a turn has the same components in both frames, and the twist of the parent
// can replace the twist of the transform. A column of a rotation starts in the child frame, because
// the axes of a rotation turn with the transform.
#include <algorithm>

#include "derive/tree/tree_matrices.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

bool depends_on_coordinates(const KinematicTree& tree, const ex& value) {
  return dependence(tree.derivation().definitions, value).has_any(Opcode::coordinate);
}

void append_variables(const KinematicTree& tree, std::uint32_t index, TreeVariables& variables) {
  const TreeTransform& transform = tree.transform(index);
  TreeVariable variable;
  variable.transform = index;
  if (transform.kind == TransformKind::turn) {
    if (!depends_on_coordinates(tree, transform.angle)) return;
    variable.spin = transform.vector;
    variable.value = transform.angle;
    variables.list.push_back(variable);
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    TreeVariable component = variable;
    if (transform.kind == TransformKind::translation) {
      if (!depends_on_coordinates(tree, transform.vector[i])) continue;
      component.velocity[i] = 1;
      component.value = transform.vector[i];
    } else if (transform.rotation) {
      component.spin[i] = 1;
      component.velocity_index = *transform.rotation + static_cast<std::uint32_t>(i);
    } else {
      continue;
    }
    variables.list.push_back(component);
  }
  if (transform.kind != TransformKind::quaternion || transform.rotation) return;
  variables.is_complete =
      variables.is_complete &&
      std::none_of(transform.quaternion.begin(), transform.quaternion.end(),
                   [&](const ex& q) { return depends_on_coordinates(tree, q); });
}

}  // namespace

TreeVariables tree_variables(const KinematicTree& tree) {
  TreeVariables variables;
  for (std::uint32_t k = 0; k < tree.size(); ++k) append_variables(tree, k, variables);
  return variables;
}

std::vector<JacobianEntry> jacobian_row(KinematicTree& tree, const TreeVariable& variable) {
  if (variable.velocity_index) return {{*variable.velocity_index, 1}};
  const RealVector row = tree.derivation().gradient_by_position({{variable.value, 1}});
  std::vector<JacobianEntry> result;
  for (std::size_t j = 0; j < row.size(); ++j) {
    if (!row[j].is_zero()) result.push_back({j, tree.algebra.define(row[j])});
  }
  return result;
}

bool is_constant(const Definitions& definitions, const std::vector<JacobianEntry>& row) {
  return std::all_of(row.begin(), row.end(), [&](const JacobianEntry& c) {
    return !dependence(definitions, c.value).has_any(Opcode::coordinate | Opcode::time);
  });
}

TreeColumns::TreeColumns(KinematicTree& tree, const std::vector<TreeVariable>& variables,
                         const AccelerationTangents& by)
    : tree_(tree),
      algebra_(tree.algebra),
      variables_(variables),
      acceleration_(by),
      variables_by_transform_(tree.size()),
      has_ancestor_variables_(tree.size(), false),
      inertias_(composite_inertias(tree)),
      quantities_(tree.size()) {
  for (std::size_t i = 0; i < variables.size(); ++i)
    variables_by_transform_[variables[i].transform].push_back(i);
  for (std::size_t k = 0; k < tree.size(); ++k) {
    const auto& parent = tree.transform(k).parent;
    has_ancestor_variables_[k] =
        parent && (has_ancestor_variables_[*parent] || !variables_by_transform_[*parent].empty());
  }
}

void TreeColumns::compute_motions() {
  if (!twists_.empty()) return;
  twists_ = tree_twists(tree_, acceleration_.velocity_tangent);
  rates_ = composite_rates(tree_, twists_);
  motions_ = tree_motions(tree_, acceleration_);
  subtree_forces_ =
      tree_.subtree_wrenches(inertial_forces_on_transforms(tree_, tree_.bodies(), motions_));
}

TreeColumns::TransformQuantities TreeColumns::quantities_in_child_frame(std::uint32_t transform) {
  TransformQuantities quantities;
  quantities.inertia = inertias_[transform];
  if (twists_.empty()) return quantities;
  quantities.rate = rates_[transform];
  quantities.own_twist = twists_[transform];
  quantities.subtree_force = subtree_forces_[transform];
  const auto& parent = tree_.transform(transform).parent;
  const TransformMotion from =
      parent ? motions_[*parent] : base_motion(tree_, acceleration_.includes_gravity);
  const Twist below = parent ? twists_[*parent] : Twist{};
  quantities.parent_twist.spin = tree_.to_child(transform, below.spin);
  quantities.parent_twist.velocity = tree_.to_child(transform, below.velocity);
  quantities.motion.spin_rate = tree_.to_child(transform, from.spin_rate);
  quantities.motion.acceleration = tree_.to_child(transform, from.acceleration);
  return quantities;
}

TreeColumns::TransformQuantities TreeColumns::quantities_in_parent_frame(std::uint32_t transform) {
  TransformQuantities quantities;
  quantities.inertia = to_parent(tree_, transform, inertias_[transform]);
  if (twists_.empty()) return quantities;
  quantities.rate = to_parent(tree_, transform, rates_[transform]);
  quantities.subtree_force = tree_.force_to_parent(transform, subtree_forces_[transform]);
  const auto& parent = tree_.transform(transform).parent;
  quantities.motion =
      parent ? motions_[*parent] : base_motion(tree_, acceleration_.includes_gravity);
  // The twist of the transform and the twist of its parent differ by a spin parallel to S (turn) or
  // by no spin (translation). So v x S is the same for both twists.
  quantities.own_twist = quantities.parent_twist = parent ? twists_[*parent] : Twist{};
  return quantities;
}

const TreeColumns::TransformQuantities& TreeColumns::quantities(const TreeVariable& variable) {
  std::optional<TransformQuantities>& known = quantities_[variable.transform];
  if (!known) {
    known = variable.velocity_index ? quantities_in_child_frame(variable.transform)
                                    : quantities_in_parent_frame(variable.transform);
  }
  return *known;
}

/// Cross product of twists: (w; v) x (s; u) = (w x s; v x s + w x u)
Twist TreeColumns::twist_cross(const Twist& twist, const Twist& with) {
  Twist result;
  result.spin = algebra_.cross(twist.spin, with.spin);
  const ExVector3 of_spin = algebra_.cross(twist.velocity, with.spin);
  const ExVector3 of_velocity = algebra_.cross(twist.spin, with.velocity);
  result.velocity = algebra_.add(of_spin, of_velocity);
  return result;
}

/// R2 = a x S + v x (v x S). With the acceleration b of the origin, a = (w'; b - w x v), and R2 is
///     (w' x s + w x (w x s); b x s + 2 v x (w x s))    for turns and rotations, S = (s; 0)
///     (0; w' x u + w x (w x u))                        for translations, S = (0; u)
Twist TreeColumns::second_rate_twist(const TransformQuantities& quantities,
                                     const TreeVariable& variable) {
  const ExVector3& w = quantities.parent_twist.spin;
  const bool is_shift = is_zero(variable.spin);
  const ExVector3& s = is_shift ? variable.velocity : variable.spin;
  const ExVector3 first = algebra_.cross(w, s);
  const ExVector3 of_rate = algebra_.cross(quantities.motion.spin_rate, s);
  const ExVector3 of_square = algebra_.cross(w, first);
  Twist result;
  (is_shift ? result.velocity : result.spin) = algebra_.add(of_rate, of_square);
  if (is_shift) return result;
  const ExVector3 of_acceleration = algebra_.cross(quantities.motion.acceleration, s);
  const ExVector3 of_velocity = algebra_.cross(quantities.parent_twist.velocity, first);
  result.velocity = algebra_.add(of_acceleration, algebra_.scale(2, of_velocity));
  return result;
}

Twist TreeColumns::variable_twist(TwistKind kind, const TreeVariable& variable) {
  const Twist unit{variable.spin, variable.velocity};
  switch (kind) {
    case TwistKind::unit:
      return unit;
    case TwistKind::rate:
      return twist_cross(quantities(variable).own_twist, unit);
    case TwistKind::first_rate:
      return twist_cross(quantities(variable).parent_twist, unit);
    case TwistKind::second_rate:
      break;
  }
  return second_rate_twist(quantities(variable), variable);
}

SpatialForce TreeColumns::inertia_product(const TreeVariable& variable, const Twist& twist) {
  return spatial_momentum(algebra_, quantities(variable).inertia, twist.spin, twist.velocity);
}

/// B (s; u) = (A s; s x P)
SpatialForce TreeColumns::rate_product(const TreeVariable& variable, const Twist& twist) {
  const CompositeRate& rate = quantities(variable).rate;
  const ExVector3& s = twist.spin;
  SpatialForce result;
  result.moment = algebra_.product(rate.a, s);
  result.force = algebra_.cross(s, rate.momentum);
  return result;
}

/// B^T (s; u) = (A^T s + P x u; 0)
SpatialForce TreeColumns::transposed_rate_product(const TreeVariable& variable) {
  const CompositeRate& rate = quantities(variable).rate;
  SpatialForce result;
  result.moment = algebra_.product(transposed(rate.a), variable.spin);
  const ExVector3 of_shift = algebra_.cross(rate.momentum, variable.velocity);
  result.moment = algebra_.add(result.moment, of_shift);
  return result;
}

SpatialForce TreeColumns::column(ColumnKind kind, const TreeVariable& variable) {
  const Twist unit{variable.spin, variable.velocity};
  if (kind == ColumnKind::inertia) return inertia_product(variable, unit);
  if (kind == ColumnKind::transposed) return transposed_rate_product(variable);
  if (kind == ColumnKind::rate) {
    SpatialForce sum = inertia_product(variable, variable_twist(TwistKind::rate, variable));
    accumulate(algebra_, rate_product(variable, unit), sum);
    return sum;
  }
  const Twist first = variable_twist(TwistKind::first_rate, variable);
  const Twist& of_b = kind == ColumnKind::by_position ? first : unit;
  const SpatialForce half = rate_product(variable, of_b);
  SpatialForce twice = half;
  accumulate(algebra_, half, twice);
  if (kind == ColumnKind::by_velocity) {
    const Twist rate = variable_twist(TwistKind::rate, variable);
    const ExVector3 spin = algebra_.add(first.spin, rate.spin);
    const ExVector3 velocity = algebra_.add(first.velocity, rate.velocity);
    SpatialForce sum = inertia_product(variable, {spin, velocity});
    accumulate(algebra_, twice, sum);
    return sum;
  }
  SpatialForce sum = inertia_product(variable, variable_twist(TwistKind::second_rate, variable));
  // S x* f = (s x n + u x f; s x f)
  const SpatialForce& f = quantities(variable).subtree_force;
  SpatialForce moved;
  const ExVector3 turned = algebra_.cross(variable.spin, f.moment);
  const ExVector3 shifted = algebra_.cross(variable.velocity, f.force);
  moved.moment = algebra_.add(turned, shifted);
  moved.force = algebra_.cross(variable.spin, f.force);
  accumulate(algebra_, twice, sum);
  accumulate(algebra_, moved, sum);
  return sum;
}

void TreeColumns::for_each_pair(const std::vector<ColumnKind>& kinds,
                                const std::function<void(const ColumnPair&)>& visit) {
  for (const ColumnKind kind : kinds) {
    if (kind != ColumnKind::inertia) compute_motions();
  }
  for (std::size_t upper = 0; upper < variables_.size(); ++upper) {
    const std::uint32_t transform = variables_[upper].transform;
    const NameScope of_upper =
        tree_.name_scope("column_" + tree_.transform(transform).name, transform);
    std::vector<SpatialForce> columns;
    for (const ColumnKind kind : kinds) columns.push_back(column(kind, variables_[upper]));
    for (const std::size_t other : variables_by_transform_[transform]) {
      visit({upper, other, other != upper, columns});
    }
    visit_ancestors(upper, std::move(columns), visit);
  }
}

void TreeColumns::visit_ancestors(std::size_t upper, std::vector<SpatialForce> columns,
                                  const std::function<void(const ColumnPair&)>& visit) {
  const auto pass = [&](std::uint32_t transform) {
    for (SpatialForce& column : columns) column = tree_.force_to_parent(transform, column);
  };
  std::uint32_t transform = variables_[upper].transform;
  if (!has_ancestor_variables_[transform]) return;
  if (variables_[upper].velocity_index) pass(transform);
  while (has_ancestor_variables_[transform]) {
    transform = *tree_.transform(transform).parent;
    const NameScope at_lower = tree_.name_scope("", transform);
    const bool is_rotation = tree_.transform(transform).rotation.has_value();
    if (!is_rotation) pass(transform);
    for (const std::size_t lower : variables_by_transform_[transform])
      visit({upper, lower, false, columns});
    if (is_rotation) pass(transform);
  }
}

ex TreeColumns::twist_product(std::size_t variable, TwistKind kind, const SpatialForce& column) {
  const Twist along = variable_twist(kind, variables_[variable]);
  const ex turning = algebra_.dot(along.spin, column.moment);
  return turning + algebra_.dot(along.velocity, column.force);
}

}  // namespace elgen
