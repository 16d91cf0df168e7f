// zeros: entries with functions that are not analytic (program/network/analytic.hpp) are sampled
// twice. In the first pass, these functions are independent random variables: an entry that is 0 at
// all points counts as identically 0. In the second pass, these functions are computed: an entry
// that is not 0 at a point is not identically 0. All other entries are undecided.
#include "diff/zeros.hpp"

#include <algorithm>
#include <array>

#include "accuracy/running_errors.hpp"
#include "elgen/closed_forms.hpp"
#include "elgen/fold.hpp"
#include "numbers/exact_number.hpp"
#include "program/network/analytic.hpp"
#include "sample/points.hpp"

namespace elgen {
namespace {

constexpr std::uint64_t seed_of_zeros = 16;
/// The largest number of points to try until each entry has a value at enough points. The factor 8
/// is the number of scales (4) times the number of rules of signs (2).
constexpr std::size_t most_tries = 8 * zero_sample_count;

/// The observation of an entry at one point; `inconclusive`: no value, or rounding hides the value.
enum class Observation : std::uint8_t { inconclusive, zero, nonzero };

class PointObserver {
 public:
  explicit PointObserver(const Program& program) : program_(program) {}

  /// Observes all entries of the function at the next point. The instructions in `variables` are
  /// random, not computed.
  std::vector<Observation> operator()(const Function& function,
                                      const std::vector<bool>& variables) {
    const std::vector<RunningValue<Real>> values = values_at(next_point(), function, variables);
    // With random variables a missing value proves nothing, because a variable may have a value
    // that the computation never gives.
    const bool is_computed = std::ranges::count(variables, true) == 0;
    std::vector<Observation> seen;
    for (const std::uint32_t entry : entries_of(function)) {
      const bool is_lone =
          is_computed && !is_limited_[entry] && is_one_sided(function.instructions[entry], values);
      seen.push_back(is_lone ? Observation::nonzero : observe_entry(function, entry, values));
    }
    return seen;
  }

  /// Observes all entries at `point`. A missing value proves nothing, because one of two terms may
  /// be 0/0 at a given point.
  std::vector<Observation> observe_at(const LeafValues<RunningValue<Real>>& point,
                                      const Function& function,
                                      const std::vector<bool>& variables) {
    const std::vector<RunningValue<Real>> values = values_at(point, function, variables);
    std::vector<Observation> seen;
    for (const std::uint32_t entry : entries_of(function)) {
      seen.push_back(observe_entry(function, entry, values));
    }
    return seen;
  }

 private:
  std::vector<RunningValue<Real>> values_at(const LeafValues<RunningValue<Real>>& point,
                                            const Function& function,
                                            const std::vector<bool>& variables) {
    const RunningErrorRules<Real> rules{point};
    std::vector<RunningValue<Real>> values;
    is_limited_.clear();
    for (std::size_t i = 0; i < function.instructions.size(); ++i) {
      is_limited_.push_back(!variables[i] && is_limited(function.instructions[i], values));
      values.push_back(variables[i]
                           ? scaled_leaf(draw_.number())
                           : fold_instruction(rules, program_, function.instructions[i], values));
    }
    return values;
  }

  /// True if the value of `i`, or of an operand, was replaced by a limit, such as exp(-2^21) by 0.
  [[nodiscard]] bool is_limited(const Instruction& i,
                                const std::vector<RunningValue<Real>>& values) const {
    const std::size_t operands = operand_count(i);
    if (operands == 0) return false;
    const std::uint32_t last = operands > 1 ? i.b : i.a;
    if (is_limited_[i.a] || is_limited_[last]) return true;
    return i.opcode == Opcode::call &&
           is_replaced_by_limit(i.function, values[i.a].value, values[last].value);
  }

  [[nodiscard]] RunningValue<Real> scaled_leaf(const cln::cl_RA& number) const {
    return running_leaf(number * scale(), rounding_constants<double>());
  }

  /// The scale of the next random numbers. The scale changes after every second point, because some
  /// differences appear only at large or small values.
  [[nodiscard]] cln::cl_RA scale() const {
    static const std::array<cln::cl_RA, 4> scales{1, 1000, cln::cl_RA(1) / 1000, 1'000'000};
    return scales[points_ / 2 % scales.size()];
  }

  /// The next random point. At every second point parameters without an assumption are positive,
  /// because most masses and lengths must be positive.
  LeafValues<RunningValue<Real>> next_point() {
    const PositiveParameters positive =
        points_ % 2 == 0 ? PositiveParameters::parameters : PositiveParameters::assumed;
    LeafValues<RunningValue<Real>> point =
        map_leaves([this](const cln::cl_RA& x) { return scaled_leaf(x); },
                   draw_.point(program_.leaves, positive));
    ++points_;
    return point;
  }

  /// True if only one of the two operands of `i` has a value: at x < 0, log(x^2) has a value but
  /// 2 log(x) has none.
  static bool is_one_sided(const Instruction& i, const std::vector<RunningValue<Real>>& values) {
    return operand_count(i) > 1 && values[i.a].value.is_defined() != values[i.b].value.is_defined();
  }

  /// The observation of instruction `entry`. `inconclusive` in three cases: a limit replaced a
  /// value; the value is undefined; the value is at most 1e-45 times its running error, and this
  /// bound exceeds both 1e-30 and the largest operand times 1e-25.
  [[nodiscard]] Observation observe_entry(const Function& function, std::uint32_t entry,
                                          const std::vector<RunningValue<Real>>& values) const {
    static const Real share(power_of_ten(-45));
    static const Real hidden(power_of_ten(-25));
    const Instruction& i = function.instructions[entry];
    const RunningValue<Real>& x = values[entry];
    if (is_limited_[entry]) return Observation::inconclusive;
    if (!x.value.is_defined() || !x.error.is_defined()) return Observation::inconclusive;
    const Real noise = abs(x.error) * share;
    if (abs(x.value).value() > noise.value()) return Observation::nonzero;
    Real terms(power_of_ten(-5));
    if (operand_count(i) > 0) terms = max(terms, abs(values[i.a].value));
    if (operand_count(i) > 1) terms = max(terms, abs(values[i.b].value));
    return noise.value() <= (terms * hidden).value() ? Observation::zero
                                                     : Observation::inconclusive;
  }

  const Program& program_;
  Sampler draw_{seed_of_zeros};
  std::size_t points_ = 0;
  std::vector<bool> is_limited_ = {};  ///< by instruction, at the last point
};

/// The indices of the entries that may vanish.
std::vector<std::size_t> zero_candidates(const std::vector<Observation>& seen) {
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] != Observation::nonzero) left.push_back(i);
  }
  return left;
}

Function select_entries(const Function& function, const std::vector<std::size_t>& numbers) {
  const std::vector<std::uint32_t> entries = entries_of(function);
  std::vector<std::uint32_t> some;
  for (const std::size_t i : numbers) some.push_back(entries[i]);
  return with_entries(function, some);
}

/// A difference beyond this budget is sampled, which is cheaper.
constexpr ClosedFormBudget zeros_budget{
    .products_per_function = 10'000, .products = 40'000, .terms = 1'000};

/// The state's doubles as exact numbers.
LeafValues<RunningValue<Real>> exact_point(const Arguments<double>& state) {
  return map_leaves(
      [](double x) { return running_leaf(exact_value(x), rounding_constants<double>()); }, state);
}

/// For each entry: `nonzero` if the entry is not 0 at some point; `zero` if the entry is 0 at
/// `zero_sample_count` points or more; otherwise `inconclusive`. The points are `states`, then
/// random points.
std::vector<Observation> observe_points(const Function& function,
                                        const std::vector<bool>& variables,
                                        const std::vector<Arguments<double>>& states,
                                        PointObserver& draw) {
  std::vector<std::size_t> zeros(entry_count(function));
  std::vector<bool> may_vanish(zeros.size(), true);
  const std::size_t enough = states.size() + zero_sample_count;
  for (std::size_t tried = 0; tried < states.size() + most_tries; ++tried) {
    const std::vector<Observation> seen =
        tried < states.size() ? draw.observe_at(exact_point(states[tried]), function, variables)
                              : draw(function, variables);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      zeros[i] += seen[i] == Observation::zero ? 1 : 0;
      if (seen[i] == Observation::nonzero) may_vanish[i] = false;
    }
    bool is_decided = true;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (may_vanish[i] && zeros[i] < enough) is_decided = false;
    }
    if (is_decided) break;
  }
  std::vector<Observation> result;
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    const Observation unless_other =
        zeros[i] < zero_sample_count ? Observation::inconclusive : Observation::zero;
    result.push_back(may_vanish[i] ? unless_other : Observation::nonzero);
  }
  return result;
}

/// The verdicts on all entries, by sampling.
std::vector<ZeroVerdict> sample_verdicts(const Program& program, const Function& function,
                                         const std::vector<Arguments<double>>& states,
                                         PointObserver& draw) {
  const std::vector<bool> variables = mark_unknown_values(program, function);
  const std::vector<bool> none(variables.size(), false);
  const std::vector<Observation> seen = observe_points(function, variables, {}, draw);
  const bool needs_no_second_pass = std::ranges::count(variables, true) == 0 &&
                                    std::ranges::count(seen, Observation::inconclusive) == 0;
  const std::vector<Observation> as_computed =
      needs_no_second_pass ? seen : observe_points(function, none, states, draw);
  std::vector<ZeroVerdict> result;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const bool differs = as_computed[i] == Observation::nonzero;
    result.push_back(seen[i] == Observation::zero ? ZeroVerdict::sampled
                     : differs                    ? ZeroVerdict::nonzero
                                                  : ZeroVerdict::undecided);
  }
  return result;
}

}  // namespace

std::vector<ZeroVerdict> decide_zeros(const Program& program, const Function& function,
                                      const std::vector<Arguments<double>>& states) {
  PointObserver draw(program);
  std::vector<ZeroVerdict> result(entry_count(function), ZeroVerdict::nonzero);
  const std::vector<bool> none(function.instructions.size(), false);
  const std::vector<std::size_t> left = zero_candidates(draw(function, none));
  if (left.empty()) return result;
  const std::vector<ZeroProof> proofs =
      prove_zeros(program, select_entries(function, left), zeros_budget);
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (proofs[i] == ZeroProof::zero) result[left[i]] = ZeroVerdict::proved;
    if (proofs[i] == ZeroProof::undecided) open.push_back(left[i]);
  }
  if (open.empty()) return result;
  const std::vector<ZeroVerdict> verdicts =
      sample_verdicts(program, select_entries(function, open), states, draw);
  for (std::size_t i = 0; i < open.size(); ++i) result[open[i]] = verdicts[i];
  return result;
}

bool vanishes_at(const Program& program, const Function& function, const Arguments<double>& state) {
  const std::vector<bool> none(function.instructions.size(), false);
  return PointObserver(program).observe_at(exact_point(state), function, none).front() ==
         Observation::zero;
}

}  // namespace elgen
