// SPDX-License-Identifier: GPL-3.0-or-later
// points: see points.hpp. Places are found by folding the text over sums of numbers, multiples of
// one leaf and multiples of its square; everything else is opaque.
#include "choose/points.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/random.hpp"
#include "elgen/fold.hpp"
#include "evaluate/rough_errors.hpp"
#include "lower/graph/prune.hpp"

namespace elgen {
namespace {

constexpr std::size_t plain_points = 4;  ///< at the values of parameters, and at other values
constexpr std::size_t most_places = 10;
constexpr std::size_t most_together = 4;  ///< sums whose coordinates are moved all at once
constexpr int widest_factor = 3;          ///< of parameters, as a power of two

/// Relative, but at 0: multiples of 2^-30 near 1e-1, 1e-2, 1e-4 and 1e-8.
constexpr double unit_of_distance = 0x1p-30;
constexpr double distances[]{107374182 * unit_of_distance, 10737418 * unit_of_distance,
                             107374 * unit_of_distance, 11 * unit_of_distance};

/// The distances of all coordinates at once from their first places.
constexpr double near = distances[2];
constexpr double nearest = distances[3];

/// Of coordinates without a range in exp(u) and log(u): a few decades of u, and most of double's.
constexpr double far_away[]{16, -16, 1024, -1024};

constexpr double half_turn = 3.141592653589793;
constexpr double places_of_sines[]{half_turn, half_turn / 2, -half_turn / 2, -half_turn};

/// Functions of functions are looked into so deep.
constexpr int deepest = 3;

/// Sums of more terms are opaque: none of their terms cancels another alone.
constexpr std::size_t most_parts = 8;

struct SumPart;
using SumParts = std::vector<SumPart>;

/// factor, factor x or factor x^2 of a coordinate x, a root, an inverse or a function of a sum; or
/// opaque.
struct SumPart {
  enum class Kind : std::uint8_t { number, linear, square, root, inverse, call, opaque };
  Kind kind = Kind::opaque;
  double factor = 1;
  std::uint32_t coordinate = 0;
  FunctionId function = FunctionId::sin;
  std::shared_ptr<const SumParts> inner = {};  ///< what it is a root, an inverse or a function of
};

/// A coordinate is near `factor` times another one, or near the number `factor`.
struct NearPlace {
  std::uint32_t coordinate = 0;
  double factor = 0;
  std::optional<std::uint32_t> other = {};
  friend bool operator==(const NearPlace&, const NearPlace&) = default;
};

using NearPlaces = std::vector<NearPlace>;

/// Whether `place` moves nothing that `known` moves or rests on.
bool fits_beside(const NearPlaces& known, const NearPlace& place) {
  return std::ranges::none_of(known, [&place](const NearPlace& other) {
    return other.coordinate == place.coordinate || other.other == place.coordinate ||
           place.other == other.coordinate;
  });
}

/// The rules of fold.hpp. Numbers stand for parameters at their values.
struct SumPartRules {
  const Arguments<double>& values;

  [[nodiscard]] static SumParts number(double value) { return {{SumPart::Kind::number, value}}; }
  [[nodiscard]] SumParts constant(const Constant& constant) const {
    return number(ScalarTraits<double>::from_real(constant.value));
  }
  [[nodiscard]] SumParts leaf(Opcode kind, std::uint32_t index) const {
    if (kind == Opcode::parameter) return number(values.parameters[index]);
    if (kind == Opcode::coordinate) return {{SumPart::Kind::linear, 1, index}};
    return {SumPart{}};
  }
  [[nodiscard]] SumParts negate(SumParts x) const {
    for (SumPart& part : x) part.factor = -part.factor;
    return x;
  }
  [[nodiscard]] SumParts add(SumParts x, const SumParts& y) const {
    x.insert(x.end(), y.begin(), y.end());
    if (x.size() > most_parts) return {SumPart{}};
    return x;
  }
  [[nodiscard]] SumParts subtract(const SumParts& x, const SumParts& y) const {
    return add(x, negate(y));
  }
  [[nodiscard]] SumParts multiply(const SumParts& x, const SumParts& y) const {
    using enum SumPart::Kind;
    if (x.size() > 1 || y.size() > 1) return {SumPart{}};
    if (y[0].kind == number) return scaled(x[0], y[0].factor);
    if (x[0].kind == number) return scaled(y[0], x[0].factor);
    const bool is_square =
        x[0].kind == linear && y[0].kind == linear && x[0].coordinate == y[0].coordinate;
    if (!is_square) return {SumPart{}};
    return {{square, x[0].factor * y[0].factor, x[0].coordinate}};
  }
  [[nodiscard]] static SumParts scaled(SumPart part, double factor) {
    part.factor *= factor;
    return {part};
  }
  [[nodiscard]] SumParts divide(const SumParts& x, const SumParts& y) const {
    const bool is_number = y.size() == 1 && y[0].kind == SumPart::Kind::number;
    return multiply(x, is_number ? number(1 / y[0].factor) : made_of(SumPart::Kind::inverse, y));
  }
  [[nodiscard]] SumParts square_root(const SumParts& x) const {
    return made_of(SumPart::Kind::root, x);
  }
  [[nodiscard]] SumParts call(FunctionId function, const SumParts& x, const SumParts&) const {
    SumParts result = made_of(SumPart::Kind::call, x);
    result[0].function = function;
    return function_row(function).arity == 1 ? result : SumParts{SumPart{}};
  }
  static SumParts made_of(SumPart::Kind kind, const SumParts& x) {
    SumPart part{.kind = kind};
    part.inner = std::make_shared<const SumParts>(x);
    return {part};
  }
};

/// The places of all coordinates: 0, where two terms of a sum cancel, and right angles.
class CancellingPlaces {
 public:
  CancellingPlaces(const Program& program, const Function& text, const Domain& domain)
      : domain_(domain), count_(program.leaves.q.size()), found_(count_) {
    for (std::uint32_t i = 0; i < count_; ++i) add({i, 0});
    const auto parts = fold<SumParts>(SumPartRules{domain.states.front()}, program, text);
    std::vector<NearPlaces> below;
    for (const Instruction& i : text.instructions) {
      latest_.clear();
      if (is_sum(i)) add_cancelling(parts[below.size()]);
      below.push_back(places_below(i, below));
      add_together(text, i, below);
    }
    std::vector<bool> is_angle(count_);
    for (const Instruction& i : text.instructions) {
      if (i.opcode != Opcode::call) continue;
      if (i.function == FunctionId::log) add_ones(parts[i.a]);
      if (!is_circular(i.function)) continue;
      for (const SumPart& part : parts[i.a]) {
        if (part.kind == SumPart::Kind::linear) is_angle[part.coordinate] = true;
      }
    }
    add_angles(is_angle);
  }

  /// Taken from the coordinates in turn.
  [[nodiscard]] NearPlaces first(std::size_t most) const {
    NearPlaces places;
    bool has_more = true;
    for (std::size_t turn = 0; has_more; ++turn) {
      has_more = false;
      for (const NearPlaces& of_coordinate : found_) {
        if (turn >= of_coordinate.size()) continue;
        if (places.size() == most) return places;
        places.push_back(of_coordinate[turn]);
        has_more = true;
      }
    }
    return places;
  }

  /// Where sums under a product, a root, a quotient or a function vanish with all of their terms.
  [[nodiscard]] const std::vector<NearPlaces>& together() const { return together_; }

 private:
  void add(const NearPlace& place) {
    NearPlaces& known = found_[place.coordinate];
    const bool is_alone = domain_.is_alone[place.coordinate];
    if (!is_alone || !std::isfinite(place.factor)) return;
    latest_.push_back(place);
    if (std::ranges::find(known, place) == known.end()) known.push_back(place);
  }

  static bool is_sum(const Instruction& i) {
    return i.opcode == Opcode::add || i.opcode == Opcode::subtract;
  }

  static bool is_wave(const Instruction& i) {
    return i.opcode == Opcode::call && is_circular(i.function);
  }

  /// The latest ones, and those of the operands; sines and cosines do not vanish with their angles.
  [[nodiscard]] NearPlaces places_below(const Instruction& i,
                                        const std::vector<NearPlaces>& below) const {
    NearPlaces all = latest_;
    if (i.opcode == Opcode::coordinate && domain_.is_alone[i.a]) all.push_back({i.a, 0});
    const std::size_t operands = is_wave(i) ? 0 : operand_count(i);
    if (operands > 0) all.insert(all.end(), below[i.a].begin(), below[i.a].end());
    if (operands > 1) all.insert(all.end(), below[i.b].begin(), below[i.b].end());
    NearPlaces fitting;
    for (const NearPlace& place : all) {
      if (fitting.size() < most_parts && fits_beside(fitting, place)) fitting.push_back(place);
    }
    return fitting;
  }

  /// Those of the sums that a product, a root, a quotient or a function is made of. Zeros of the
  /// coordinates themselves are drawn anyway.
  void add_together(const Function& text, const Instruction& i,
                    const std::vector<NearPlaces>& below) {
    if (is_sum(i) || is_wave(i) || i.opcode == Opcode::negate) return;
    for (std::size_t k = 0; k < operand_count(i); ++k) {
      const std::uint32_t operand = k == 0 ? i.a : i.b;
      const NearPlaces& places = below[operand];
      const bool is_elsewhere = std::ranges::any_of(
          places, [](const NearPlace& place) { return place.factor != 0 || place.other; });
      if (!is_sum(text.instructions[operand]) || !is_elsewhere) continue;
      if (std::ranges::find(together_, places) != together_.end()) continue;
      if (together_.size() < most_together) together_.push_back(places);
    }
  }

  /// Where two angles are equal, sums of products of their sines and cosines cancel; then right
  /// angles.
  void add_angles(const std::vector<bool>& is_angle) {
    for (std::uint32_t i = 0; i < count_; ++i) {
      for (std::uint32_t k = i + 1; k < count_; ++k) {
        if (is_angle[i] && is_angle[k]) add({i, 1, k});
      }
    }
    for (std::uint32_t i = 0; i < count_; ++i) {
      for (const double place : places_of_sines) {
        if (is_angle[i]) add({i, place});
      }
    }
  }

  /// log(x) vanishes at 1.
  void add_ones(const SumParts& argument) {
    SumParts less = argument;
    less.push_back({SumPart::Kind::number, -1});
    add_cancelling(less);
  }

  void add_cancelling(const SumParts& sum) {
    SumPart total{SumPart::Kind::number, 0};
    for (const SumPart& part : sum) {
      if (part.kind == SumPart::Kind::number) total.factor += part.factor;
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
      if (total.factor != 0) add_cancelling(sum[i], total);
      for (std::size_t k = 0; k < sum.size(); ++k) {
        if (k != i && sum[k].kind != SumPart::Kind::number) add_cancelling(sum[i], sum[k]);
      }
    }
  }

  void add_cancelling(const SumPart& x, const SumPart& y) {
    using Kind = SumPart::Kind;
    if (x.kind == Kind::number || x.kind == Kind::opaque) return;
    const double ratio = -y.factor / x.factor;
    if (x.inner) return add_equal(x, y, ratio);
    const bool is_same = x.kind == y.kind && x.coordinate != y.coordinate;
    if (!is_same && y.kind != Kind::number) return;
    const std::optional<std::uint32_t> other =
        y.kind == Kind::number ? std::nullopt : std::optional(y.coordinate);
    if (x.kind == Kind::linear) return add({x.coordinate, ratio, other});
    if (ratio <= 0) return;
    add({x.coordinate, std::sqrt(ratio), other});
    add({x.coordinate, -std::sqrt(ratio), other});
  }

  /// Where f(a) = ratio f(b), or a root or an inverse of a is a number.
  void add_equal(const SumPart& x, const SumPart& y, double ratio) {
    using Kind = SumPart::Kind;
    SumParts difference = *x.inner;
    if (y.kind == Kind::number && x.kind == Kind::root && ratio > 0) {
      difference.push_back({Kind::number, -ratio * ratio});
    } else if (y.kind == Kind::number && x.kind == Kind::inverse) {
      difference.push_back({Kind::number, -1 / ratio});
    } else if (y.kind == x.kind && y.function == x.function && std::abs(ratio) == 1) {
      for (SumPart part : *y.inner) {
        part.factor *= -ratio;
        difference.push_back(part);
      }
    } else {
      return;
    }
    if (++depth_ <= deepest) add_cancelling(difference);
    --depth_;
  }

  const Domain& domain_;
  std::size_t count_;
  std::vector<NearPlaces> found_;          ///< by coordinate
  NearPlaces latest_ = {};                 ///< of one sum
  std::vector<NearPlaces> together_ = {};  ///< by sum
  int depth_ = 0;
};

class Making {
 public:
  Making(const Program& program, const Function& text, const Domain& domain,
         const CancellingPlaces& places)
      : program_(program),
        text_(text),
        domain_(domain),
        places_(places.first(most_places)),
        together_(places.together()) {}

  ComparisonPoints operator()() {
    for (std::size_t i = 0; i < plain_points; ++i) points_.push_back(state());
    for (std::size_t i = 0; i < plain_points; ++i)
      points_.push_back(with_other_parameters(state()));
    for (const NearPlace& place : places_) {
      for (const double distance : distances) add_near(place, distance);
    }
    add_near_all(places_);
    for (const NearPlaces& places : together_) add_near_all(places);
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

  /// T, the inertia of accelerations and inputs, which are large elsewhere, are 0: they hide what a
  /// force that holds the system loses.
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

  /// By coordinate, whether it has no range and an exponential or a logarithm is taken of it.
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
  NearPlaces places_;
  std::vector<NearPlaces> together_;
  Random random_{1};
  std::size_t next_ = 0;
  ComparisonPoints points_ = {};
};

}  // namespace

ComparisonPoints comparison_points(const Program& program, const Function& text,
                                   const Domain& domain) {
  return Making(program, text, domain, CancellingPlaces(program, text, domain))();
}

}  // namespace elgen
