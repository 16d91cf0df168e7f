// Sampled states. The extremes of float are milder than those of double: its exponents are an
// eighth as wide.
#include "sample/states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>

#include "elgen/leaf_names.hpp"
#include "numbers/random.hpp"

namespace elgen {
namespace {

constexpr double pi = 3.141592653589793;

/// Ranges may reach beyond every scalar. A quarter of the largest number leaves their widths
/// finite.
double within_scalar(const cln::cl_R& value) {
  constexpr double largest = std::numeric_limits<double>::max() / 4;
  return std::clamp(ScalarTraits<double>::from_real(value), -largest, largest);
}

Range range_or(const std::optional<Interval>& interval, double otherwise) {
  if (!interval) return {-otherwise, otherwise};
  return {within_scalar(interval->low), within_scalar(interval->high)};
}

/// Of rates, momenta, accelerations, inputs, open values and time.
constexpr double default_rate = 10;
constexpr Range steps{0, 0.1};  ///< in s: a rate of 10 moves by 1 in the longest one

using Ranges = LeafValues<Range>;

Arguments<double> values_of(const Subject& subject) {
  return arguments_at<double>(nominal_state(subject.model, subject.scene));
}

/// Parameters keep their values, and E follows from the others; momenta and h are drawn where a
/// function takes them.
bool is_drawn(const Subject& subject, Opcode kind) {
  const LeafNames& leaves = subject.program.leaves;
  if (kind == Opcode::momentum) return !leaves.momenta.empty();
  if (kind == Opcode::step) return !leaves.h.empty();
  return kind != Opcode::parameter && !never_passed.has_any(kind);
}

/// From `values`: parameters stay.
Arguments<double> nominal(const Subject& subject, const Ranges& ranges, Arguments<double> values,
                          Random& random) {
  const auto draw = [&](Opcode kind, std::uint32_t, double& value, const Range& range) {
    if (is_drawn(subject, kind)) value = random.uniform(range.low, range.high);
  };
  for_each_leaf(draw, values, ranges);
  return values;
}

/// Every variable of magnitude 2^low … 2^high.
Arguments<double> scaled(const Subject& subject, Arguments<double> values, Random& random, int low,
                         int high) {
  const auto draw = [&](Opcode kind, std::uint32_t, double& value) {
    if (is_drawn(subject, kind)) value = random.log_uniform(low, high);
  };
  for_each_leaf(draw, values);
  return values;
}

/// How far a scalar's extremes reach.
struct Reach {
  std::vector<double> tiny;
  std::vector<double> angles;
  std::vector<double> rates;
  std::vector<double> ratios;  ///< of parameters
};

template <class Scalar>
Reach reach() {
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

/// Makes the extremes, each from a fresh nominal state: one thing at a time, and then what loses
/// digits together.
class Extremes {
 public:
  Extremes(const Subject& subject, Random& random)
      : subject_(subject),
        at_value_(values_of(subject)),
        ranges_(ranges_of(subject)),
        random_(random) {}

  std::vector<SampledState<double>> make(const Reach& reach, std::size_t most_combinations) {
    add("origin") = at_value_;
    ends("low ends of ranges", &Range::low);
    ends("high ends of ranges", &Range::high);
    for (const double size : reach.tiny) {
      set_positions(fmt::format("positions {:g}", size), size, false);
      set_rates(fmt::format("rates {:g}", size), size);
    }
    for (const double size : reach.angles) {
      set_positions(fmt::format("angles {:g}", size), size, true);
    }
    for (const double size : reach.rates) set_rates(fmt::format("rates {:g}", size), size);
    ratios(reach.ratios.back());
    ratios(1 / reach.ratios.back());
    charts();
    combinations(reach.ratios, most_combinations);
    return std::move(states_);
  }

 private:
  Arguments<double>& add(std::string name) {
    states_.push_back(
        {Region::extreme, std::move(name), nominal(subject_, ranges_, at_value_, random_)});
    return states_.back().values;
  }

  void ends(const char* name, double Range::*end) {
    static constexpr LeafSet others = Opcode::parameter | Opcode::acceleration | Opcode::time;
    const auto set = [end](Opcode kind, std::uint32_t, double& value, const Range& range) {
      if (!others.has_any(kind)) value = range.*end;
    };
    for_each_leaf(set, add(name), ranges_);
  }

  void set_positions(std::string name, double size, bool angles_only) {
    Arguments<double>& values = add(std::move(name));
    for (std::size_t i = 0; i < values.q.size(); ++i) {
      if (angles_only && !is_angle(subject_.model.coordinates[i])) continue;
      values.q[i] = random_.uniform(0.5, 1) < 0.75 ? size : -size;
    }
  }

  /// And momenta, where functions take them.
  void set_rates(std::string name, double size) {
    Arguments<double>& values = add(std::move(name));
    const auto set = [&](std::vector<double>& all) {
      for (double& x : all) x = random_.uniform(0.5, 1) < 0.75 ? size : -size;
    };
    set(values.v);
    if (is_drawn(subject_, Opcode::momentum)) set(values.momenta);
  }

  /// Every second parameter times `ratio`.
  void ratios(double ratio) {
    Arguments<double>& values = add(fmt::format("parameter ratios {:g}", ratio));
    for (std::size_t i = 0; i < values.parameters.size(); i += 2) values.parameters[i] *= ratio;
  }

  /// Angles one part in 1e15 from where charts break: gimbals, poles, aligned links.
  void charts() {
    for (const double angle : {0.0, pi / 2, pi}) {
      Arguments<double>& values = add(fmt::format("angles 1e-15 from {:.3g}", angle));
      double distance = 1e-15;
      for (std::size_t i = 0; i < values.q.size(); ++i, distance = -2 * distance) {
        if (is_angle(subject_.model.coordinates[i])) values.q[i] = angle + distance;
      }
    }
  }

  /// Each parameter far from its value, where angles are near multiples of a right one, nearly the
  /// same, or tiny: sums of masses or lengths that cancel, and quotients of what is left of them.
  void combinations(const std::vector<double>& sizes, std::size_t most) {
    const std::size_t per_parameter = 2 * sizes.size() * places.size();
    const std::size_t all = subject_.model.parameters.size() * per_parameter;
    const std::size_t step = all > most ? golden_step(all) : 1;
    for (std::size_t i = 0; i < std::min(all, most); ++i) {
      const std::size_t which = i * step % all;
      const double size = sizes[which / places.size() / 2 % sizes.size()];
      const bool is_small = which / places.size() % 2 != 0;
      combination(which / per_parameter, is_small ? 1 / size : size, places[which % places.size()]);
    }
  }

  enum class Place : std::uint8_t { right, equal, tiny };
  static constexpr std::array places{Place::right, Place::equal, Place::tiny};

  void combination(std::size_t parameter, double ratio, Place place) {
    constexpr std::array<const char*, 3> words{"near right ones", "nearly equal", "tiny"};
    Arguments<double>& values =
        add(fmt::format("{} times {:g}, angles {}", subject_.model.parameters[parameter].name,
                        ratio, words[static_cast<std::size_t>(place)]));
    values.parameters[parameter] *= ratio;
    const double common = random_.uniform(-pi, pi);
    for (std::size_t i = 0; i < values.q.size(); ++i) {
      const double sign = random_.uniform(-1, 1) < 0 ? -1 : 1;
      const double share = random_.uniform(0.5, 1);
      const double right = std::floor(random_.uniform(-2, 3)) * (pi / 2);
      if (!is_angle(subject_.model.coordinates[i])) continue;
      if (place == Place::right) values.q[i] = right + sign * 1e-8;
      if (place == Place::equal) values.q[i] = common + sign * share * 1e-3;
      if (place == Place::tiny) values.q[i] = sign * 1e-8;
    }
  }

  const Subject& subject_;
  Arguments<double> at_value_;
  Ranges ranges_;
  Random& random_;
  std::vector<SampledState<double>> states_;
};

/// The nearest finite number: what a range reaches in double may be too large for float.
template <class Scalar>
Scalar finite(double value) {
  constexpr double largest = std::numeric_limits<Scalar>::max();
  return static_cast<Scalar>(std::clamp(value, -largest, largest));
}

}  // namespace

LeafValues<Range> ranges_of(const Subject& subject) {
  const Model& model = subject.model;
  const Arguments<double> values = values_of(subject);
  Ranges ranges = map_leaves([](double) { return Range{}; }, values);
  const auto fill = [&](Opcode kind, std::uint32_t number, double value, Range& range) {
    const std::optional<Interval> declared = declared_range(model, kind, number);
    double otherwise = default_rate;
    if (kind == Opcode::coordinate) otherwise = is_angle(model.coordinates[number]) ? pi : 1;
    range = kind == Opcode::step ? steps : range_or(declared, otherwise);
    if (kind == Opcode::parameter && !declared) range = {value, value};
  };
  for_each_leaf(fill, values, ranges);
  return ranges;
}

template <class Number>
void scale_quaternions(const Model& model, Arguments<Number>& values) {
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
template void scale_quaternions(const Model& model, Arguments<double>& values);
template void scale_quaternions(const Model& model, Arguments<Real>& values);

Arguments<double> drawn_within(const Subject& subject, const LeafValues<Range>& ranges,
                               Random& random) {
  Arguments<double> values = nominal(subject, ranges, values_of(subject), random);
  scale_quaternions(subject.model, values);
  return values;
}

template <class Scalar>
Arguments<Scalar> nearest_finite(const Arguments<double>& values) {
  return map_leaves([](double value) { return finite<Scalar>(value); }, values);
}

std::size_t golden_step(std::size_t count) {
  std::size_t step = count * 618 / 1000 + 1;
  while (std::gcd(step, count) != 1) ++step;
  return step;
}

template <class Scalar>
StateSequence<Scalar>::StateSequence(const Subject& subject, const Sampling& sampling)
    : subject_(subject),
      sampling_(sampling),
      random_(sampling.seed),
      at_value_(values_of(subject)),
      ranges_(ranges_of(subject)) {}

template <class Scalar>
SampledState<double> StateSequence<Scalar>::drawn_state(std::size_t number) {
  // 2^-40 = 1e-12, 2^-10 = 1e-3, 2^27 = 1e8
  if (number % 4 < 2) {
    return {Region::nominal, {}, nominal(subject_, ranges_, at_value_, random_)};
  }
  if (number % 4 == 2) return {Region::small, {}, scaled(subject_, at_value_, random_, -40, -11)};
  return {Region::large, {}, scaled(subject_, at_value_, random_, -27, 26)};
}

template <class Scalar>
std::optional<SampledState<double>> StateSequence<Scalar>::draw() {
  const std::size_t number = drawn_++;
  if (number < sampling_.count) return drawn_state(number);
  if (!sampling_.extremes) return std::nullopt;
  if (!extremes_) extremes_ = Extremes(subject_, random_).make(reach<Scalar>(), sampling_.count);
  const std::size_t extreme = number - sampling_.count;
  if (extreme >= extremes_->size()) return std::nullopt;
  return (*extremes_)[extreme];
}

template <class Scalar>
std::optional<SampledState<Scalar>> StateSequence<Scalar>::next() {
  std::optional<SampledState<double>> state = draw();
  if (!state) return std::nullopt;
  scale_quaternions(subject_.model, state->values);
  return SampledState<Scalar>{state->region, state->name, nearest_finite<Scalar>(state->values)};
}

template <class Scalar>
std::vector<SampledState<Scalar>> sample_states(const Subject& subject, const Sampling& sampling) {
  StateSequence<Scalar> sequence(subject, sampling);
  std::vector<SampledState<Scalar>> states;
  while (auto state = sequence.next()) states.push_back(std::move(*state));
  return states;
}

template Arguments<double> nearest_finite(const Arguments<double>&);
template Arguments<float> nearest_finite(const Arguments<double>&);
template class StateSequence<double>;
template class StateSequence<float>;
template std::vector<SampledState<double>> sample_states(const Subject&, const Sampling&);
template std::vector<SampledState<float>> sample_states(const Subject&, const Sampling&);

}  // namespace elgen
