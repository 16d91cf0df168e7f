// RankWatch: whether M and A keep their ranks along a run, so that accelerations are determined.
//
//     M = L D L^T,   B = A diag(M)^(-1/2),   B B^T = L' D' L'^T
//
// Rank is nearly lost where D_i / M_ii or D'_k falls far below its largest value on the way;
// D'_k / (B B^T)_kk would stay 1 where a row of A vanishes. A step may jump over such a place: then
// D_i changes its sign, or what a row of B has beside the rows before it turns round.
#pragma once

#include <string>
#include <utility>

#include "run/steps/system.hpp"

namespace elgen {

class RankWatch {
 public:
  /// `hint`: what to do where rank is lost.
  RankWatch(System& system, std::string hint) : system_(system), hint_(std::move(hint)) {}

  /// At the start and after every step: E624 where rank is nearly lost, or was since the last look.
  [[nodiscard]] Diagnostics look(const Numbers& state, double t);

  /// ": the pivot of `dot(x)` in M is 1.0e-12 of its largest", at the last look; "" where none
  /// fell.
  [[nodiscard]] std::string weakest() const;

 private:
  void measure(const Numbers& state, double t);
  [[nodiscard]] double share(std::size_t i) const;
  [[nodiscard]] std::string name(std::size_t i) const;
  [[nodiscard]] std::string lost(const Numbers& pivots_before, const Numbers& rows_before) const;

  System& system_;
  std::string hint_;
  Numbers pivots_ = {};  ///< D_i / M_ii of velocities, D'_k of constraints, D_i of velocities
  Numbers largest_ = {};
  Numbers rows_ = {};  ///< B
};

}  // namespace elgen
