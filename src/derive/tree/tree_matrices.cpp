// Matrices of bodies in frames: columns times twists, projected from variables to velocities.
#include "derive/tree/tree_matrices.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// Maps matrices over variables x of the tree to matrices over velocities, by J = dx/dq.
class VelocityProjection {
 public:
  VelocityProjection(KinematicTree& tree, const std::vector<TreeVariable>& variables)
      : tree_(tree) {
    for (const TreeVariable& variable : variables) rows_.push_back(jacobian_row(tree, variable));
  }

  /// Adds J^T E J; the only non-zero entry of E is `entry` at (k, l).
  void add_entry(std::size_t k, std::size_t l, const ex& entry) {
    if (entry.is_zero()) return;
    for (const JacobianEntry& row : rows_[k]) {
      for (const JacobianEntry& column : rows_[l]) {
        terms_[{row.velocity, column.velocity}].push_back(row.value * entry * column.value);
      }
    }
  }

  /// Adds J^T E dJ/dt; the only non-zero entry of E is `entry` at (k, l).
  void add_rate_entry(std::size_t k, std::size_t l, const ex& entry) {
    Tangent& frozen = tree_.derivation().rate_at_fixed_time;
    for (const JacobianEntry& column : rows_[l]) {
      const ex rate = tree_.algebra.define(frozen(column.value));
      if (rate.is_zero() || entry.is_zero()) continue;
      for (const JacobianEntry& row : rows_[k]) {
        terms_[{row.velocity, column.velocity}].push_back(row.value * entry * rate);
      }
    }
  }

  SparseMatrix take_matrix() {
    SparseMatrix result;
    for (const auto& [place, terms] : terms_) result[place] = GiNaC::add(terms);
    return result;
  }

 private:
  KinematicTree& tree_;
  std::vector<std::vector<JacobianEntry>> rows_;
  std::map<std::pair<std::size_t, std::size_t>, GiNaC::exvector> terms_;
};

}  // namespace

void add_to_dense(const SparseMatrix& matrix, RealVector& entries, std::size_t n) {
  for (const auto& [place, entry] : matrix) entries[place.first * n + place.second] += entry;
}

SparseMatrix tree_mass_matrix(KinematicTree& tree) {
  const std::vector<TreeVariable> variables = tree_variables(tree).list;
  Tangent& frozen = tree.derivation().rate_at_fixed_time;
  TreeColumns columns(tree, variables, {frozen, frozen});
  VelocityProjection projection(tree, variables);
  columns.for_each_pair({ColumnKind::inertia}, [&](const ColumnPair& pair) {
    const ex entry = columns.twist_product(pair.lower, TwistKind::unit, pair.columns[0]);
    projection.add_entry(pair.upper, pair.lower, entry);
    if (pair.upper != pair.lower && !pair.is_mutual) {
      projection.add_entry(pair.lower, pair.upper, entry);
    }
  });
  return projection.take_matrix();
}

SparseMatrix tree_coriolis_matrix(KinematicTree& tree) {
  const std::vector<TreeVariable> variables = tree_variables(tree).list;
  Tangent& frozen = tree.derivation().rate_at_fixed_time;
  TreeColumns columns(tree, variables, {frozen, frozen});
  VelocityProjection projection(tree, variables);
  const std::vector kinds{ColumnKind::rate, ColumnKind::inertia, ColumnKind::transposed};
  columns.for_each_pair(kinds, [&](const ColumnPair& pair) {
    const ex below = columns.twist_product(pair.lower, TwistKind::unit, pair.columns[0]);
    projection.add_entry(pair.lower, pair.upper, below);
    const ex mass = columns.twist_product(pair.lower, TwistKind::unit, pair.columns[1]);
    projection.add_rate_entry(pair.lower, pair.upper, mass);
    if (pair.upper == pair.lower || pair.is_mutual) return;
    const ex first = columns.twist_product(pair.lower, TwistKind::rate, pair.columns[1]);
    const ex second = columns.twist_product(pair.lower, TwistKind::unit, pair.columns[2]);
    projection.add_entry(pair.upper, pair.lower, first + second);
    projection.add_rate_entry(pair.upper, pair.lower, mass);
  });
  return projection.take_matrix();
}

bool has_linear_variables(KinematicTree& tree) {
  const TreeVariables variables = tree_variables(tree);
  if (!variables.is_complete) return false;
  for (const TreeVariable& variable : variables.list) {
    const std::vector<JacobianEntry> row = jacobian_row(tree, variable);
    if (!is_constant(tree.derivation().definitions, row)) return false;
  }
  return true;
}

TreeDerivatives tree_derivatives(KinematicTree& tree, Tangent& second) {
  const std::vector<TreeVariable> variables = tree_variables(tree).list;
  TreeColumns columns(tree, variables, {tree.derivation().rate_without_acceleration, second, true});
  VelocityProjection by_position(tree, variables);
  VelocityProjection by_velocity(tree, variables);
  const std::vector kinds{ColumnKind::inertia, ColumnKind::transposed, ColumnKind::by_position,
                          ColumnKind::by_velocity};
  columns.for_each_pair(kinds, [&](const ColumnPair& pair) {
    const SpatialForce& inertia = pair.columns[0];
    const SpatialForce& transposed = pair.columns[1];
    const auto along = [&](TwistKind kind, const SpatialForce& column) {
      return columns.twist_product(pair.lower, kind, column);
    };
    const ex of_position = 2 * along(TwistKind::first_rate, transposed);
    const ex of_second = along(TwistKind::second_rate, inertia);
    by_position.add_entry(pair.upper, pair.lower, of_position + of_second);
    const ex of_velocity = 2 * along(TwistKind::unit, transposed);
    const ex of_first = along(TwistKind::first_rate, inertia);
    const ex of_rate = along(TwistKind::rate, inertia);
    by_velocity.add_entry(pair.upper, pair.lower, of_velocity + of_first + of_rate);
    if (pair.upper == pair.lower || pair.is_mutual) return;
    by_position.add_entry(pair.lower, pair.upper, along(TwistKind::unit, pair.columns[2]));
    by_velocity.add_entry(pair.lower, pair.upper, along(TwistKind::unit, pair.columns[3]));
  });
  TreeDerivatives result;
  result.by_position = by_position.take_matrix();
  result.by_velocity = by_velocity.take_matrix();
  return result;
}

}  // namespace elgen
