// PiecewiseMotion: finds the sides of kinks, the rates that dry friction holds, and the shares of
// these rates.
#include "run/steps/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "numbers/echelon.hpp"

namespace elgen {
namespace {

/// The position of a rate: held at its kink, above the kink, or below the kink.
enum class RatePosition : std::uint8_t { held, above, below };

/// The shares s: s = 0 for rates above their kinks, s = 1 for rates below, and a + W s = 0 in the
/// rows of held rates. None if the equations are singular.
std::optional<Numbers> solve_shares(const Numbers& a, const Numbers& w,
                                    const std::vector<RatePosition>& places) {
  const std::size_t n = a.size();
  Numbers matrix;
  Numbers right_side;
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_held = places[i] == RatePosition::held;
    for (std::size_t k = 0; k < n; ++k) {
      matrix.push_back(is_held ? w[i * n + k] : i == k ? 1 : 0);
    }
    right_side.push_back(is_held ? -a[i] : places[i] == RatePosition::below ? 1 : 0);
  }
  return solve_linear(matrix, right_side);
}

/// The position to try next if `share` or `acceleration` contradicts `place`; otherwise `place`.
RatePosition next_position(RatePosition place, double share, double acceleration) {
  if (place == RatePosition::above) return acceleration < 0 ? RatePosition::held : place;
  if (place == RatePosition::below) return acceleration > 0 ? RatePosition::held : place;
  return share < 0 ? RatePosition::above : share > 1 ? RatePosition::below : place;
}

/// The position of each rate. Held: 0 <= s <= 1. Above: s = 0 and a >= 0. Below: s = 1 and a <= 0.
/// In each turn, the first rate that violates its condition changes its position. The turns end if
/// W is a P-matrix, such as B M^-1 B^T (Murty, Mathematical Programming 5 (1973) 213). Empty if the
/// turns do not end, or if the equations of solve_shares() are singular.
std::vector<RatePosition> solve_positions(const Numbers& a, const Numbers& w) {
  const std::size_t n = a.size();
  const std::size_t most_turns = 1000;  // no system of 20 rates needed as many
  std::vector<RatePosition> places(n, RatePosition::held);
  for (std::size_t turn = 0; turn < most_turns; ++turn) {
    const std::optional<Numbers> shares = solve_shares(a, w, places);
    if (!shares) return {};
    bool is_right = true;
    for (std::size_t i = 0; i < n && is_right; ++i) {
      double acceleration = a[i];
      for (std::size_t k = 0; k < n; ++k) acceleration += w[i * n + k] * (*shares)[k];
      const RatePosition place = next_position(places[i], (*shares)[i], acceleration);
      is_right = place == places[i];
      places[i] = place;
    }
    if (is_right) return places;
  }
  return {};
}

}  // namespace

void PiecewiseMotion::find_rates(const Numbers& state, Numbers& rates, double t) {
  if (kinks_.empty()) return system_.find_rates(state, rates, t);
  const std::vector<int> now = kinks_.sides(state, t);
  for (std::size_t k = 0; k < now.size(); ++k) {
    if (now[k] != 0 && now[k] != sides_[k] && !is_held(k)) has_left_piece_ = true;
  }
  if (held_rates_.empty()) return system_.find_rates(state, rates, t);
  const RateResponse found = rate_response(state, t, held_rates_);
  const std::optional<Numbers> shares =
      solve_shares(found.accelerations, found.acceleration_changes,
                   std::vector<RatePosition>(held_rates_.size(), RatePosition::held));
  rates = found.rates_above;
  for (std::size_t k = 0; k < held_rates_.size(); ++k) {
    const double share = shares ? (*shares)[k] : -1;
    if (!(share >= 0 && share <= 1)) has_left_piece_ = true;
    for (std::size_t i = 0; i < rates.size(); ++i) rates[i] += share * found.rate_changes[k][i];
  }
  system_.find_coordinate_rates(state.data(), system_.v_of(state), rates.data());
  for (const HeldRate& held : held_rates_) system_.v_of(rates)[held.rate] = 0;
}

PiecewiseMotion::RateResponse PiecewiseMotion::rate_response(
    const Numbers& state, double t, const std::vector<HeldRate>& held) const {
  Numbers at = state;
  double* const v = system_.v_of(at);
  for (const HeldRate& each : held) v[each.rate] = each.value + kink_distance(each.value);
  RateResponse result;
  result.rates_above.resize(state.size());
  system_.find_rates(at, result.rates_above, t);
  for (const HeldRate& each : held) {
    Numbers& change = result.rate_changes.emplace_back(state.size());
    v[each.rate] = each.value - kink_distance(each.value);
    system_.find_rates(at, change, t);
    v[each.rate] = each.value + kink_distance(each.value);
    for (std::size_t i = 0; i < change.size(); ++i) change[i] -= result.rates_above[i];
  }
  for (const HeldRate& row : held) {
    result.accelerations.push_back(system_.v_of(result.rates_above)[row.rate]);
    for (Numbers& change : result.rate_changes) {
      result.acceleration_changes.push_back(system_.v_of(change)[row.rate]);
    }
  }
  return result;
}

/// max(tolerance/1000, 8 epsilon) (1 + |value|): below the error of a step, above rounding errors.
double PiecewiseMotion::kink_distance(double value) const {
  const double least = 8 * std::numeric_limits<double>::epsilon();
  return std::max(tolerance_ / 1000, least) * (1 + std::abs(value));
}

bool PiecewiseMotion::is_held(std::size_t kink) const {
  const std::optional<std::size_t> rate = kinks_.rate_of(kink);
  return rate && std::ranges::count(held_rates_, *rate, &HeldRate::rate) > 0;
}

void PiecewiseMotion::begin_piece(const Numbers& before, Numbers& state, double t) {
  const std::vector<int> now = kinks_.sides(state, t);
  sides_.resize(now.size());
  std::vector<HeldRate> candidates = held_rates_;
  for (std::size_t k = 0; k < now.size(); ++k) {
    const bool is_crossed = now[k] * sides_[k] < 0;
    if (is_held(k) || (now[k] != 0 && !is_crossed)) continue;
    last_kink_ = kinks_.kink_text(k);
    const std::optional<std::size_t> rate = kinks_.rate_of(k);
    if (!rate || std::ranges::count(candidates, *rate, &HeldRate::rate) > 0) continue;
    const HeldRate held{*rate, find_kink_rate(k, before, state, t)};
    if (can_hold_rate(held, state, t)) candidates.push_back(held);
  }
  hold_rates(candidates, state, t);
  sides_ = kinks_.sides(state, t);
}

/// The rate at which the side of `kink` changes, found by bisection between the rates of the states
/// `from` and `to`; exactly 0 if this rate is nearly 0.
double PiecewiseMotion::find_kink_rate(std::size_t kink, Numbers from, const Numbers& to,
                                       double t) {
  double& v = system_.v_of(from)[*kinks_.rate_of(kink)];
  double low = v;
  double high = system_.v_of(to)[*kinks_.rate_of(kink)];
  const int side = sides_[kink];
  const int halvings = std::numeric_limits<double>::digits;  // makes low and high adjacent doubles
  for (int i = 0; i < halvings && low != high; ++i) {
    v = low + (high - low) / 2;
    (kinks_.sides(from, t)[kink] == side ? low : high) = v;
  }
  return std::abs(high) < kink_distance(0) ? 0 : high;
}

/// True if only component held.rate of the force jumps at the kink, and if this component is larger
/// below the kink. Damping changes forces over kink_distance() by far less than 1e-6 of the jump.
bool PiecewiseMotion::can_hold_rate(const HeldRate& held, Numbers state, double t) const {
  const auto forces = [&](double rate) {
    system_.v_of(state)[held.rate] = rate;
    return system_.generalized_force(state.data(), system_.v_of(state), t);
  };
  Numbers jump = forces(held.value - kink_distance(held.value));
  const Numbers above = forces(held.value + kink_distance(held.value));
  for (std::size_t i = 0; i < jump.size(); ++i) jump[i] -= above[i];
  const double own = std::exchange(jump[held.rate], 0);
  return own > 0 &&
         std::ranges::all_of(jump, [own](double other) { return std::abs(other) <= 1e-6 * own; });
}

void PiecewiseMotion::hold_rates(const std::vector<HeldRate>& candidates, Numbers& state,
                                 double t) {
  held_rates_.clear();
  const RateResponse found = rate_response(state, t, candidates);
  const std::vector<RatePosition> places =
      solve_positions(found.accelerations, found.acceleration_changes);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const HeldRate& each = candidates[k];
    double& v = system_.v_of(state)[each.rate];
    if (places[k] == RatePosition::held) held_rates_.push_back(each);
    v = each.value;
    if (places[k] == RatePosition::above) v += kink_distance(each.value);
    if (places[k] == RatePosition::below) v -= kink_distance(each.value);
  }
}

void PiecewiseMotion::reset_held_rates(Numbers& state) const {
  for (const HeldRate& held : held_rates_) system_.v_of(state)[held.rate] = held.value;
}

}  // namespace elgen
