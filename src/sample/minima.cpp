// Newton's method with Levenberg's term. With g = dV/dx, A = df/dx, H = d(g + A^T y)/dx and the
// largest magnitude |.| of the entries, each round solves
//
//     (H + d I) s + A^T y = -g,   A s = -f,   d = c |g + A^T y|       next x = x + s
//
// for the step s and the multipliers y. With d > 0 the equations are regular along cyclic
// coordinates; convergence stays quadratic, because d vanishes at the minimum. The factor c grows
// until V + w |f| decreases, and shrinks with every step.
#include "sample/minima.hpp"

#include <algorithm>
#include <utility>

#include "elgen/leaf_names.hpp"
#include "elgen/oracle.hpp"
#include "numbers/echelon.hpp"
#include "numbers/exact_number.hpp"
#include "sample/points.hpp"

namespace elgen {
namespace {

using Reals = std::vector<Real>;

/// Counts that bound the search. Most starts converge after 5 to 20 rounds.
constexpr std::size_t most_starts = 8;
constexpr std::size_t most_rounds = 40;
constexpr std::size_t most_minima = 3;
/// The number of tested combinations of typed values: 4 values of three coordinates.
constexpr std::size_t most_combinations = 64;
/// With more coordinates and constraints, the oracle takes too long.
constexpr std::size_t most_constrained_unknowns = 8;
/// The largest order of a zero of g at which steps are lengthened: 5 for V = x^6.
constexpr int most_zero_order = 5;

/// The least d, relative to |g| + |f| at the start. As the factor of -y in the second equation, it
/// makes the equations regular if constraints depend on each other.
const Real& least_damping() {
  static const Real value(power_of_ten(-44));
  return value;
}

Real largest_magnitude(const Reals& all) {
  Real largest;
  for (const Real& x : all) largest = max(largest, abs(x));
  return largest;
}

struct Minimum {
  Real potential = {};
  std::vector<double> q = {};
};

/// Runs Newton's method from one start after another.
class MinimumSearch {
 public:
  MinimumSearch(const PotentialFunction& potential, const std::vector<std::uint32_t>& searched,
                const Model& model, State state)
      : potential_(potential), searched_(searched), model_(model), state_(std::move(state)) {
    for (std::uint32_t i = 0; i < model.constraints.size(); ++i) {
      if (model.constraints[i].is_position) constraints_.push_back(i);
    }
  }

  [[nodiscard]] bool has_few_unknowns() const {
    const std::size_t unknowns = searched_.size() + constraints_.size();
    return constraints_.empty() || unknowns <= most_constrained_unknowns;
  }

  /// The place to which the method converges; none if it fails or takes too many rounds.
  std::optional<Minimum> find_from(Reals start) {
    static const Real negligible(power_of_ten(-18));
    static const Real least_factor(power_of_ten(-3));
    q_ = std::move(start);
    std::optional<PotentialValues> first = values_at(q_);
    if (!first) return std::nullopt;
    here_ = std::move(*first);
    multipliers_.assign(constraints_.size(), Real());
    last_step_.clear();
    scale_ = largest_magnitude(here_.slopes) + largest_magnitude(here_.residuals);
    if (is_zero(scale_)) return rounded_place();
    std::optional<Reals> matrix;
    Real factor(1);
    for (std::size_t i = 0; i < most_rounds; ++i) {
      if (!matrix) matrix = matrix_here();
      if (!matrix) return std::nullopt;
      const std::optional<Reals> solution = solve(*matrix, factor);
      if (!solution) return std::nullopt;
      const auto middle = solution->begin() + static_cast<std::ptrdiff_t>(searched_.size());
      const Reals step = lengthened(Reals(solution->begin(), middle));
      const Real length = largest_magnitude(step);
      if (length <= negligible && factor <= Real(1)) {
        q_ = displaced(step);
        return rounded_place();
      }
      if (advance(step, Reals(middle, solution->end()))) {
        factor = max(factor / Real(4), least_factor);
        matrix.reset();
      } else {
        factor = factor * Real(8);
        last_step_.clear();
      }
    }
    return std::nullopt;
  }

 private:
  std::optional<PotentialValues> values_at(const Reals& q) {
    std::optional<PotentialValues> values = potential_(q);
    if (!values || constraints_.empty()) return values;
    for (std::size_t i = 0; i < q.size(); ++i) state_.q[i] = q[i].value();
    const auto f = oracle_values(model_, {.kind = OutputKind::constraint_residual}, state_);
    const auto A = oracle_values(model_, {.kind = OutputKind::constraint_jacobian}, state_);
    if (!f || !A) return std::nullopt;
    for (std::size_t k = 0; k < constraints_.size(); ++k) {
      values->residuals.emplace_back((*f)[k]);
      const std::size_t row = constraints_[k] * model_.velocities.size();
      for (const std::uint32_t i : searched_)
        values->jacobian.emplace_back((*A)[row + model_.coordinates[i].velocity]);
    }
    return values;
  }

  /// g + A^T y
  [[nodiscard]] Reals forces_of(const PotentialValues& at) const {
    Reals forces = at.slopes;
    const std::size_t n = forces.size();
    for (std::size_t i = 0; i < at.jacobian.size(); ++i)
      forces[i % n] = forces[i % n] + at.jacobian[i] * multipliers_[i / n];
    return forces;
  }

  /// The matrix of the equations for (s, y) with d = 0, row-major. H comes from differences, which
  /// keep 30 digits; none if V is undefined nearby.
  std::optional<Reals> matrix_here() {
    static const Real difference(power_of_ten(-30));
    const std::size_t n = searched_.size();
    const std::size_t size = n + constraints_.size();
    const Reals forces = forces_of(here_);
    Reals matrix(size * size);
    for (std::size_t k = 0; k < n; ++k) {
      Reals step(n);
      step[k] = difference;
      const std::optional<PotentialValues> near = values_at(displaced(step));
      if (!near) return std::nullopt;
      const Reals changed = forces_of(*near);
      for (std::size_t i = 0; i < n; ++i)
        matrix[i * size + k] = (changed[i] - forces[i]) / difference;
      for (std::size_t row = n; row < size; ++row)
        matrix[row * size + k] = matrix[k * size + row] = here_.jacobian[(row - n) * n + k];
    }
    for (std::size_t k = n; k < size; ++k) matrix[k * size + k] = -least_damping();
    return matrix;
  }

  /// s, then y.
  [[nodiscard]] std::optional<Reals> solve(Reals matrix, const Real& factor) const {
    const Real damping = factor * largest_magnitude(forces_of(here_)) + scale_ * least_damping();
    Reals right_side;
    for (const Real& slope : here_.slopes) right_side.push_back(-slope);
    for (const Real& residual : here_.residuals) right_side.push_back(-residual);
    for (std::size_t i = 0; i < searched_.size(); ++i) {
      Real& entry = matrix[i * right_side.size() + i];
      entry = entry + damping;
    }
    return solve_linear(matrix, right_side);
  }

  /// Lengthens a step along coordinates in which the method converges linearly. For V = x^4 each
  /// step is 2/3 of the last step, and a step 3 times as long ends near the minimum.
  Reals lengthened(Reals step) {
    static const Real nearness(cln::cl_RA(1) / 50);
    const Reals last = std::exchange(last_step_, step);
    for (std::size_t i = 0; i < last.size(); ++i) {
      for (int order = 2; order <= most_zero_order; ++order) {
        const Real limit(cln::cl_RA(order - 1) / order);
        if (!(abs(step[i] / last[i] - limit) < nearness)) continue;
        step[i] = step[i] * Real(order);
        last_step_.clear();
        break;
      }
    }
    return step;
  }

  [[nodiscard]] Reals displaced(const Reals& step) const {
    Reals q = q_;
    for (std::size_t i = 0; i < step.size(); ++i) q[searched_[i]] = q[searched_[i]] + step[i];
    return q;
  }

  /// Takes a step unless V + w |f| would not decrease; true if it is taken. Along a short step, V
  /// may change by less than its last digit, so it is not compared. If w is at least the sum of all
  /// |y|, V cannot decrease at the cost of |f|.
  bool advance(const Reals& step, Reals multipliers) {
    static const Real short_step(power_of_ten(-8));
    Reals q = displaced(step);
    std::optional<PotentialValues> next = values_at(q);
    if (!next) return false;
    const Real count(static_cast<int>(multipliers.size()));
    const Real weight = count * largest_magnitude(multipliers) + scale_;
    const auto merit = [&](const PotentialValues& at) {
      return at.potential + weight * largest_magnitude(at.residuals);
    };
    const bool is_short = largest_magnitude(step) <= short_step;
    if (!is_short && !(merit(*next) < merit(here_))) return false;
    q_ = std::move(q);
    here_ = std::move(*next);
    multipliers_ = std::move(multipliers);
    return true;
  }

  /// The place in doubles; negligible coordinates become exactly 0.
  [[nodiscard]] Minimum rounded_place() const {
    static const Real negligible(power_of_ten(-16));
    Minimum place{here_.potential};
    for (const Real& x : q_) place.q.push_back(abs(x) <= negligible ? 0 : to_double(x.value()));
    return place;
  }

  const PotentialFunction& potential_;
  const std::vector<std::uint32_t>& searched_;
  const Model& model_;
  State state_;                                  ///< at which the oracle evaluates f and A
  std::vector<std::uint32_t> constraints_ = {};  ///< of positions
  Reals q_ = {};
  PotentialValues here_ = {};  ///< at q_
  Reals multipliers_ = {};
  Reals last_step_ = {};  ///< empty: the next step is not compared with the last step
  Real scale_ = {};       ///< |g| + |f| at the start
};

template <class Number>
bool is_in_declared_ranges(const Domain& domain, const std::vector<Number>& q) {
  for (std::uint32_t i = 0; i < q.size(); ++i) {
    const Range& range = domain.ranges.q[i];
    const bool is_inside = range.low <= q[i] && q[i] <= range.high;
    if (!is_inside && declared_range(domain.model, Opcode::coordinate, i)) return false;
  }
  return true;
}

/// True for a coordinate without a dimension that is not an angle, such as l/l0.
bool is_ratio(const Coordinate& coordinate) {
  return coordinate.unit == Unit{} && !is_angle(coordinate);
}

/// The values that a coordinate may have at rest: 0, and all parameters with its unit and either
/// sign; or 1 and 1/2 for a ratio if `is_ratio_tried`.
std::vector<cln::cl_R> typed_values(const Model& model, const State& base, std::uint32_t i,
                                    bool is_ratio_tried) {
  const std::optional<Unit>& unit = model.coordinates[i].unit;
  if (is_ratio_tried && is_ratio(model.coordinates[i])) return {1, cln::cl_RA(1) / 2};
  std::vector<cln::cl_R> values{0};
  for (std::size_t k = 0; k < model.parameters.size(); ++k) {
    const cln::cl_R& value = base.parameters[k];
    const bool is_like = unit && unit == model.parameters[k].unit;
    if (is_like && !cln::zerop(value)) values.insert(values.end(), {value, -value});
  }
  return values;
}

/// The combinations of typed values at which V is stationary: the slopes are far smaller than
/// nearby. As starts, they find minima that are not isolated, and minima far from all other starts.
std::vector<std::vector<cln::cl_R>> stationary_typed_values(
    const PotentialFunction& potential, const State& base,
    const std::vector<std::uint32_t>& searched, const Domain& domain, bool is_ratio_tried) {
  static const Real negligible(power_of_ten(-20));
  static const cln::cl_RA nearness = cln::expt(cln::cl_RA(2), -10);
  std::vector<std::vector<cln::cl_R>> values;
  for (const std::uint32_t i : searched)
    values.push_back(typed_values(domain.model, base, i, is_ratio_tried));
  const auto slope_at = [&](const std::vector<cln::cl_R>& q) {
    const std::optional<PotentialValues> at = potential(Reals(q.begin(), q.end()));
    return at ? largest_magnitude(at->slopes) : Real::undefined();
  };
  std::vector<std::vector<cln::cl_R>> places;
  for (std::size_t n = 0; n < most_combinations; ++n) {
    std::vector<cln::cl_R> q = base.q;
    std::vector<cln::cl_R> near = base.q;
    std::size_t rest = n;
    for (std::size_t k = 0; k < searched.size(); ++k) {
      cln::cl_R& x = q[searched[k]];
      x = values[k][rest % values[k].size()];
      rest /= values[k].size();
      const cln::cl_RA away = nearness / (k + 1);
      // The scale of a coordinate that is 0 is unknown; 2^-40 is near 0 also for molecules.
      near[searched[k]] = cln::zerop(x) ? cln::expt(away, 4) : x * (1 + away);
    }
    if (rest > 0) break;
    const bool is_at_rest =
        is_in_declared_ranges(domain, q) && slope_at(q) <= slope_at(near) * negligible;
    if (is_at_rest) places.push_back(std::move(q));
  }
  return places;
}

/// The starts, without repetitions.
std::vector<std::vector<cln::cl_R>> search_starts(const PotentialFunction& potential,
                                                  const State& base,
                                                  const std::vector<std::uint32_t>& searched,
                                                  const Domain& domain) {
  const Model& model = domain.model;
  std::vector<std::vector<cln::cl_R>> starts;
  const auto add = [&](const std::vector<cln::cl_R>& q) {
    std::vector<cln::cl_R> start = base.q;
    for (const std::uint32_t i : searched) start[i] = q[i];
    const bool is_known = std::find(starts.begin(), starts.end(), start) != starts.end();
    if (!is_known && starts.size() < most_starts) starts.push_back(std::move(start));
  };
  std::vector<cln::cl_R> q(base.q.size(), cln::cl_R(0));
  add(q);
  const bool has_ratio = std::ranges::any_of(
      searched, [&](std::uint32_t i) { return is_ratio(model.coordinates[i]); });
  for (const bool is_ratio_tried : {false, true}) {
    if (!model.constraints.empty() || (is_ratio_tried && !has_ratio)) break;
    const auto places = stationary_typed_values(potential, base, searched, domain, is_ratio_tried);
    for (const std::vector<cln::cl_R>& place : places) add(place);
    if (!places.empty()) break;
  }
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = model.coordinates[i].start_value;
  add(q);
  for (const Equilibrium& equilibrium : model.equilibria) {
    if (equilibrium.condition && !oracle_satisfies(model, *equilibrium.condition, base)) continue;
    if (const auto rest = oracle_rest_state(model, equilibrium, base)) add(rest->q);
  }
  for (std::size_t n = 0; n < std::min(most_drawn_starts, domain.states.size()); ++n) {
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = exact_value(domain.states[n].q[i]);
    add(q);
  }
  return starts;
}

}  // namespace

std::vector<std::vector<double>> find_minima(const PotentialFunction& potential,
                                             const std::vector<std::uint32_t>& searched,
                                             const Domain& domain) {
  const State base =
      map_leaves([](double x) -> cln::cl_R { return exact_value(x); }, domain.states.front());
  MinimumSearch search(potential, searched, domain.model, base);
  if (!search.has_few_unknowns()) return {};
  std::vector<Minimum> found;
  for (const std::vector<cln::cl_R>& start : search_starts(potential, base, searched, domain)) {
    std::optional<Minimum> place = search.find_from(Reals(start.begin(), start.end()));
    if (!place || !is_in_declared_ranges(domain, place->q)) continue;
    const bool is_known = std::ranges::find(found, place->q, &Minimum::q) != found.end();
    if (!is_known) found.push_back(std::move(*place));
  }
  // In double, because equal minima may differ in the last of their 64 digits.
  const auto is_lower = [](const Minimum& x, const Minimum& y) {
    return to_double(x.potential.value()) < to_double(y.potential.value());
  };
  std::ranges::stable_sort(found, is_lower);
  // If an unbounded coordinate has several equal minima, authors mean the first, at typed values:
  // l = 1 for 1/l^2 + l^2, not l = -1.
  const std::vector<bool> is_unbounded = unbounded_coordinates(domain.model);
  const bool has_ranges =
      std::ranges::none_of(searched, [&](std::uint32_t i) { return is_unbounded[i]; });
  const std::size_t most = has_ranges ? most_minima : 1;
  std::vector<std::vector<double>> lowest;
  for (std::size_t i = 0; i < std::min(most, found.size()); ++i)
    lowest.push_back(std::move(found[i].q));
  return lowest;
}

}  // namespace elgen
