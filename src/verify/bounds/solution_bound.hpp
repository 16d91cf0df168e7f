// SolutionBounds: how far rounding may take a solution of M x = b from the truth, M symmetric and
// positive definite. The bound knows M and b, but not how they were made into x:
//
//     |D^1/2 (x - x*)| <= 8 u B,   B = cond ((n + |D^-1/2 B_M D^-1/2|) |D^1/2 x*| + |D^-1/2 B_b|)
//
// D is the diagonal of M, cond the condition of S = D^-1/2 M D^-1/2 in the 2-norm, B_M and B_b are
// the bounds of M and b as they are derived, norms of matrices are Frobenius'. Where u B is not
// small against x* nothing is claimed. Higham, Accuracy and Stability of Numerical Algorithms, 2nd
// ed., theorems 10.5 and 10.6.
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
  /// `parts`: a program with M, bias, the input matrix, and where derivatives of accelerations are
  /// judged, forward dynamics and the derivatives of inverse dynamics; null where there is none.
  SolutionBounds(const Program* parts, const State& state, const Rounding& rounding)
      : parts_(parts), state_(state), rounding_(rounding) {}

  /// The columns of a field that solves, whose exact entries are `entries`. Empty where the field
  /// does not solve, where a part is missing, and where u cond is more than a tenth, or an error of
  /// M may be a tenth of its smallest eigenvalue.
  [[nodiscard]] std::vector<SolvedColumn> columns(const FieldPlace& place,
                                                  const std::vector<Bound>& entries);

 private:
  struct Mass {
    std::vector<Real> weights = {};  ///< D^1/2
    Real uncertainty = {};           ///< |D^-1/2 B_M D^-1/2|
    Real condition = {};
  };

  const BoundedRun* run(OutputKind kind);
  const Mass* mass();
  [[nodiscard]] std::optional<Mass> measured_mass();
  [[nodiscard]] Real bound(const std::vector<Real>& x, const std::vector<Real>& right_side) const;
  [[nodiscard]] SolvedColumn pivot(std::size_t entry, const Bound& value) const;
  std::vector<Real> driven_bias();
  [[nodiscard]] std::vector<Real> bounds_of(const BoundedRun& matrix, std::size_t first,
                                            std::size_t width) const;
  std::vector<Real> input_column(std::size_t input);
  const BoundedRun* inverse_derivatives();
  [[nodiscard]] bool inputs_act_everywhere_alike() const;
  /// Bounds of the right side of one column of a field; empty where a part is missing.
  std::vector<Real> right_side(const FieldPlace& place, std::size_t column);
  std::vector<Real> state_column(std::size_t first, std::size_t column);

  const Program* parts_;
  const State& state_;
  const Rounding& rounding_;
  std::map<OutputKind, std::optional<BoundedRun>> runs_ = {};
  std::optional<std::optional<Mass>> mass_ = {};
  std::optional<std::optional<BoundedRun>> inverse_derivatives_ = {};
};

}  // namespace elgen
