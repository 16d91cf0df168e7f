#include "choose/points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "accuracy/rough_errors.hpp"
#include "numbers/random.hpp"

namespace elgen {
namespace {

constexpr std::size_t plain_points = 4;  ///< at the values of parameters, and at other values
constexpr std::size_t most_places = 10;
constexpr int widest_factor = 3;  ///< of parameters, as a power of two

/// Relative, but at 0: multiples of 2^-30 near 1e-1, 1e-2, 1e-4 and 1e-8.
constexpr double unit_of_distance = 0x1p-30;
constexpr double distances[]{107374182 * unit_of_distance, 10737418 * unit_of_distance,
                             107374 * unit_of_distance, 11 * unit_of_distance};

/// The distances of all coordinates at once from their first places.
constexpr double near = distances[2];
constexpr double nearest = distances[3];

/// Where coordinates without a range go in exp(u) and log(u): a few decades of u, and most of the
/// range of double.
constexpr double far_away[]{16, -16, 1024, -1024};

class Making {
 public:
  Making(const Program& program, const Function& text, const Domain& domain,
         CancellingPlaces places)
      : program_(program), text_(text), domain_(domain), places_(std::move(places)) {}

  ComparisonPoints operator()() {
    for (std::size_t i = 0; i < plain_points; ++i) points_.push_back(state());
    for (std::size_t i = 0; i < plain_points; ++i)
      points_.push_back(with_other_parameters(state()));
    for (const NearPlace& place : places_.of_coordinates) {
      for (const double distance : distances) add_near(place, distance);
    }
    add_near_all(places_.of_coordinates);
    for (const NearPlaces& places : places_.of_sums) add_near_all(places);
    for (std::size_t i = 0; i < plain_points && has_motion(); ++i) add(at_rest(state()));
    add_far();
    return std::move(points_);
  }

 private:
  /// The next one, over and over.
  const Arguments<double>& state() { return domain_.states[next_++ % domain_.states.size()]; }

  static bool is_motion(Opcode kind) {
    return kind == Opcode::velocity || kind == Opcode::momentum || kind == Opcode::acceleration ||
           kind == Opcode::input;
  }

  [[nodiscard]] bool has_motion() const {
    return std::ranges::any_of(text_.instructions, is_motion, &Instruction::opcode);
  }

  /// Rates, accelerations and inputs become 0. Elsewhere they are large and hide the digits that a
  /// holding force loses.
  static Arguments<double> at_rest(Arguments<double> point) {
    const auto stop = [](Opcode kind, std::uint32_t, double& value) {
      if (is_motion(kind)) value = 0;
    };
    for_each_leaf(stop, point);
    return point;
  }

  Arguments<double> with_other_parameters(Arguments<double> point) {
    const std::vector<double> old = point.parameters;
    for (std::size_t i = 0; i < old.size(); ++i) {
      const double factor = std::abs(random_.log_uniform(-widest_factor, widest_factor - 1));
      point.parameters[i] = within(domain_.declared.parameters[i], old[i] * factor);
      for (std::size_t k = 0; k < i; ++k) {
        const bool is_equal = old[k] == old[i] && domain_.unit_of[k] == domain_.unit_of[i];
        if (is_equal) point.parameters[i] = point.parameters[k];
      }
    }
    return point;
  }

  static double within(const std::optional<Range>& range, double value) {
    return range ? std::clamp(value, range->low, range->high) : value;
  }

  static void move(Arguments<double>& point, const NearPlace& place, double away) {
    const double at = place.other ? place.factor * point.q[*place.other] : place.factor;
    point.q[place.coordinate] = at == 0 ? away : at + at * away;
  }

  double drawn_side(double distance) { return random_.uniform(-1, 1) < 0 ? -distance : distance; }

  /// On the side on which more entries have a value: sqrt(x^2 - r^2) has none for x < r.
  void add_near(const NearPlace& place, double distance) {
    Arguments<double> point = state();
    Arguments<double> other = point;
    const double away = drawn_side(distance);
    move(point, place, away);
    move(other, place, -away);
    add(value_count(other) > value_count(point) ? std::move(other) : std::move(point));
  }

  [[nodiscard]] std::ptrdiff_t value_count(const Arguments<double>& point) const {
    const auto entries = entries_of(text_, fold<RoughError>(RoughRules{point}, program_, text_));
    return std::ranges::count_if(
        entries, [](const RoughError& entry) { return std::isfinite(entry.value); });
  }

  /// For each coordinate, whether it has no range and stands in an exponential or a logarithm.
  [[nodiscard]] std::vector<bool> unbounded_arguments() const {
    std::vector<std::uint32_t> arguments;
    for (const Instruction& i : text_.instructions) {
      const bool is_exponential = i.function == FunctionId::exp || i.function == FunctionId::log;
      if (i.opcode == Opcode::call && is_exponential) arguments.push_back(i.a);
    }
    const std::vector<bool> needed = needed_for(text_, arguments);
    std::vector<bool> is_unbounded(domain_.is_alone.size());
    for (std::size_t at = 0; at < needed.size(); ++at) {
      const Instruction& i = text_.instructions[at];
      if (!needed[at] || i.opcode != Opcode::coordinate) continue;
      is_unbounded[i.a] = domain_.is_alone[i.a] && !domain_.declared.q[i.a];
    }
    return is_unbounded;
  }

  /// 1 + expm1(u) has no digit of exp(u) where that is small, nor log1p((a - b)/b) of log(a/b).
  void add_far() {
    const std::vector<bool> is_far = unbounded_arguments();
    if (std::find(is_far.begin(), is_far.end(), true) == is_far.end()) return;
    for (const double distance : far_away) {
      Arguments<double> point = state();
      for (std::size_t i = 0; i < is_far.size(); ++i) {
        if (is_far[i]) point.q[i] = distance * random_.uniform(0.5, 1);
      }
      add(std::move(point));
    }
  }

  void add_near_all(const NearPlaces& places) {
    add_near_all(places, state(), near);
    add_near_all(places, at_rest(state()), nearest);
  }

  void add_near_all(const NearPlaces& places, Arguments<double> point, double distance) {
    std::vector<bool> is_moved(point.q.size());
    for (const NearPlace& place : places) {
      if (!is_moved[place.coordinate]) move(point, place, drawn_side(distance));
      is_moved[place.coordinate] = true;
    }
    if (!places.empty()) add(std::move(point));
  }

  /// A point outside the declared ranges is left out.
  void add(Arguments<double> point) {
    for (std::size_t i = 0; i < point.q.size(); ++i) {
      if (within(domain_.declared.q[i], point.q[i]) != point.q[i]) return;
    }
    points_.push_back(std::move(point));
  }

  const Program& program_;
  const Function& text_;
  const Domain& domain_;
  CancellingPlaces places_;
  Random random_{1};
  std::size_t next_ = 0;
  ComparisonPoints points_ = {};
};

}  // namespace

ComparisonPoints comparison_points(const Program& program, const Function& text,
                                   const Domain& domain) {
  return Making(program, text, domain, cancelling_places(program, text, domain, most_places))();
}

}  // namespace elgen
