// Columns start in the axes before their own step, where the composites are at hand and the axis of
// a turn is the same; those of a rotation, whose axes turn with it, in the axes after.
#include "derive/tree_columns.hpp"

namespace elgen {

using GiNaC::ex;

TreeColumns::TreeColumns(Tree& tree, const std::vector<TreeVariable>& variables)
    : tree_(tree),
      algebra_(tree.algebra),
      variables_(variables),
      on_step_(tree.size()),
      has_below_(tree.size(), false),
      inertias_(composite_inertias(tree)) {
  for (std::size_t i = 0; i < variables.size(); ++i) on_step_[variables[i].step].push_back(i);
  for (std::size_t k = 0; k < tree.size(); ++k) {
    const auto& parent = tree.step(k).parent;
    has_below_[k] = parent && (has_below_[*parent] || !on_step_[*parent].empty());
  }
}

void TreeColumns::make_rates() {
  if (!rates_.empty()) return;
  twists_ = tree_twists(tree_, tree_.derivation().frozen);
  rates_ = composite_rates(tree_, twists_);
}

Twist TreeColumns::twist_below(std::uint32_t step) const {
  const auto& parent = tree_.step(step).parent;
  return parent ? twists_[*parent] : Twist{};
}

/// twist x S = (w x S_w; v x S_w + w x S_v)
Twist TreeColumns::unit_rate(const TreeVariable& variable, const Twist& twist) {
  Twist rate;
  rate.spin = algebra_.cross(twist.spin, variable.spin);
  const ExVector3 of_spin = algebra_.cross(twist.velocity, variable.spin);
  const ExVector3 of_velocity = algebra_.cross(twist.spin, variable.velocity);
  rate.velocity = algebra_.add(of_spin, of_velocity);
  return rate;
}

SpatialForce TreeColumns::column(ColumnKind kind, const TreeVariable& variable) {
  const std::uint32_t step = variable.step;
  const bool is_after = variable.velocity_index.has_value();
  const CompositeInertia inertia =
      is_after ? inertias_[step] : to_parent(tree_, step, inertias_[step]);
  if (kind == ColumnKind::inertia) {
    return momentum(algebra_, inertia, variable.spin, variable.velocity);
  }
  make_rates();
  const CompositeRate rate = is_after ? rates_[step] : to_parent(tree_, step, rates_[step]);
  const ExVector3& s = variable.spin;
  SpatialForce linear;
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_transposed = kind == ColumnKind::transposed;
    const std::array<std::size_t, 3> row =
        is_transposed ? std::array<std::size_t, 3>{i, 3 + i, 6 + i}
                      : std::array<std::size_t, 3>{3 * i, 3 * i + 1, 3 * i + 2};
    linear.moment[i] =
        algebra_.define(rate.a[row[0]] * s[0] + rate.a[row[1]] * s[1] + rate.a[row[2]] * s[2]);
  }
  if (kind == ColumnKind::transposed) {
    // (-[P]x)^T S_v = [P]x S_v
    linear.moment = algebra_.add(linear.moment, algebra_.cross(rate.momentum, variable.velocity));
    return linear;
  }
  linear.force = algebra_.cross(s, rate.momentum);
  const Twist twist = is_after ? twists_[step] : twist_below(step);
  const Twist s_rate = unit_rate(variable, twist);
  const SpatialForce carried = momentum(algebra_, inertia, s_rate.spin, s_rate.velocity);
  linear.force = algebra_.add(linear.force, carried.force);
  linear.moment = algebra_.add(linear.moment, carried.moment);
  return linear;
}

SpatialForce TreeColumns::before(std::uint32_t step, const SpatialForce& column) {
  SpatialForce result;
  result.force = tree_.to_parent(step, column.force);
  result.moment = tree_.to_parent(step, column.moment);
  if (tree_.step(step).kind == FrameStepKind::translation) {
    const ExVector3 lever = algebra_.cross(tree_.step(step).vector, result.force);
    result.moment = algebra_.add(result.moment, lever);
  }
  return result;
}

void TreeColumns::for_each_pair(const std::vector<ColumnKind>& kinds,
                                const std::function<void(const ColumnPair&)>& visit) {
  for (std::size_t upper = 0; upper < variables_.size(); ++upper) {
    std::vector<SpatialForce> columns;
    for (const ColumnKind kind : kinds) columns.push_back(column(kind, variables_[upper]));
    for (const std::size_t other : on_step_[variables_[upper].step]) {
      visit({upper, other, other != upper, columns});
    }
    visit_below(upper, std::move(columns), visit);
  }
}

void TreeColumns::visit_below(std::size_t upper, std::vector<SpatialForce> columns,
                              const std::function<void(const ColumnPair&)>& visit) {
  const auto pass = [&](std::uint32_t step) {
    for (SpatialForce& column : columns) column = before(step, column);
  };
  std::uint32_t step = variables_[upper].step;
  if (!has_below_[step]) return;
  if (variables_[upper].velocity_index) pass(step);
  while (has_below_[step]) {
    step = *tree_.step(step).parent;
    for (const std::size_t lower : on_step_[step]) visit({upper, lower, false, columns});
    if (has_below_[step]) pass(step);
  }
}

ex TreeColumns::along(std::size_t variable, const SpatialForce& column) {
  const TreeVariable& s = variables_[variable];
  const ex turning = algebra_.dot(s.spin, column.moment);
  return turning + algebra_.dot(s.velocity, column.force);
}

ex TreeColumns::along_rate(std::size_t variable, const SpatialForce& column) {
  make_rates();
  const Twist rate = unit_rate(variables_[variable], twists_[variables_[variable].step]);
  const ex turning = algebra_.dot(rate.spin, column.moment);
  return turning + algebra_.dot(rate.velocity, column.force);
}

}  // namespace elgen
