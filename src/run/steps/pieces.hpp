// Pieces: a motion between kinks of its forces, on which some rates are held by dry friction.
//
// At a kink in one rate v_i the force on i jumps. Both sides drive v_i back if
//
//     a_i(v_i above) < 0 < a_i(v_i below)
//
// Then v_i is held: the force is a mean of both sides, whose share s_i of the side below makes
// a_i = 0. Of several rates,
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

  /// Whether rates were asked for beyond the end of the piece since `stay` was called.
  [[nodiscard]] bool is_left() const { return is_left_; }
  void stay() { is_left_ = false; }

  /// Begins the next piece at a state, a short step after `before`: rates at a kink are held there,
  /// or moved off it to the side to which they accelerate.
  void enter(const Numbers& before, Numbers& state, double t);

  /// To be called after a step, which may round held rates.
  void keep(Numbers& state) const;

  /// The kink at which the last piece ended; "" if none did.
  [[nodiscard]] const std::string& last_kink() const { return last_kink_; }

 private:
  struct HeldRate {
    std::size_t rate = 0;
    double value = 0;
  };
  /// d(q, v, W)/dt with every held rate above its value, and the change if one is below it.
  struct Response {
    Numbers above = {};
    std::vector<Numbers> changes = {};
    Numbers accelerations = {};         ///< of the held ones
    Numbers acceleration_changes = {};  ///< n x n, row-major
  };

  [[nodiscard]] Response response(const Numbers& state, double t,
                                  const std::vector<HeldRate>& held) const;
  /// A distance from a kink at which its side is certain and all else hardly changes.
  [[nodiscard]] double nudge(double value) const;
  [[nodiscard]] bool is_held(std::size_t kink) const;
  [[nodiscard]] double root(std::size_t kink, Numbers from, const Numbers& to, double t);
  [[nodiscard]] bool can_hold(const HeldRate& held, Numbers state, double t) const;
  void hold(const std::vector<HeldRate>& candidates, Numbers& state, double t);

  System& system_;
  KinkWatch kinks_;
  double tolerance_;
  std::vector<int> sides_ = {};
  std::vector<HeldRate> held_ = {};
  bool is_left_ = false;
  std::string last_kink_ = {};
};

}  // namespace elgen
