// find_sum_zeros: see points.hpp.
//
//     before    sqrt((x - l*cos(th))^2 + (l*sin(th))^2)      l = 0.4
//     after     r = x - l*cos(th), l*sin(th);   x = 0.4, th = 0
#include <cln/float.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "choose/points.hpp"
#include "elgen/evaluate.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

constexpr std::size_t most_sums = 8;  ///< per function
constexpr std::size_t most_zeros = 16;
constexpr std::size_t max_rounds = 30;
constexpr std::size_t most_states = 2;
constexpr std::size_t most_axes = 4;
constexpr int max_expansion_order = 4;  ///< of a zero: 4 for (x - a)^4
constexpr std::size_t max_instructions = 400;

/// A difference over a step of 1e-25 keeps 40 of the 64 digits. Zeros are accurate to 1e-16, far
/// less than their distances from the points of comparison.
const Real& difference_step() {
  static const Real value(power_of_ten(-25));
  return value;
}
const Real& negligible_length() {
  static const Real value(power_of_ten(-16));
  return value;
}

/// Groups of expressions that must vanish together: all bases of a sum of squares; any other sum,
/// as a group of one; each logarithm, as a group of one (log(x) = 0 at x = 1).
class ResidualGroups {
 public:
  explicit ResidualGroups(const Function& function) : function_(function) {
    std::vector<bool> is_part(function.instructions.size());
    for (const Instruction& i : function.instructions) {
      if (!is_sum(i)) continue;
      is_part[i.a] = is_part[i.b] = true;
    }
    for (std::uint32_t at = 0; at < is_part.size(); ++at) {
      const Instruction& i = function.instructions[at];
      const bool is_logarithm = i.opcode == Opcode::call && i.function == FunctionId::log;
      if (!is_logarithm && (!is_sum(i) || is_part[at])) continue;
      std::vector<std::uint32_t> bases;
      if (!add_bases(at, bases)) bases = {at};
      const bool is_known = std::ranges::find(groups, bases) != groups.end();
      if (!is_known && groups.size() < most_sums) groups.push_back(std::move(bases));
    }
  }

  std::vector<std::vector<std::uint32_t>> groups = {};  ///< one per sum or logarithm

 private:
  /// Adds the bases of the squares; false if a term contains no square.
  bool add_bases(std::uint32_t at, std::vector<std::uint32_t>& bases) const {
    const Instruction& i = function_.instructions[at];
    if (i.opcode == Opcode::add) return add_bases(i.a, bases) && add_bases(i.b, bases);
    if (i.opcode == Opcode::multiply && i.a == i.b) {
      bases.push_back(i.a);
      return true;
    }
    if (i.opcode == Opcode::multiply) return add_bases(i.a, bases) || add_bases(i.b, bases);
    return i.opcode == Opcode::divide && add_bases(i.a, bases);
  }

  const Function& function_;
};

/// Finds a state at which all entries of a function vanish.
class ZeroProjection {
 public:
  ZeroProjection(const Program& program, Function residuals, const Arguments<double>& start)
      : program_(program),
        residuals_(std::move(residuals)),
        coordinates_(coordinates_of(residuals_)),
        state_(map_leaves([](double x) { return Real(exact_value(x)); }, start)) {
    const auto format = cln::float_format(64);
    for (Real& x : state_.q) x = Real(cln::cl_float(x.value(), format));
  }

  /// The coordinates of the state, in doubles; none if the iteration does not converge.
  std::optional<std::vector<double>> find_zero() {
    const std::size_t count = entry_count(residuals_);
    for (std::size_t round = 0; round < max_rounds && !coordinates_.empty(); ++round) {
      Real length(0);
      for (std::size_t entry = 0; entry < count; ++entry) {
        const Real step = project_onto_entry(entry);
        if (!step.is_defined()) return std::nullopt;
        length = max(length, step);
      }
      if (length.value() <= negligible_length().value()) return round_zero();
      if (count == 1) find_multiplicity(length);
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] Real residual(std::size_t entry) const {
    return evaluate(program_, residuals_, state_)[entry];
  }

  /// Projects the state onto the zero of one linearised entry. Returns the length of the step;
  /// undefined if the slope is 0.
  Real project_onto_entry(std::size_t entry) {
    const Real r = residual(entry);
    if (r.is_defined() && cln::zerop(r.value())) return r;
    std::vector<Real> slopes;
    Real square(0);
    for (const std::uint32_t k : coordinates_) {
      const Real old = state_.q[k];
      state_.q[k] = old + difference_step();
      slopes.push_back((residual(entry) - r) / difference_step());
      state_.q[k] = old;
      square = square + slopes.back() * slopes.back();
    }
    const Real scale = r * multiplicity_ / square;
    for (std::size_t i = 0; i < coordinates_.size(); ++i) {
      Real& x = state_.q[coordinates_[i]];
      x = x - scale * slopes[i];
    }
    return abs(scale) * sqrt(square);
  }

  /// Finds the order m of a zero: each step is 1 - 1/m times the previous step. Steps m times as
  /// long converge as at a simple zero (Schröder 1870).
  void find_multiplicity(const Real& length) {
    const Real ratio = length / last_step_length_;
    last_step_length_ = length;
    for (int order = 2; order <= max_expansion_order && ratio.is_defined(); ++order) {
      const Real shrinking(cln::cl_RA(order - 1) / order);
      const bool is_near = abs(ratio - shrinking).value() < cln::cl_RA(1) / 50;
      if (is_near) multiplicity_ = Real(cln::cl_I(order));
    }
  }

  /// The zero in doubles; negligible coordinates become exactly 0.
  [[nodiscard]] std::vector<double> round_zero() const {
    std::vector<double> q;
    for (const Real& x : state_.q) {
      const bool is_zero = abs(x).value() <= negligible_length().value();
      q.push_back(is_zero ? 0 : to_double(x.value()));
    }
    return q;
  }

  const Program& program_;
  Function residuals_;
  std::vector<std::uint32_t> coordinates_;
  Arguments<Real> state_;
  Real multiplicity_ = Real(1);
  Real last_step_length_ = Real(0);
};

/// Starts: states inside the ranges, and two copies of the first state for each of the first
/// `most_axes` coordinates. In one copy, the coordinate has the opposite sign, because zeros of
/// a + b cos(x) depend on the sign of a. In the other copy, all other coordinates are 0: this finds
/// zeros on circles.
std::vector<Arguments<double>> make_starts(const Domain& domain) {
  std::vector<Arguments<double>> all(
      domain.states.begin(), domain.states.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                         most_states, domain.states.size())));
  const Arguments<double>& first = domain.states.front();
  for (std::size_t i = 0; i < first.q.size() && first.q.size() > 1 && i < most_axes; ++i) {
    Arguments<double> turned = first;
    turned.q[i] = -first.q[i];
    all.push_back(std::move(turned));
    Arguments<double> axis = first;
    std::ranges::fill(axis.q, 0.0);
    axis.q[i] = first.q[i];
    all.push_back(std::move(axis));
  }
  return all;
}

/// Starts for a sum of one coordinate: minima of |sum| and changes of its sign, found by a scan of
/// the range in equal steps. From other starts, Newton's method may diverge to a region in which a
/// potential decays to 0.
std::vector<Arguments<double>> scan_starts(const Program& program, const Function& vanishing,
                                           const Domain& domain, std::uint32_t coordinate) {
  constexpr int steps = 16;
  const Range& range = domain.ranges.q[coordinate];
  std::vector<Arguments<double>> all;
  std::vector<Real> sizes;
  std::vector<bool> is_below;
  for (int i = 0; i <= steps; ++i) {
    Arguments<double>& at = all.emplace_back(domain.states.front());
    at.q[coordinate] = range.low + (range.high - range.low) * i / steps;
    Real size(0);
    const auto exact = map_leaves([](double x) { return Real(exact_value(x)); }, at);
    const std::vector<Real> residuals = evaluate(program, vanishing, exact);
    for (const Real& r : residuals) size = size + abs(r);
    sizes.push_back(size);
    is_below.push_back(size.is_defined() && cln::minusp(residuals.front().value()));
  }
  const auto exceeds = [&](std::size_t i, std::size_t other) {
    if (!sizes[i].is_defined()) return true;
    return sizes[other].is_defined() && sizes[i].value() > sizes[other].value();
  };
  std::vector<Arguments<double>> starts;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_least =
        !exceeds(i, i == 0 ? i : i - 1) && !exceeds(i, i + 1 == all.size() ? i : i + 1);
    const bool is_turn = i > 0 && is_below[i] != is_below[i - 1];
    if (is_turn) starts.push_back(all[exceeds(i, i - 1) ? i - 1 : i]);
    if (is_least) starts.push_back(all[i]);
  }
  return starts;
}

}  // namespace

std::vector<std::uint32_t> coordinates_of(const Function& function) {
  std::vector<std::uint32_t> coordinates;
  for (const Instruction& i : function.instructions) {
    if (i.opcode == Opcode::coordinate) coordinates.push_back(i.a);
  }
  return coordinates;
}

SumZeros find_sum_zeros(const Program& program, const Domain& domain) {
  SumZeros zeros;
  const std::vector<Arguments<double>> all = make_starts(domain);
  for (const Function& text : program.functions) {
    if (depends_on_motion(text) || text.instructions.size() > max_instructions) continue;
    for (const std::vector<std::uint32_t>& residuals : ResidualGroups(text).groups) {
      const Function vanishing = with_entries(text, residuals);
      const std::vector<std::uint32_t> moving = coordinates_of(vanishing);
      const auto starts =
          moving.size() == 1 ? scan_starts(program, vanishing, domain, moving.front()) : all;
      for (const Arguments<double>& start : starts) {
        auto zero = ZeroProjection(program, vanishing, start).find_zero();
        if (!zero || zeros.size() == most_zeros) continue;
        if (std::ranges::find(zeros, *zero) == zeros.end()) zeros.push_back(std::move(*zero));
      }
    }
  }
  return zeros;
}

}  // namespace elgen
