// PiecewiseMotion: a motion between the kinks of its forces. Dry friction may hold rates at a kink.
//
// At a kink in one rate v_i, the force on i jumps. From both sides v_i returns to the kink if
//
//     a_i(v_i above) < 0 < a_i(v_i below)
//
// Then v_i is held: the force is a weighted mean of the forces on both sides. The weight of the
// side below is the share s_i, chosen such that a_i = 0. For several rates,
//
//     a = a(all above) + sum_k s_k (a(k below, others above) - a(all above)),   0 <= s_k <= 1
//
// Filippov, Differential Equations with Discontinuous Righthand Sides, 1988, sec. 4.
#pragma once

#include <string>
#include <vector>

#include "run/steps/kinks.hpp"
#include "run/steps/system.hpp"

namespace elgen {

class PiecewiseMotion {
 public:
  /// `tolerance`: the permitted error of a step.
  PiecewiseMotion(SimulatedSystem& system, double tolerance)
      : system_(system), kinks_(system), tolerance_(tolerance) {}

  [[nodiscard]] bool has_kinks() const { return !kinks_.empty(); }

  /// d(q, v, W)/dt on this piece; W is the work (system.hpp).
  void find_rates(const Numbers& state, Numbers& rates, double t);

  /// True if find_rates() was called at a state beyond the end of the piece since the last
  /// reset_left_piece().
  [[nodiscard]] bool has_left_piece() const { return has_left_piece_; }
  void reset_left_piece() { has_left_piece_ = false; }

  /// Begins the next piece at `state`, a short step after `before`. Rates at a kink are held, or
  /// set slightly off the kink, on the side to which they accelerate.
  void begin_piece(const Numbers& before, Numbers& state, double t);

  /// Call after a step: sets held rates exactly to their values, because a step rounds them.
  void reset_held_rates(Numbers& state) const;

  /// The kink at which the last piece ended, as typed; "" before the first kink.
  [[nodiscard]] const std::string& last_kink() const { return last_kink_; }

 private:
  struct HeldRate {
    std::size_t rate = 0;
    double value = 0;
  };
  /// d(q, v, W)/dt with all held rates above their kinks, and its change if one of these rates is
  /// below instead.
  struct RateResponse {
    Numbers rates_above = {};
    std::vector<Numbers> rate_changes = {};
    Numbers accelerations = {};         ///< a_i(all above), by held rate
    Numbers acceleration_changes = {};  ///< n x n, row-major: a_i(k below) - a_i(all above)
  };

  [[nodiscard]] RateResponse rate_response(const Numbers& state, double t,
                                           const std::vector<HeldRate>& held) const;
  /// A distance from the kink: large enough that rounding does not change the side, and so small
  /// that forces hardly change.
  [[nodiscard]] double kink_distance(double value) const;
  [[nodiscard]] bool is_held(std::size_t kink) const;
  [[nodiscard]] double find_kink_rate(std::size_t kink, Numbers from, const Numbers& to, double t);
  [[nodiscard]] bool can_hold_rate(const HeldRate& held, Numbers state, double t) const;
  void hold_rates(const std::vector<HeldRate>& candidates, Numbers& state, double t);

  SimulatedSystem& system_;
  KinkWatch kinks_;
  double tolerance_;
  std::vector<int> sides_ = {};
  std::vector<HeldRate> held_rates_ = {};
  bool has_left_piece_ = false;
  std::string last_kink_ = {};
};

}  // namespace elgen
