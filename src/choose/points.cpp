#include "choose/points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "elgen/evaluate.hpp"
#include "elgen/leaf_names.hpp"

namespace elgen {
namespace {

/// The number of points of each kind: nominal parameters, scaled parameters, and states of rest.
constexpr std::size_t points_per_kind = 4;

/// Further places at which terms cancel are not visited, because each costs four points.
constexpr std::size_t max_places = 10;
constexpr int widest_factor = 3;  ///< parameters without positive bounds are scaled by at most 2^3

/// With more velocities, the determinants w_ij of choose/solution.cpp are too long.
constexpr std::size_t most_solved_velocities = 3;

/// Relative distances (absolute at 0) near 1e-1, 1e-2, 1e-4 and 1e-8, as multiples of 2^-30.
constexpr double unit_of_distance = 0x1p-30;
constexpr double distances[]{107374182 * unit_of_distance, 10737418 * unit_of_distance,
                             107374 * unit_of_distance, 11 * unit_of_distance};

/// The two distances of points near a zero of a sum, and of points near the first places of all
/// coordinates at once.
constexpr double near_distance = distances[2];
constexpr double nearest_distance = distances[3];

/// The distances of points at rest from a minimum of V. The last is near 1e-12.
constexpr double distances_from_minima[]{0, near_distance, nearest_distance, 0x1p-40};

/// For each coordinate: true if its values may be remote, and it occurs in a call, a root or a
/// divisor. In functions of rates, only exponentials and logarithms count: a potential in these
/// functions has the form that was chosen for it alone.
std::vector<bool> remote_coordinates(const Function& text, const Model& model) {
  const bool is_moving = depends_on_motion(text);
  std::vector<std::uint32_t> operands;
  for (const Instruction& i : text.instructions) {
    const bool is_call = i.opcode == Opcode::call;
    const bool is_exponential =
        is_call && (i.function == FunctionId::exp || i.function == FunctionId::log);
    const bool counts = is_moving ? is_exponential : is_call || i.opcode == Opcode::square_root;
    if (counts) operands.push_back(i.a);
    if (!is_moving && i.opcode == Opcode::divide) operands.push_back(i.b);
  }
  const std::vector<bool> needed = needed_instructions(text, operands);
  const std::vector<bool> is_unbounded = unbounded_coordinates(model);
  std::vector<bool> result(is_unbounded.size());
  for (std::size_t at = 0; at < needed.size(); ++at) {
    const Instruction& i = text.instructions[at];
    if (needed[at] && i.opcode == Opcode::coordinate) result[i.a] = is_unbounded[i.a];
  }
  return result;
}

bool is_moving_leaf(Opcode opcode) { return is_leaf(opcode) && leaf_row(opcode).is_zero_at_rest; }

class PointMaker {
 public:
  PointMaker(const Program& program, const Function& text, const Domain& domain, NearPlaces places)
      : program_(program), text_(text), domain_(domain), places_(std::move(places)) {}

  Points make(const SumZeros& zeros) {
    for (std::size_t i = 0; i < points_per_kind; ++i) points_.push_back(next_state());
    for (std::size_t i = 0; i < points_per_kind; ++i)
      points_.push_back(with_scaled_parameters(next_state()));
    for (const NearPlace& place : places_) {
      for (const double distance : distances) add_point_near(place, distance);
    }
    add_points_near_all(places_);
    if (depends_on_motion(text_)) {
      for (std::size_t i = 0; i < points_per_kind; ++i)
        add_point_in_range(point_at_rest(next_state()));
    } else {
      for (const std::vector<double>& zero : zeros) add_points_near_zero(zero);
    }
    add_remote_points();
    if (is_small_solution(program_, text_)) add_scaled_copies();
    for (const std::vector<double>& minimum : domain_.minima) add_points_at_minimum(minimum);
    return std::move(points_);
  }

 private:
  /// The next state of the domain; after the last state, the first.
  const Arguments<double>& next_state() {
    return domain_.states[next_state_++ % domain_.states.size()];
  }

  /// `point` with rates, accelerations and inputs set to 0, because large values would hide the
  /// digits that a static force loses.
  static Arguments<double> point_at_rest(Arguments<double> point) {
    const auto stop = [](Opcode kind, std::uint32_t, double& value) {
      if (is_moving_leaf(kind)) value = 0;
    };
    for_each_leaf(stop, point);
    return point;
  }

  /// `point` with other parameters. Equal parameters with the same unit stay equal if the declared
  /// bounds allow this, since they may cancel.
  Arguments<double> with_scaled_parameters(Arguments<double> point) {
    const std::vector<double> old = point.parameters;
    for (std::uint32_t i = 0; i < old.size(); ++i) {
      point.parameters[i] = draw_parameter(i, old[i]);
      for (std::size_t k = 0; k < i; ++k) {
        const double equal = point.parameters[k];
        const bool is_in_range = clamp_to_range(Opcode::parameter, i, equal) == equal;
        if (old[k] == old[i] && has_same_unit(i, k) && is_in_range) point.parameters[i] = equal;
      }
    }
    return point;
  }

  /// A value of a parameter: log-uniform over its declared bounds if both are positive, otherwise
  /// `value` scaled by at most 2^3. ilogb is exact, so all machines draw the same values.
  [[nodiscard]] double draw_parameter(std::uint32_t number, double value) {
    const Range& bounds = leaf_of(domain_.ranges, Opcode::parameter, number);
    const bool is_bounded =
        declared_range(domain_.model, Opcode::parameter, number) && bounds.low > 0;
    const int low = is_bounded ? std::ilogb(bounds.low) : -widest_factor;
    const int high = is_bounded ? std::ilogb(bounds.high) : widest_factor - 1;
    const double drawn = std::abs(sampler_.log_uniform(low, high));
    return clamp_to_range(Opcode::parameter, number, is_bounded ? drawn : value * drawn);
  }

  /// Adds copies, with other parameters, of all points after the first two kinds: accelerations
  /// lose most digits if links are nearly aligned and the ratio of their masses is large.
  void add_scaled_copies() {
    const std::size_t count = points_.size();
    for (std::size_t i = 2 * points_per_kind; i < count; ++i) {
      points_.push_back(with_scaled_parameters(points_[i]));
    }
  }

  /// True if the parameters `i` and `k` have the same unit; false if a unit is unknown.
  [[nodiscard]] bool has_same_unit(std::size_t i, std::size_t k) const {
    const std::optional<Unit>& unit = domain_.model.parameters[i].unit;
    return unit && unit == domain_.model.parameters[k].unit;
  }

  [[nodiscard]] double clamp_to_range(Opcode kind, std::uint32_t number, double value) const {
    if (!declared_range(domain_.model, kind, number)) return value;
    const Range& range = leaf_of(domain_.ranges, kind, number);
    return std::clamp(value, range.low, range.high);
  }

  static void move_coordinate(Arguments<double>& point, const NearPlace& place, double away) {
    const double at = place.other ? place.factor * point.q[*place.other] : place.factor;
    point.q[place.coordinate] = at == 0 ? away : at + at * away;
  }

  /// Adds a point near a place, on the side on which more entries are defined: sqrt(x^2 - r^2) is
  /// undefined for x < r.
  void add_point_near(const NearPlace& place, double distance) {
    Arguments<double> point = next_state();
    Arguments<double> other = point;
    const double away = sampler_.random_sign() * distance;
    move_coordinate(point, place, away);
    move_coordinate(other, place, -away);
    add_point_in_range(count_finite_entries(other) > count_finite_entries(point)
                           ? std::move(other)
                           : std::move(point));
  }

  [[nodiscard]] std::ptrdiff_t count_finite_entries(const Arguments<double>& point) const {
    return std::ranges::count_if(evaluate(program_, text_, point),
                                 [](double entry) { return std::isfinite(entry); });
  }

  /// Adds remote points: without a range, a rewriting must not lose digits that the text keeps, as
  /// 1 + expm1(u) does for exp(u) at u = -16, and sqrt(r^2 + x^2) - x at x = 1e4.
  void add_remote_points() {
    const std::vector<bool> is_remote = remote_coordinates(text_, domain_.model);
    if (std::find(is_remote.begin(), is_remote.end(), true) == is_remote.end()) return;
    for (const double magnitude : remote_magnitudes) {
      for (const double value : {magnitude, -magnitude}) {
        Arguments<double> point = next_state();
        sampler_.set_remote(value, is_remote, point.q);
        add_point_in_range(std::move(point));
      }
    }
  }

  void add_points_near_all(const NearPlaces& places) {
    add_points_near_all(places, next_state(), near_distance);
    add_points_near_all(places, point_at_rest(next_state()), nearest_distance);
  }

  void add_points_near_all(const NearPlaces& places, Arguments<double> point, double distance) {
    std::vector<bool> is_moved(point.q.size());
    for (const NearPlace& place : places) {
      if (!is_moved[place.coordinate])
        move_coordinate(point, place, sampler_.random_sign() * distance);
      is_moved[place.coordinate] = true;
    }
    if (!places.empty()) add_point_in_range(std::move(point));
  }

  /// Adds points on both sides of a zero, along a random direction, at two distances.
  void add_points_near_zero(const std::vector<double>& zero) {
    for (const double distance : {near_distance, nearest_distance}) {
      Arguments<double> point = next_state();
      Arguments<double> other = point;
      for (std::size_t i = 0; i < zero.size(); ++i) {
        const double away = sampler_.random_sign() * sampler_.random_fraction() * distance;
        const double size = zero[i] == 0 ? 1 : zero[i];
        point.q[i] = zero[i] + size * away;
        other.q[i] = zero[i] - size * away;
      }
      add_point_in_range(std::move(point));
      add_point_in_range(std::move(other));
    }
  }

  /// Adds points at rest at a minimum of V and near it, each along a random direction. All other
  /// leaves are as in the search for the minimum.
  void add_points_at_minimum(const std::vector<double>& minimum) {
    for (const double distance : distances_from_minima) {
      Arguments<double> point = point_at_rest(domain_.states.front());
      for (std::size_t i = 0; i < minimum.size(); ++i) {
        if (domain_.model.coordinates[i].rotation) continue;
        const double away = sampler_.random_sign() * sampler_.random_fraction() * distance;
        point.q[i] = minimum[i] + (minimum[i] == 0 ? 1 : minimum[i]) * away;
      }
      add_point_in_range(std::move(point));
    }
  }

  /// Adds a point unless it is outside the declared ranges.
  void add_point_in_range(Arguments<double> point) {
    for (std::uint32_t i = 0; i < point.q.size(); ++i) {
      if (clamp_to_range(Opcode::coordinate, i, point.q[i]) != point.q[i]) return;
    }
    points_.push_back(std::move(point));
  }

  const Program& program_;
  const Function& text_;
  const Domain& domain_;
  NearPlaces places_;
  Sampler sampler_{1};
  std::size_t next_state_ = 0;
  Points points_ = {};
};

}  // namespace

bool depends_on_motion(const Function& function) {
  return std::ranges::any_of(function.instructions, is_moving_leaf, &Instruction::opcode);
}

bool is_small_solution(const Program& program, const Function& function) {
  const std::size_t velocities = program.leaves.v.size();
  const bool is_constrained = first_entry_of(function, "multipliers") != entry_count(function);
  return output_row(function.kind).gives_pivots && !is_constrained && velocities > 1 &&
         velocities <= most_solved_velocities;
}

Points comparison_points(const Program& program, const Function& text, const Domain& domain,
                         const SumZeros& zeros) {
  return PointMaker(program, text, domain, cancelling_places(program, text, domain, max_places))
      .make(zeros);
}

}  // namespace elgen
