// Pieces: a motion between kinks of its forces, with rates that dry friction may hold.
//
// At a kink in one rate v_i the force on i jumps. Both sides drive v_i back if
//
//     a_i(v_i above) < 0 < a_i(v_i below)
//
// Then v_i is held: the force is a mean of both sides, in which the side below has the share s_i
// that makes a_i = 0. For several rates,
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

class Pieces {
 public:
  /// `tolerance`: the error of a step.
  Pieces(System& system, double tolerance)
      : system_(system), kinks_(system), tolerance_(tolerance) {}

  [[nodiscard]] bool has_kinks() const { return !kinks_.empty(); }

  /// d(q, v, W)/dt on this piece.
  void find_rates(const Numbers& state, Numbers& rates, double t);

  /// True if find_rates() was called beyond the end of the piece after the last reset_left().
  [[nodiscard]] bool has_left_piece() const { return has_left_piece_; }
  void reset_left() { has_left_piece_ = false; }

  /// Begins the next piece at `state`, a short step after `before`. Rates at a kink are held, or
  /// moved off the kink to the side to which they accelerate.
  void begin_piece(const Numbers& before, Numbers& state, double t);

  /// Call after a step: resets held rates, which a step may round.
  void reset_held_rates(Numbers& state) const;

  /// The kink at which the last piece ended; "" before the first kink.
  [[nodiscard]] const std::string& last_kink() const { return last_kink_; }

 private:
  struct HeldRate {
    std::size_t rate = 0;
    double value = 0;
  };
  /// d(q, v, W)/dt with every held rate above its kink, and its change if one of them is below.
  struct Response {
    Numbers above = {};
    std::vector<Numbers> changes = {};
    Numbers accelerations = {};         ///< of the held rates
    Numbers acceleration_changes = {};  ///< n x n, row-major
  };

  [[nodiscard]] Response response(const Numbers& state, double t,
                                  const std::vector<HeldRate>& held) const;
  /// A distance from a kink at which the side is certain and forces hardly change.
  [[nodiscard]] double side_distance(double value) const;
  [[nodiscard]] bool is_held(std::size_t kink) const;
  [[nodiscard]] double kink_rate(std::size_t kink, Numbers from, const Numbers& to, double t);
  [[nodiscard]] bool can_hold(const HeldRate& held, Numbers state, double t) const;
  void hold(const std::vector<HeldRate>& candidates, Numbers& state, double t);

  System& system_;
  KinkWatch kinks_;
  double tolerance_;
  std::vector<int> sides_ = {};
  std::vector<HeldRate> held_ = {};
  bool has_left_piece_ = false;
  std::string last_kink_ = {};
};

}  // namespace elgen
