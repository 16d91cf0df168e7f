// Finds zeros of sums along one coordinate: minimises |sum| on finer and finer grids. This finds
// zeros with and without a change of sign. For find_minima(), the oracle computes V and its slopes.
#include "verify/states/near_zeros.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>

#include "elgen/references.hpp"
#include "sample/minima.hpp"

namespace elgen {
namespace {

constexpr std::size_t most_states = 64;
constexpr std::size_t distances = 3;
/// About 300 evaluations find a zero, which gives three states.
constexpr std::size_t evaluations_per_state = 256;
/// Limit of evaluations times the model's expressions: about a second.
constexpr std::size_t most_work = 1 << 20;

constexpr int cells = 16;
constexpr int grids = 18;  ///< each 8 times finer than the last; 8^-18 is less than u of a double
/// A sum is 0 if it is below this fraction of the largest |sum| on the first grid. At a zero,
/// rounding of the coordinate to double leaves 1e-16; a sum that stays above 1e-10 loses few
/// digits.
constexpr double zero_threshold = 1e-10;

/// A typed sum that contains coordinates, but no velocities, accelerations, momenta or open values.
struct PositionSum {
  ExpressionId id = 0;
  std::set<std::uint32_t> coordinates = {};
};

std::vector<PositionSum> position_sums(const Model& model) {
  constexpr LeafSet others =
      Opcode::velocity | Opcode::acceleration | Opcode::open_value | Opcode::momentum;
  std::vector<PositionSum> sums;
  for (const ExpressionId id : reachable_expressions(model, equation_roots(model))) {
    if (sums.size() == most_states) break;  // a sum with a zero gives three states
    if (model.expressions[id].kind != ExpressionKind::add || contains_leaf(model, id, others))
      continue;
    PositionSum sum{id};
    for (const ExpressionId below : reachable_expressions(model, {id})) {
      const Expression& e = model.expressions[below];
      if (is_leaf(e, Opcode::coordinate) && !model.coordinates[e.index].rotation) {
        sum.coordinates.insert(e.index);
      }
    }
    if (!sum.coordinates.empty()) sums.push_back(std::move(sum));
  }
  return sums;
}

class NearZeroSampler {
 public:
  /// `ratio`: the quotient of successive distances from a zero.
  NearZeroSampler(const SystemUnderTest& subject, const SamplingOptions& sampling, double ratio)
      : subject_(subject),
        ratio_(ratio),
        ranges_(ranges_of(subject)),
        sampler_(sampling.seed),
        max_states_(std::min(sampling.count, most_states)),
        evaluations_left_(std::min(max_states_ * evaluations_per_state,
                                   most_work / (subject.model.expressions.size() + 1))) {}

  std::vector<SampledState<double>> sample() {
    const std::vector<PositionSum> sums = position_sums(subject_.model);
    std::set<std::uint32_t> all;
    for (const PositionSum& sum : sums) all.insert(sum.coordinates.begin(), sum.coordinates.end());
    // The zeros of a single sum along its coordinates suffice, with motion and at rest.
    const int rounds = sums.size() == 1 ? 2 : 1;
    if (sums.size() > 1 && subject_.model.open_values.empty()) add_states_near_minima(all);
    for (const PositionSum& sum : sums) {
      bool has_zero = false;
      for (const std::uint32_t coordinate : sum.coordinates) {
        if (states_.size() >= max_states_) break;
        Arguments<double> at = draw_in_ranges(subject_, ranges_, sampler_);
        if (!move_to_zero(sum, coordinate, at)) continue;
        has_zero = true;
        for (int i = 0; i < rounds; ++i) add_states_near(at, {coordinate}, 0.5 * i);
      }
      if (!has_zero) add_states_near_joint_zero(sum);
    }
    if (states_.size() > max_states_) states_.resize(max_states_);
    return std::move(states_);
  }

 private:
  /// |sum|; infinite if the sum is undefined, or if no evaluations remain.
  double sum_magnitude(const PositionSum& sum, const Arguments<double>& at) {
    constexpr double none = std::numeric_limits<double>::infinity();
    if (evaluations_left_ == 0) return none;
    --evaluations_left_;
    const auto value = oracle_expression_value(subject_.model, sum.id, exact_state(subject_, at));
    return value ? to_double(cln::abs(*value)) : none;
  }

  /// Minimises |sum| over one coordinate, which it changes in `at`; true if the minimum is 0.
  bool move_to_zero(const PositionSum& sum, std::uint32_t coordinate, Arguments<double>& at) {
    auto [low, high] = ranges_.q[coordinate];
    double place = at.q[coordinate];
    double smallest = std::numeric_limits<double>::infinity();
    double largest = 0;
    for (int grid = 0; grid < grids && smallest > 0; ++grid) {
      const double step = (high - low) / cells;
      for (int k = 0; k <= cells; ++k) {
        at.q[coordinate] = low + k * step;
        const double size = sum_magnitude(sum, at);
        if (size < smallest) place = at.q[coordinate];
        smallest = std::min(smallest, size);
        if (grid == 0 && std::isfinite(size)) largest = std::max(largest, size);
      }
      if (smallest > largest / 2) break;
      low = std::max(low, place - step);
      high = std::min(high, place + step);
    }
    at.q[coordinate] = place;
    return largest > 0 && smallest <= zero_threshold * largest;
  }

  /// Adds states near a zero that a sum has only in all its coordinates together, as
  /// (x - 1)^2 + (y - 0.3)^2 has at (1, 0.3): first off the axes, then along each axis.
  void add_states_near_joint_zero(const PositionSum& sum) {
    if (sum.coordinates.size() < 2 || states_.size() >= max_states_) return;
    Arguments<double> at = draw_in_ranges(subject_, ranges_, sampler_);
    bool is_zero = false;
    // Later passes refine places that the first pass found while other terms were large.
    for (int pass = 0; pass < 3; ++pass) {
      for (const std::uint32_t c : sum.coordinates) {
        is_zero = move_to_zero(sum, c, at);
        const Range& range = ranges_.q[c];
        const bool is_negligible = range.low <= 0 && 0 <= range.high &&
                                   std::abs(at.q[c]) < zero_threshold * (range.high - range.low);
        if (is_negligible) at.q[c] = 0;
      }
    }
    if (!is_zero) return;
    add_states_near(at, sum.coordinates);
    add_states_on_axes(at, sum.coordinates);
  }

  /// Adds states that differ from `zero` in one coordinate only, because differences may cancel
  /// only there, as 1 - x^2/(x^2 + y^2) does at y = 0.
  void add_states_on_axes(const Arguments<double>& zero,
                          const std::set<std::uint32_t>& coordinates) {
    for (const std::uint32_t c : coordinates) add_states_near(zero, {c}, sampler_.uniform({0, 1}));
  }

  /// Adds states near minima of V. The search may use half of the evaluations, and starts at other
  /// states than the choice of forms.
  void add_states_near_minima(const std::set<std::uint32_t>& coordinates) {
    const Model& model = subject_.model;
    Domain domain{model, ranges_};
    for (std::size_t i = 0; i < most_drawn_starts; ++i)
      domain.states.push_back(draw_in_ranges(subject_, ranges_, sampler_));
    Arguments<double> at = domain.states.front();
    State state = exact_state(subject_, at);
    evaluations_left_ /= 2;
    std::size_t left = evaluations_left_ / (coordinates.size() + 1);
    const auto values_at = [&](const std::vector<Real>& q) -> std::optional<PotentialValues> {
      if (left == 0) return std::nullopt;
      --left;
      for (const std::uint32_t i : coordinates) state.q[i] = q[i].value();
      const auto potential = oracle_values(model, {.kind = OutputKind::potential_energy}, state);
      const auto gravity = oracle_values(model, {.kind = OutputKind::gravity}, state);
      if (!potential || !gravity) return std::nullopt;
      PotentialValues values{Real(potential->front())};
      for (const std::uint32_t i : coordinates)
        values.slopes.emplace_back((*gravity)[model.coordinates[i].velocity]);
      return values;
    };
    for (std::vector<double>& minimum :
         find_minima(values_at, {coordinates.begin(), coordinates.end()}, domain)) {
      at.q = std::move(minimum);
      // Minima may be outside the default range of a coordinate without a declared range.
      for (const std::uint32_t i : coordinates)
        ranges_.q[i] = {std::min(ranges_.q[i].low, at.q[i]), std::max(ranges_.q[i].high, at.q[i])};
      // Every second state is at rest. Because the number of distances is odd, each distance has a
      // state at rest in one of the two rounds, and a moving state in the other round.
      for (int i = 0; i < 2 && states_.size() < max_states_ / 2; ++i)
        add_states_near(at, coordinates, sampler_.uniform({0, 1}));
      const bool has_axes = coordinates.size() > 1 && states_.size() < max_states_ / 2;
      if (has_axes) add_states_on_axes(at, coordinates);
    }
  }

  /// Adds a state at each distance from the zero. Each coordinate moves by a different fraction, so
  /// that equal coordinates become different; `direction` in [0, 1) changes all fractions.
  void add_states_near(const Arguments<double>& zero, const std::set<std::uint32_t>& coordinates,
                       double direction = 0) {
    double distance = 1;
    for (std::size_t i = 0; i < distances; ++i) {
      distance *= ratio_;
      Arguments<double> values = zero;
      double share = direction;
      for (const std::uint32_t c : coordinates) {
        share = std::fmod(share + 0.618, 1.0);
        values.q[c] = nearby_value(zero.q[c], distance * (2 * share - 1), ranges_.q[c]);
      }
      for (auto* rates : {&values.v, &values.a, &values.u}) {
        if (states_.size() % 2 != 0) std::ranges::fill(*rates, 0.0);
      }
      states_.push_back({Region::near_zero, {}, std::move(values)});
    }
  }

  /// x + d, or x - d if x + d leaves the range; d = `distance` max(|x|, min(1, half the range)).
  static double nearby_value(double x, double distance, const Range& range) {
    const double change =
        distance * std::max(std::abs(x), std::min(1.0, range.high / 2 - range.low / 2));
    const bool is_inside = x + change >= range.low && x + change <= range.high;
    return std::clamp(is_inside ? x + change : x - change, range.low, range.high);
  }

  const SystemUnderTest& subject_;
  double ratio_;
  LeafValues<Range> ranges_;
  Sampler sampler_;
  std::size_t max_states_;
  std::size_t evaluations_left_;
  std::vector<SampledState<double>> states_ = {};
};

}  // namespace

template <class Scalar>
std::vector<SampledState<Scalar>> states_near_zeros(const SystemUnderTest& subject,
                                                    const SamplingOptions& sampling) {
  // Distances decrease to 1e-12, or 1e-6 in float. At smaller distances, differences in the scalar
  // have few digits.
  constexpr double ratio = std::is_same_v<Scalar, float> ? 1e-2 : 1e-4;
  std::vector<SampledState<Scalar>> states;
  for (const SampledState<double>& state : NearZeroSampler(subject, sampling, ratio).sample()) {
    states.push_back({state.region, state.name, round_to_finite<Scalar>(state.values)});
  }
  return states;
}

template std::vector<SampledState<double>> states_near_zeros(const SystemUnderTest&,
                                                             const SamplingOptions&);
template std::vector<SampledState<float>> states_near_zeros(const SystemUnderTest&,
                                                            const SamplingOptions&);

}  // namespace elgen
