// zeros: kinks are computed, not guessed, so that |x| and |-x| are one.
#include "diff/zeros.hpp"

#include <algorithm>

#include "base/random.hpp"
#include "elgen/fold.hpp"
#include "evaluate/bounded.hpp"
#include "lower/graph/prune.hpp"
#include "present/proved_zeros.hpp"

namespace elgen {
namespace {

constexpr std::uint64_t seed_of_zeros = 16;
/// Points that may be tried for one at which an entry has a value.
constexpr std::size_t most_tries = 4 * zero_points;

/// What is known of an entry at one point.
enum class Seen : std::uint8_t { nothing, zero, other };

class PointDrawer {
 public:
  PointDrawer(const Program& program, const std::vector<bool>& positive)
      : program_(program), positive_(positive) {}

  /// All entries of the function at the next point.
  std::vector<Seen> operator()(const Function& function) {
    const LeafValues<Bound> point = next_point();
    const auto values =
        fold<Bound>(RunningBoundRules{{point, rounding<double>()}}, program_, function);
    std::vector<Seen> seen;
    for (const std::uint32_t entry : entries_of(function)) {
      seen.push_back(judged(function.instructions[entry], values, values[entry]));
    }
    return seen;
  }

 private:
  LeafValues<Bound> next_point() {
    const auto draw = [this] { return leaf_bound(random_.rational(), rounding<double>()); };
    LeafValues<Bound> point = draw_leaves(program_.leaves, draw);
    const bool is_positive = ++points_ % 2 != 0;
    for (std::size_t i = 0; i < point.parameters.size(); ++i) {
      if (is_positive || positive_[i]) point.parameters[i].value = abs(point.parameters[i].value);
    }
    return point;
  }

  /// Nothing is seen where rounding in 64 digits hides more than the last digits of the terms, or,
  /// where these are 0, of leaves, which are about 1.
  static Seen judged(const Instruction& i, const std::vector<Bound>& values, const Bound& x) {
    static const Real share(power_of_ten(-45));
    static const Real hidden(power_of_ten(-25));
    if (!x.value.is_defined() || !x.bound.is_defined()) return Seen::nothing;
    const Real noise = abs(x.bound) * share;
    if (abs(x.value).value() > noise.value()) return Seen::other;
    Real terms(power_of_ten(-5));
    if (operand_count(i) > 0) terms = max(terms, abs(values[i.a].value));
    if (operand_count(i) > 1) terms = max(terms, abs(values[i.b].value));
    return noise.value() <= (terms * hidden).value() ? Seen::zero : Seen::nothing;
  }

  const Program& program_;
  const std::vector<bool>& positive_;
  Random random_{seed_of_zeros};
  std::size_t points_ = 0;
};

/// The entries, by their numbers, that nothing speaks against.
std::vector<std::size_t> candidates(const std::vector<Seen>& seen) {
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] != Seen::other) left.push_back(i);
  }
  return left;
}

Function only(const Function& function, const std::vector<std::size_t>& numbers) {
  const std::vector<std::uint32_t> entries = entries_of(function);
  std::vector<std::uint32_t> some;
  for (const std::size_t i : numbers) some.push_back(entries[i]);
  return with_entries(function, some);
}

/// A difference that needs more is sampled, which takes less.
constexpr PresentBudget zeros_budget{
    .products_per_function = 10'000, .products = 40'000, .terms = 1'000};

/// Whether each entry is zero at as many points as are asked for, of those at which it has a value.
std::vector<bool> zero_everywhere(const Function& function, PointDrawer& draw) {
  std::vector<std::size_t> zeros(entry_count(function));
  std::vector<bool> may_vanish(zeros.size(), true);
  for (std::size_t tried = 0; tried < most_tries; ++tried) {
    const std::vector<Seen> seen = draw(function);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      zeros[i] += seen[i] == Seen::zero ? 1 : 0;
      if (seen[i] == Seen::other) may_vanish[i] = false;
    }
    bool is_decided = true;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (may_vanish[i] && zeros[i] < zero_points) is_decided = false;
    }
    if (is_decided) break;
  }
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    if (zeros[i] < zero_points) may_vanish[i] = false;
  }
  return may_vanish;
}

}  // namespace

std::vector<Zero> zeros(const Program& program, const Function& function,
                        const std::vector<bool>& positive) {
  PointDrawer draw(program, positive);
  std::vector<Zero> result(entry_count(function), Zero::no);
  const std::vector<std::size_t> left = candidates(draw(function));
  if (left.empty()) return result;
  const std::vector<bool> is_proved = proved_zeros(program, only(function, left), zeros_budget);
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (is_proved[i]) result[left[i]] = Zero::proved;
    if (!is_proved[i]) open.push_back(left[i]);
  }
  if (open.empty()) return result;
  const std::vector<bool> vanish = zero_everywhere(only(function, open), draw);
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (vanish[i]) result[open[i]] = Zero::sampled;
  }
  return result;
}

}  // namespace elgen
