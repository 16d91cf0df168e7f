// Sampled states. The extremes for float are milder than for double, because float has an eighth of
// the range of exponents.
#include "sample/states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>

#include "elgen/leaf_names.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

constexpr double pi = 3.141592653589793;

/// The value, clamped to a quarter of the largest double, because a declared bound may be larger
/// than any double; the width of each range is then finite.
double clamp_to_double(const cln::cl_R& value) {
  constexpr double largest = std::numeric_limits<double>::max() / 4;
  return std::clamp(to_double(value), -largest, largest);
}

Range range_or_default(const std::optional<Interval>& interval, double otherwise) {
  if (!interval) return {-otherwise, otherwise};
  return {clamp_to_double(interval->low), clamp_to_double(interval->high)};
}

/// The largest magnitude of a rate, momentum, acceleration, input, open value or time without a
/// range.
constexpr double default_rate = 10;
constexpr std::size_t domain_states = 8;
constexpr Range step_range{0, 0.1};  ///< of h in s; at a rate of 10, the longest step moves by 1

using Ranges = LeafValues<Range>;

LeafValues<double> nominal_values(const StateSpace& space) {
  return map_leaves([](const cln::cl_R& value) { return to_double(value); },
                    nominal_state(space.model, space.scene));
}

/// True if leaves of this kind are drawn. Parameters are not drawn. A kind that only some functions
/// take is drawn if a function of the program takes it.
bool is_sampled(const LeafNames& leaves, Opcode kind) {
  if (kind == Opcode::step) return !leaves.h.empty();
  return kind != Opcode::parameter && may_be_argument(leaves, kind);
}

/// `values` with all variables drawn from their ranges; parameters are unchanged.
LeafValues<double> draw_nominal(const LeafNames& leaves, const Ranges& ranges,
                                LeafValues<double> values, Sampler& draw) {
  const auto set = [&](Opcode kind, std::uint32_t, double& value, const Range& range) {
    if (is_sampled(leaves, kind)) value = draw.uniform(range);
  };
  for_each_leaf(set, values, ranges);
  return values;
}

/// `values` with all variables replaced by numbers of random sign and a magnitude in
/// [2^low, 2^(high + 1)).
LeafValues<double> draw_scaled(const LeafNames& leaves, LeafValues<double> values, Sampler& draw,
                               int low, int high) {
  const auto set = [&](Opcode kind, std::uint32_t, double& value) {
    if (is_sampled(leaves, kind)) value = draw.log_uniform(low, high);
  };
  for_each_leaf(set, values);
  return values;
}

/// The magnitudes that the extreme states of a scalar have.
struct ExtremeMagnitudes {
  std::vector<double> tiny;
  std::vector<double> angles;
  std::vector<double> rates;
  std::vector<double> ratios;  ///< factors of parameters
};

template <class Scalar>
ExtremeMagnitudes extreme_magnitudes() {
  const double denormal = std::numeric_limits<Scalar>::denorm_min();
  if constexpr (std::is_same_v<Scalar, float>) {
    return {{1e-12, 1e-30, 1e-37, denormal}, {1e3, 1e4}, {1e3, 1e7, 1e18}, {1e3}};
  } else {
    return {{1e-12, 1e-30, 1e-150, 1e-300, denormal},
            {1e3, 1e8, 1e15},
            {1e3, 1e30, 1e60, 1e150, 1e300},
            {1e3, 1e6, 1e12}};
  }
}

/// Makes the extreme states. Each state is a new nominal state with one change; the last states
/// combine two changes that lose digits.
class ExtremeStates {
 public:
  ExtremeStates(const StateSpace& space, Sampler& draw)
      : space_(space),
        nominal_values_(nominal_values(space)),
        ranges_(ranges_of(space)),
        draw_(draw) {
    for (const Coordinate& coordinate : space.model.coordinates) {
      is_angle_.push_back(is_angle(coordinate));
    }
  }

  std::vector<SampledState<double>> make_states(const ExtremeMagnitudes& reach,
                                                std::size_t most_combinations) {
    add("origin") = nominal_values_;
    add_range_ends("low ends of ranges", &Range::low);
    add_range_ends("high ends of ranges", &Range::high);
    for (const double size : reach.tiny) {
      add_positions(fmt::format("positions {:g}", size), size, false);
      add_rates(fmt::format("rates {:g}", size), size);
    }
    for (const double size : reach.angles) {
      add_positions(fmt::format("angles {:g}", size), size, true);
    }
    for (const double size : reach.rates) add_rates(fmt::format("rates {:g}", size), size);
    add_parameter_ratios(reach.ratios.back());
    add_parameter_ratios(1 / reach.ratios.back());
    add_singular_charts();
    add_combinations(reach.ratios, most_combinations);
    return std::move(states_);
  }

 private:
  LeafValues<double>& add(std::string name) {
    states_.push_back({Region::extreme, std::move(name),
                       draw_nominal(space_.leaves, ranges_, nominal_values_, draw_)});
    return states_.back().values;
  }

  void add_range_ends(const char* name, double Range::*end) {
    static constexpr LeafSet others = Opcode::parameter | Opcode::acceleration | Opcode::time;
    const auto set = [end](Opcode kind, std::uint32_t, double& value, const Range& range) {
      if (!others.has_any(kind)) value = range.*end;
    };
    for_each_leaf(set, add(name), ranges_);
  }

  void add_positions(std::string name, double size, bool angles_only) {
    LeafValues<double>& values = add(std::move(name));
    for (std::size_t i = 0; i < values.q.size(); ++i) {
      if (!angles_only || is_angle_[i]) values.q[i] = draw_.random_sign() * size;
    }
  }

  void add_rates(std::string name, double size) {
    const auto set = [&](const LeafRow& row, std::vector<double>& all) {
      if (row.group != FactorGroup::rate || !is_sampled(space_.leaves, row.id)) return;
      for (double& x : all) x = draw_.random_sign() * size;
    };
    for_each_list(set, add(std::move(name)));
  }

  /// Adds a state in which every second parameter is multiplied by `ratio`.
  void add_parameter_ratios(double ratio) {
    LeafValues<double>& values = add(fmt::format("parameter ratios {:g}", ratio));
    for (std::size_t i = 0; i < values.parameters.size(); i += 2) values.parameters[i] *= ratio;
  }

  /// Adds states with all angles about 1e-15 from 0, pi/2 or pi, at which charts are singular:
  /// gimbals, poles, aligned links.
  void add_singular_charts() {
    for (const double angle : {0.0, pi / 2, pi}) {
      LeafValues<double>& values = add(fmt::format("angles 1e-15 from {:.3g}", angle));
      double distance = 1e-15;
      for (std::size_t i = 0; i < values.q.size(); ++i, distance = -2 * distance) {
        if (is_angle_[i]) values.q[i] = angle + distance;
      }
    }
  }

  /// Adds at most `most` states. Each has one parameter multiplied or divided by one of `sizes`,
  /// and angles of one kind of CancellingAngles. In these states sums of masses or lengths cancel,
  /// and the small sums are divisors.
  void add_combinations(const std::vector<double>& sizes, std::size_t most) {
    const std::size_t places = std::size(all_cancelling_angles);
    const std::size_t per_parameter = 2 * sizes.size() * places;
    const std::size_t all = space_.model.parameters.size() * per_parameter;
    const std::size_t step = all > most ? golden_step(all) : 1;
    for (std::size_t i = 0; i < std::min(all, most); ++i) {
      const std::size_t which = i * step % all;
      const double size = sizes[which / places / 2 % sizes.size()];
      const bool is_small = which / places % 2 != 0;
      add_combination(which / per_parameter, is_small ? 1 / size : size,
                      all_cancelling_angles[which % places]);
    }
  }

  void add_combination(std::size_t parameter, double ratio, CancellingAngles place) {
    constexpr std::array words{"near right ones", "near straight ones", "nearly equal", "tiny"};
    LeafValues<double>& values =
        add(fmt::format("{} times {:g}, angles {}", space_.model.parameters[parameter].name, ratio,
                        words[static_cast<std::size_t>(place)]));
    values.parameters[parameter] *= ratio;
    draw_.set_angles(place, is_angle_, values.q);
  }

  const StateSpace& space_;
  LeafValues<double> nominal_values_;
  Ranges ranges_;
  std::vector<bool> is_angle_ = {};
  Sampler& draw_;
  std::vector<SampledState<double>> states_;
};

}  // namespace

LeafValues<Range> ranges_of(const StateSpace& space) {
  const Model& model = space.model;
  const LeafValues<double> values = nominal_values(space);
  Ranges ranges = map_leaves([](double) { return Range{}; }, values);
  const auto fill = [&](Opcode kind, std::uint32_t number, double value, Range& range) {
    const std::optional<Interval> declared = declared_range(model, kind, number);
    double otherwise = default_rate;
    if (kind == Opcode::coordinate) otherwise = is_angle(model.coordinates[number]) ? pi : 1;
    range = kind == Opcode::step ? step_range : range_or_default(declared, otherwise);
    if (kind == Opcode::parameter && !declared) range = {value, value};
  };
  for_each_leaf(fill, values, ranges);
  return ranges;
}

template <class Number>
void normalize_quaternions(const Model& model, LeafValues<Number>& values) {
  constexpr bool is_real = std::is_same_v<Number, Real>;
  for (const Rotation& rotation : model.rotations) {
    Number* const e = &values.q[rotation.first_coordinate];
    std::vector<Real> exact;
    Real square;
    for (std::size_t i = 0; i < quaternion_size; ++i) {
      if constexpr (is_real) exact.push_back(e[i]);
      if constexpr (!is_real) exact.emplace_back(exact_value(e[i]));
      square = square + exact[i] * exact[i];
    }
    if (!(square > Real()) && square.is_defined()) {
      e[0] = Number(1);
      continue;
    }
    const Real length = sqrt(square);
    for (std::size_t i = 0; i < quaternion_size; ++i) {
      const Real scaled = exact[i] / length;
      if constexpr (is_real) e[i] = scaled;
      if constexpr (!is_real) e[i] = ScalarTraits<Number>::from_real(scaled.value());
    }
  }
}
template void normalize_quaternions(const Model& model, LeafValues<double>& values);
template void normalize_quaternions(const Model& model, LeafValues<Real>& values);

LeafValues<double> draw_in_ranges(const StateSpace& space, const LeafValues<Range>& ranges,
                                  Sampler& draw) {
  LeafValues<double> values = draw_nominal(space.leaves, ranges, nominal_values(space), draw);
  normalize_quaternions(space.model, values);
  return values;
}

Domain domain_of(const StateSpace& space) {
  Domain domain{space.model, ranges_of(space)};
  Sampler draw(1);
  for (std::size_t i = 0; i < domain_states; ++i) {
    domain.states.push_back(draw_in_ranges(space, domain.ranges, draw));
  }
  return domain;
}

template <class Scalar>
LeafValues<Scalar> round_to_finite(const LeafValues<double>& values) {
  const auto nearest = [](double value) {
    constexpr double largest = std::numeric_limits<Scalar>::max();
    return static_cast<Scalar>(std::clamp(value, -largest, largest));
  };
  return map_leaves(nearest, values);
}

std::size_t golden_step(std::size_t count) {
  std::size_t step = count * 618 / 1000 + 1;
  while (std::gcd(step, count) != 1) ++step;
  return step;
}

template <class Scalar>
StateSequence<Scalar>::StateSequence(const StateSpace& space, const SamplingOptions& sampling)
    : space_(space),
      sampling_(sampling),
      draw_(sampling.seed),
      nominal_values_(nominal_values(space)),
      ranges_(ranges_of(space)) {}

template <class Scalar>
SampledState<double> StateSequence<Scalar>::random_state(std::size_t number) {
  // 2^-40 = 1e-12 and 2^-10 = 1e-3 for small, 2^-27 = 1e-8 and 2^27 = 1e8 for large
  if (number % 4 < 2) {
    return {Region::nominal, {}, draw_nominal(space_.leaves, ranges_, nominal_values_, draw_)};
  }
  if (number % 4 == 2)
    return {Region::small, {}, draw_scaled(space_.leaves, nominal_values_, draw_, -40, -11)};
  return {Region::large, {}, draw_scaled(space_.leaves, nominal_values_, draw_, -27, 26)};
}

template <class Scalar>
std::optional<SampledState<double>> StateSequence<Scalar>::next_in_double() {
  const std::size_t number = drawn_++;
  if (number < sampling_.count) return random_state(number);
  if (!sampling_.extremes) return std::nullopt;
  if (!extremes_)
    extremes_ =
        ExtremeStates(space_, draw_).make_states(extreme_magnitudes<Scalar>(), sampling_.count);
  const std::size_t extreme = number - sampling_.count;
  if (extreme >= extremes_->size()) return std::nullopt;
  return (*extremes_)[extreme];
}

template <class Scalar>
std::optional<SampledState<Scalar>> StateSequence<Scalar>::next() {
  std::optional<SampledState<double>> state = next_in_double();
  if (!state) return std::nullopt;
  normalize_quaternions(space_.model, state->values);
  return SampledState<Scalar>{state->region, state->name, round_to_finite<Scalar>(state->values)};
}

template <class Scalar>
std::vector<SampledState<Scalar>> sample_states(const StateSpace& space,
                                                const SamplingOptions& sampling) {
  StateSequence<Scalar> sequence(space, sampling);
  std::vector<SampledState<Scalar>> states;
  while (auto state = sequence.next()) states.push_back(std::move(*state));
  return states;
}

template <class Scalar>
std::vector<SampledState<Scalar>> remote_states(const StateSpace& space, std::uint64_t seed) {
  const std::vector<bool> is_unbounded = unbounded_coordinates(space.model);
  if (std::ranges::find(is_unbounded, true) == is_unbounded.end()) return {};
  const Ranges ranges = ranges_of(space);
  Sampler draw(seed);
  std::vector<SampledState<Scalar>> states;
  for (const double magnitude : remote_magnitudes) {
    for (const double value : {magnitude, -magnitude}) {
      LeafValues<double> values = draw_in_ranges(space, ranges, draw);
      draw.set_remote(value, is_unbounded, values.q);
      if (states.size() % 2 != 0) {
        for (auto* rates : {&values.v, &values.a, &values.u}) std::ranges::fill(*rates, 0.0);
      }
      states.push_back({Region::remote, {}, round_to_finite<Scalar>(values)});
    }
  }
  return states;
}

template LeafValues<double> round_to_finite(const LeafValues<double>&);
template LeafValues<float> round_to_finite(const LeafValues<double>&);
template class StateSequence<double>;
template class StateSequence<float>;
template std::vector<SampledState<double>> sample_states(const StateSpace&, const SamplingOptions&);
template std::vector<SampledState<float>> sample_states(const StateSpace&, const SamplingOptions&);
template std::vector<SampledState<double>> remote_states(const StateSpace&, std::uint64_t);
template std::vector<SampledState<float>> remote_states(const StateSpace&, std::uint64_t);

}  // namespace elgen
