// cancelling_places: finds states at which sums in a function vanish.
//
//     before    F*sqrt((x - a)^2 + y^2)
//     after     x near a and -a, x near 0, y near 0
//
// Reads the function as nested sums. A term of a sum is a number, or a number times one factor: a
// coordinate, the square of a coordinate, or a root, inverse or function of a sum. All other terms
// are opaque.
#include <algorithm>
#include <cmath>
#include <memory>

#include "choose/points.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/fold.hpp"

namespace elgen {
namespace {

constexpr double half_turn = 3.141592653589793;
constexpr double trigonometric_zeros[]{half_turn, half_turn / 2, -half_turn / 2, -half_turn};

/// The maximal nesting of functions, roots and inverses that is searched.
constexpr int max_nesting = 3;

/// Longer sums are opaque: two cancelling terms seldom make them vanish.
constexpr std::size_t max_sum_terms = 8;

struct SumTerm;
using SumTerms = std::vector<SumTerm>;

/// One term of a sum, in doubles because it only serves to find zeros: a number `factor`; `factor`
/// times x or x^2, with a coordinate x; `factor` times a root, inverse or function of a sum. Any
/// other term is opaque.
struct SumTerm {
  enum class Kind : std::uint8_t { number, linear, square, root, inverse, call, opaque };
  Kind kind = Kind::opaque;
  double factor = 1;
  std::uint32_t coordinate = 0;
  FunctionId function = FunctionId::sin;
  std::shared_ptr<const SumTerms> inner = {};  ///< operand of a root, an inverse or a function
};

/// Folding rules (fold.hpp). Parameters are replaced by their values.
struct SumTermRules {
  const Arguments<double>& values;

  [[nodiscard]] static SumTerms number(double value) { return {{SumTerm::Kind::number, value}}; }
  [[nodiscard]] SumTerms constant(const Constant& constant) const {
    return number(to_double(constant.value));
  }
  [[nodiscard]] SumTerms leaf(Opcode kind, std::uint32_t index) const {
    if (kind == Opcode::parameter) return number(values.parameters[index]);
    if (kind == Opcode::coordinate) return {{SumTerm::Kind::linear, 1, index}};
    return {SumTerm{}};
  }
  [[nodiscard]] SumTerms negate(SumTerms x) const {
    for (SumTerm& part : x) part.factor = -part.factor;
    return x;
  }
  [[nodiscard]] SumTerms add(SumTerms x, const SumTerms& y) const {
    x.insert(x.end(), y.begin(), y.end());
    if (x.size() > max_sum_terms) return {SumTerm{}};
    return x;
  }
  [[nodiscard]] SumTerms subtract(const SumTerms& x, const SumTerms& y) const {
    return add(x, negate(y));
  }
  [[nodiscard]] SumTerms multiply(const SumTerms& x, const SumTerms& y) const {
    using enum SumTerm::Kind;
    if (x.size() > 1 || y.size() > 1) return {SumTerm{}};
    if (y[0].kind == number) return scale(x[0], y[0].factor);
    if (x[0].kind == number) return scale(y[0], x[0].factor);
    const bool is_square =
        x[0].kind == linear && y[0].kind == linear && x[0].coordinate == y[0].coordinate;
    if (!is_square) return {SumTerm{}};
    return {{square, x[0].factor * y[0].factor, x[0].coordinate}};
  }
  [[nodiscard]] static SumTerms scale(SumTerm part, double factor) {
    part.factor *= factor;
    return {part};
  }
  [[nodiscard]] SumTerms divide(const SumTerms& x, const SumTerms& y) const {
    const bool is_number = y.size() == 1 && y[0].kind == SumTerm::Kind::number;
    return multiply(x,
                    is_number ? number(1 / y[0].factor) : nested_term(SumTerm::Kind::inverse, y));
  }
  [[nodiscard]] SumTerms square_root(const SumTerms& x) const {
    return nested_term(SumTerm::Kind::root, x);
  }
  [[nodiscard]] SumTerms call(FunctionId function, const SumTerms& x, const SumTerms&) const {
    SumTerms result = nested_term(SumTerm::Kind::call, x);
    result[0].function = function;
    return function_row(function).arity == 1 ? result : SumTerms{SumTerm{}};
  }
  static SumTerms nested_term(SumTerm::Kind kind, const SumTerms& x) {
    SumTerm part{.kind = kind};
    part.inner = std::make_shared<const SumTerms>(x);
    return {part};
  }
};

/// The sum of the terms that are numbers.
SumTerm constant_term(const SumTerms& sum) {
  SumTerm total{SumTerm::Kind::number, 0};
  for (const SumTerm& part : sum) {
    if (part.kind == SumTerm::Kind::number) total.factor += part.factor;
  }
  return total;
}

/// At most `most` places: the first of each coordinate, then the second of each, and so on.
NearPlaces interleave_places(const std::vector<NearPlaces>& by_coordinate, std::size_t most) {
  NearPlaces places;
  bool has_more = true;
  for (std::size_t turn = 0; has_more; ++turn) {
    has_more = false;
    for (const NearPlaces& of_coordinate : by_coordinate) {
      if (turn >= of_coordinate.size()) continue;
      if (places.size() == most) return places;
      places.push_back(of_coordinate[turn]);
      has_more = true;
    }
  }
  return places;
}

/// Finds places for all coordinates: 0, zeros at which two terms of a sum cancel, and multiples of
/// pi/2.
class PlaceSearch {
 public:
  PlaceSearch(const Program& program, const Function& text, const Domain& domain)
      : domain_(domain), count_(program.leaves.q.size()), places_(count_) {
    for (std::uint32_t i = 0; i < count_; ++i) add_place({i, 0});
    const auto parts = fold<SumTerms>(SumTermRules{domain.states.front()}, program, text);
    for (std::size_t at = 0; at < parts.size(); ++at) {
      if (is_sum(text.instructions[at])) add_cancelling_places(parts[at]);
    }
    std::vector<bool> is_angle(count_);
    for (const Instruction& i : text.instructions) {
      if (i.opcode != Opcode::call) continue;
      if (i.function == FunctionId::log) add_unit_arguments(parts[i.a]);
      if (!is_circular(i.function)) continue;
      for (const SumTerm& part : parts[i.a]) {
        if (part.kind == SumTerm::Kind::linear) is_angle[part.coordinate] = true;
      }
    }
    add_angles(is_angle);
  }

  [[nodiscard]] const std::vector<NearPlaces>& by_coordinate() const { return places_; }

 private:
  void add_place(const NearPlace& place) {
    NearPlaces& known = places_[place.coordinate];
    if (!is_scalar_coordinate(place.coordinate) || !std::isfinite(place.factor)) return;
    if (std::ranges::find(known, place) == known.end()) known.push_back(place);
  }

  /// False for a component of a quaternion.
  [[nodiscard]] bool is_scalar_coordinate(std::uint32_t coordinate) const {
    return !domain_.model.coordinates[coordinate].rotation;
  }

  /// Adds places at which two angles are equal: sums of products of their sines and cosines cancel
  /// there. Then adds the multiples of pi/2.
  void add_angles(const std::vector<bool>& is_angle) {
    for (std::uint32_t i = 0; i < count_; ++i) {
      for (std::uint32_t k = i + 1; k < count_; ++k) {
        if (is_angle[i] && is_angle[k]) add_place({i, 1, k});
      }
    }
    for (std::uint32_t i = 0; i < count_; ++i) {
      for (const double place : trigonometric_zeros) {
        if (is_angle[i]) add_place({i, place});
      }
    }
  }

  /// Adds places at which the argument is 1, because log vanishes there.
  void add_unit_arguments(const SumTerms& argument) {
    SumTerms less = argument;
    less.push_back({SumTerm::Kind::number, -1});
    add_cancelling_places(less);
  }

  void add_cancelling_places(const SumTerms& sum) {
    const SumTerm total = constant_term(sum);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      if (total.factor != 0) add_cancelling_places(sum[i], total);
      for (std::size_t k = 0; k < sum.size(); ++k) {
        if (k != i && sum[k].kind != SumTerm::Kind::number) add_cancelling_places(sum[i], sum[k]);
      }
    }
  }

  void add_cancelling_places(const SumTerm& x, const SumTerm& y) {
    using Kind = SumTerm::Kind;
    if (x.kind == Kind::number || x.kind == Kind::opaque) return;
    const double ratio = -y.factor / x.factor;
    if (x.inner) return add_places_of_equality(x, y, ratio);
    const bool is_same = x.kind == y.kind && x.coordinate != y.coordinate;
    if (!is_same && y.kind != Kind::number) return;
    const std::optional<std::uint32_t> other =
        y.kind == Kind::number ? std::nullopt : std::optional(y.coordinate);
    if (x.kind == Kind::linear) return add_place({x.coordinate, ratio, other});
    if (ratio <= 0) return;
    add_place({x.coordinate, std::sqrt(ratio), other});
    add_place({x.coordinate, -std::sqrt(ratio), other});
  }

  /// Adds places at which x, the root, inverse or function f of a sum a, cancels y. If y is a
  /// number, a root or inverse x is solved for a. For f(a) = ±f(b), the places have a = ±b.
  void add_places_of_equality(const SumTerm& x, const SumTerm& y, double ratio) {
    using Kind = SumTerm::Kind;
    SumTerms difference = *x.inner;
    if (y.kind == Kind::number && x.kind == Kind::root && ratio > 0) {
      difference.push_back({Kind::number, -ratio * ratio});
    } else if (y.kind == Kind::number && x.kind == Kind::inverse) {
      difference.push_back({Kind::number, -1 / ratio});
    } else if (y.kind == x.kind && y.function == x.function && std::abs(ratio) == 1) {
      for (SumTerm part : *y.inner) {
        part.factor *= -ratio;
        difference.push_back(part);
      }
    } else {
      return;
    }
    if (++depth_ <= max_nesting) add_cancelling_places(difference);
    --depth_;
  }

  const Domain& domain_;
  std::size_t count_;
  std::vector<NearPlaces> places_;  ///< by coordinate
  int depth_ = 0;
};

}  // namespace

NearPlaces cancelling_places(const Program& program, const Function& text, const Domain& domain,
                             std::size_t most) {
  return interleave_places(PlaceSearch(program, text, domain).by_coordinate(), most);
}

}  // namespace elgen
