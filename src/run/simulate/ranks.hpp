// RankWatch: checks that M and A keep their ranks along a run, so that accelerations are
// determined.
//
//     M = L D L^T,   B = A diag(M)^(-1/2),   B B^T = L' D' L'^T
//
// Rank is nearly lost if D_i / M_ii or D'_k falls far below its largest value so far. The ratio
// D'_k / (B B^T)_kk cannot show this: it remains 1 if a row of A vanishes. A step may jump over a
// loss of rank. Then D_i changes its sign, or the part of a row of B orthogonal to the earlier rows
// is reversed.
#pragma once

#include <string>
#include <utility>

#include "run/steps/system.hpp"

namespace elgen {

class RankWatch {
 public:
  /// `hint`: the remedy that E624 names.
  RankWatch(System& system, std::string hint) : system_(system), hint_(std::move(hint)) {}

  /// Call at the start and after every step. E624 if rank is nearly lost, or was lost since the
  /// last call.
  [[nodiscard]] Diagnostics check_ranks(const Numbers& state, double t);

  /// ": the pivot of `dot(x)` in M is 1.0e-12 of its largest", at the last check_ranks(); "" if no
  /// pivot fell.
  [[nodiscard]] std::string weakest_pivot_text() const;

 private:
  void measure_pivots(const Numbers& state, double t);
  [[nodiscard]] double share(std::size_t i) const;
  [[nodiscard]] std::string name(std::size_t i) const;
  [[nodiscard]] std::string loss_text(const Numbers& pivots_before,
                                      const Numbers& rows_before) const;

  System& system_;
  std::string hint_;
  Numbers pivots_ = {};  ///< D_i / M_ii of velocities, D'_k of constraints, D_i of velocities
  Numbers largest_ = {};
  Numbers rows_ = {};  ///< B
};

}  // namespace elgen
