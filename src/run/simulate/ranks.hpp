// RankWatch: checks along a run that M and A keep full rank, because otherwise the accelerations
// are not determined.
//
//     M = L D L^T,   B = A diag(M)^(-1/2),   B B^T = L' D' L'^T
//
// A rank is nearly lost if D_i / M_ii or D'_k falls far below its largest value so far. The ratio
// D'_k / (B B^T)_kk would not show this, because it does not change if row k of A shrinks to 0. A
// step may jump over a state at which rank is lost. Then D_i changes its sign, or the component of
// a row of B orthogonal to the earlier rows reverses its direction.
#pragma once

#include <string>
#include <utility>

#include "run/steps/system.hpp"

namespace elgen {

class RankWatch {
 public:
  /// `hint`: the hint of E624.
  RankWatch(SimulatedSystem& system, std::string hint) : system_(system), hint_(std::move(hint)) {}

  /// Call this at the start and after every step. E624 if a rank is nearly lost, or if it was lost
  /// since the last call.
  [[nodiscard]] Diagnostics check_ranks(const Numbers& state, double t);

  /// The pivot that fell most, at the last check_ranks(): ": the pivot of `dot(x)` in M is 1.0e-12
  /// of its largest value". "" if no pivot fell by more than four digits.
  [[nodiscard]] std::string weakest_pivot_text() const;

 private:
  void measure_pivots(const Numbers& state, double t);
  [[nodiscard]] double pivot_ratio(std::size_t i) const;
  [[nodiscard]] std::string pivot_name(std::size_t i) const;
  [[nodiscard]] std::string rank_loss_text(const Numbers& pivots_before,
                                           const Numbers& rows_before) const;

  SimulatedSystem& system_;
  std::string hint_;
  Numbers pivots_ = {};  ///< D_i / M_ii by velocity, then D'_k by constraint, then D_i by velocity
  Numbers largest_ = {};
  Numbers scaled_rows_ = {};  ///< B
};

}  // namespace elgen
