// SolutionBounds: how far rounding may take a solution of M x = b from the truth, M symmetric and
// positive definite. The bound knows M and b, but not how they were made into x:
//
//     |D^1/2 (x - x*)| <= 8 u B,   B = cond ((n + |D^-1/2 B_M D^-1/2|) |D^1/2 x*| + |D^-1/2 B_b|)
//
// D is the diagonal of M, cond the condition of S = D^-1/2 M D^-1/2 in the 2-norm, B_M and B_b are
// the bounds of M and b as they are derived, norms of matrices are Frobenius'. Where u B is not
// small against x* nothing is claimed. Higham, Accuracy and Stability of Numerical Algorithms, 2nd
// ed., theorems 10.5 and 10.6.
//
// Of accelerations and multipliers under constraints, M a = b + A^T y, A a = c, the same holds with
// K = [M A^T; A 0], (a, y) and (b, c) for M, x and b, with D^1/2 and then the lengths of the rows
// of A D^-1/2 for D^1/2, and with cond K cond M for cond: M is eliminated first, and what its
// inverse loses no good K brings back.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "verify/bounds/field_place.hpp"

namespace elgen {

/// Entries that one norm judges: sqrt(sum (w_i (x_i - x*_i))^2) <= 8 u bound.
struct SolvedColumn {
  std::vector<std::size_t> entries = {};  ///< of the field
  std::vector<Real> weights = {};
  Real bound = {};
};

class SolutionBounds {
 public:
  /// `parts`: a program with the needed_parts of a scene; null where there is none.
  SolutionBounds(const Model& model, const Program* parts, const State& state,
                 const Rounding& rounding)
      : model_(model), parts_(parts), state_(state), rounding_(rounding) {}

  /// The columns of a field that solves; `entries` are the exact ones of its whole function. Empty
  /// where the field does not solve, where a part is missing, and where u cond is more than a
  /// tenth, or an error of M may be a tenth of its smallest eigenvalue. Under constraints also of
  /// all but accelerations, multipliers and pivots: no output tells how A^T y changes with q.
  [[nodiscard]] std::vector<SolvedColumn> columns(const FieldPlace& place,
                                                  const std::vector<Bound>& entries);

 private:
  /// M, or K.
  struct Matrix {
    std::vector<Real> weights = {};  ///< D^1/2, then the lengths of the rows of A D^-1/2
    Real uncertainty = {};           ///< |D^-1/2 B_M D^-1/2|
    Real condition = {};             ///< of M, times that of K
  };

  const BoundedRun* run(OutputKind kind);
  const BoundedRun* known_run(OutputKind kind);
  const Matrix* matrix();
  [[nodiscard]] std::optional<Matrix> measured_matrix();
  [[nodiscard]] bool add_constraints(Matrix& matrix, std::vector<Bound>& entries);
  [[nodiscard]] Real bound(const std::vector<Real>& x, const std::vector<Real>& right_side) const;
  [[nodiscard]] SolvedColumn pivot(std::size_t entry, const Bound& value) const;
  std::vector<SolvedColumn> motion_columns(const FieldPlace& place,
                                           const std::vector<Bound>& entries);
  std::vector<SolvedColumn> derivative_columns(const FieldPlace& place,
                                               const std::vector<Bound>& entries);
  std::vector<Real> driven_bias();
  std::vector<Real> stabilised_bias();
  [[nodiscard]] std::vector<Real> bounds_of(const BoundedRun& matrix, std::size_t first,
                                            std::size_t width) const;
  std::vector<Real> input_column(std::size_t input);
  const BoundedRun* inverse_derivatives();
  [[nodiscard]] bool inputs_act_everywhere_alike() const;
  /// Bounds of the right side of one column of derivatives; empty where a part is missing.
  std::vector<Real> right_side(const FieldPlace& place, std::size_t column);
  std::vector<Real> state_column(bool by_velocity, std::size_t column);

  const Model& model_;
  const Program* parts_;
  const State& state_;
  const Rounding& rounding_;
  std::map<OutputKind, std::optional<BoundedRun>> runs_ = {};
  std::optional<std::optional<Matrix>> matrix_ = {};
  std::optional<std::optional<BoundedRun>> inverse_derivatives_ = {};
};

}  // namespace elgen
