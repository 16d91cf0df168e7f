// Random search for states with a large estimated loss. Estimates are in double, so machines with
// different math libraries may find slightly different states.
#include "verify/states/lossy_states.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "accuracy/conditioning.hpp"
#include "accuracy/running_errors.hpp"
#include "elgen/outputs.hpp"

namespace elgen {
namespace {

/// As many as near zeros.
constexpr std::size_t most_lossy_states = 64;
/// Searches in each function, and the number of their results that are kept.
constexpr std::size_t searches = 8;
constexpr std::size_t kept_results = 4;
/// A search starts at the worst of this many random states.
constexpr std::size_t drawn_starts = 16;
/// Steps of a search. In two coordinates, about 200 successful steps reach the last digit.
constexpr std::size_t steps = 400;
/// 0.9 decimal digits, as much as a few roundings explain.
constexpr double explained_loss = 8;
/// Limit of instructions computed for one state of `sampling.count`, about 4 ms. All functions have
/// equal parts.
constexpr std::size_t work_per_state = 1 << 14;

/// K of `entry` in double (accuracy/conditioning.hpp), without an error bound.
double rough_condition(const Program& program, const Function& function,
                       const std::vector<double>& values, std::uint32_t entry) {
  std::vector<double> adjoints(entry + 1);
  adjoints[entry] = 1;
  double sum = 0;
  for (std::size_t at = entry + 1; at-- > 0;) {
    const Instruction& i = function.instructions[at];
    if (adjoints[at] == 0) continue;
    if (is_leaf(i.opcode)) sum += std::abs(adjoints[at] * values[at]);
    const std::size_t operands = operand_count(i);
    if (operands > 0) adjoints[i.a] += adjoints[at] * slope_by_operand(program, i, i.a, values);
    if (operands > 1 && i.b != i.a)
      adjoints[i.b] += adjoints[at] * slope_by_operand(program, i, i.b, values);
  }
  return sum;
}

/// The estimated loss of an entry.
struct EntryLoss {
  double loss = 0;
  std::uint32_t entry = 0;
};

class LossSearch {
 public:
  LossSearch(const SystemUnderTest& subject, const Function& function, Sampler& draw)
      : subject_(subject), function_(function), ranges_(ranges_of(subject)), draw_(draw) {}

  /// A state with the estimated loss of one entry; the loss is 0 if no entry has a defined value at
  /// the drawn states.
  struct Result {
    double loss = 0;
    Arguments<double> at = {};
  };

  Result search(bool is_at_rest) {
    Arguments<double> best;
    EntryLoss worst;
    for (std::size_t i = 0; i < drawn_starts; ++i) {
      Arguments<double> at = draw_in_ranges(subject_, ranges_, draw_);
      if (is_at_rest) {
        for (auto* rates : {&at.v, &at.a, &at.u, &at.momenta}) std::ranges::fill(*rates, 0.0);
      }
      const EntryLoss found = worst_entry(at);
      if (found.loss <= worst.loss) continue;
      worst = found;
      best = std::move(at);
    }
    if (worst.loss > 0) climb(best, worst, is_at_rest);
    return {worst.loss, std::move(best)};
  }

 private:
  [[nodiscard]] std::vector<RunningValue<double>> run(const Arguments<double>& at) const {
    const RunningErrorRules<double> rules{running_leaves<double>(at, LeafRounding::exact)};
    return fold<RunningValue<double>>(rules, subject_.program, function_);
  }

  /// The estimated loss of an entry; 0 if it is undefined or at most `least`.
  [[nodiscard]] double loss_of(const std::vector<RunningValue<double>>& values,
                               const std::vector<double>& numbers, std::uint32_t entry,
                               double least) const {
    const RunningValue<double>& x = values[entry];
    if (x.is_lost || x.underflows || !std::isfinite(x.error)) return 0;
    if (x.error <= least * std::abs(x.value)) return 0;  // K only lowers the loss
    const double reference =
        std::abs(x.value) + rough_condition(subject_.program, function_, numbers, entry);
    const double loss = x.error / reference;
    return std::isfinite(loss) ? loss : 0;
  }

  [[nodiscard]] EntryLoss worst_entry(const Arguments<double>& at) const {
    const std::vector<RunningValue<double>> values = run(at);
    const std::vector<double> numbers = values_of(values);
    EntryLoss worst;
    for (const std::uint32_t entry : entries_of(function_)) {
      const double loss = loss_of(values, numbers, entry, worst.loss);
      if (loss > worst.loss) worst = {loss, entry};
    }
    return worst;
  }

  void climb(Arguments<double>& best, EntryLoss& worst, bool is_at_rest) {
    double reach = 0.25;  // of the range
    for (std::size_t i = 0; i < steps; ++i) {
      Arguments<double> at = best;
      take_step(at, reach, is_at_rest);
      const std::vector<RunningValue<double>> values = run(at);
      const double loss = loss_of(values, values_of(values), worst.entry, worst.loss);
      const bool is_success = loss > worst.loss;
      // The 1/5 rule: one success makes up for four failures.
      reach = std::clamp(reach * (is_success ? 1.5 : 0.9), 1e-16, 1.0);
      if (!is_success) continue;
      worst.loss = loss;
      best = std::move(at);
    }
  }

  /// Moves one leaf, or all leaves, by up to `reach` of their ranges. A value
  /// within one step of 0 may become 0.
  void take_step(Arguments<double>& at, double reach, bool is_at_rest) {
    const bool moves_all = draw_.random_sign() > 0;
    std::vector<std::pair<double*, Range>> leaves;
    const auto add = [&](std::vector<double>& values, const std::vector<Range>& ranges) {
      for (std::size_t i = 0; i < values.size(); ++i) leaves.emplace_back(&values[i], ranges[i]);
    };
    for (std::size_t i = 0; i < at.q.size(); ++i) {
      if (!subject_.model.coordinates[i].rotation) leaves.emplace_back(&at.q[i], ranges_.q[i]);
    }
    if (!is_at_rest) {
      add(at.v, ranges_.v);
      add(at.a, ranges_.a);
      add(at.u, ranges_.u);
      add(at.momenta, ranges_.momenta);
    }
    if (leaves.empty()) return;
    const auto chosen =
        static_cast<std::size_t>(draw_.uniform({0, static_cast<double>(leaves.size())}));
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      if (!moves_all && i != std::min(chosen, leaves.size() - 1)) continue;
      auto& [value, range] = leaves[i];
      const double width = range.high - range.low;
      double next = *value + reach * width * draw_.uniform({-1, 1});
      const bool may_be_zero = range.low <= 0 && 0 <= range.high && std::abs(next) < reach * width;
      if (may_be_zero && draw_.random_sign() > 0) next = 0;
      *value = std::clamp(next, range.low, range.high);
    }
  }

  const SystemUnderTest& subject_;
  const Function& function_;
  LeafValues<Range> ranges_;
  Sampler& draw_;
};

}  // namespace

template <class Scalar>
std::vector<SampledState<Scalar>> lossy_states(const SystemUnderTest& subject,
                                               const SamplingOptions& sampling) {
  std::vector<SampledState<Scalar>> states;
  const std::vector<Function>& functions = subject.program.functions;
  if (functions.empty() || !subject.model.constraints.empty()) return states;
  Sampler draw(sampling.seed);
  const std::size_t most = std::min(sampling.count, most_lossy_states);
  for (const Function& function : functions) {
    if (output_row(function.kind).is_summary) continue;
    std::size_t work_left = sampling.count * work_per_state / functions.size();
    const std::size_t work = function.instructions.size() * (drawn_starts + steps);
    LossSearch search(subject, function, draw);
    std::vector<LossSearch::Result> results;
    for (std::size_t i = 0; i < searches && work <= work_left; ++i) {
      work_left -= work;
      results.push_back(search.search(i % 2 != 0));
    }
    std::ranges::stable_sort(results, std::ranges::greater(), &LossSearch::Result::loss);
    for (std::size_t i = 0; i < std::min(results.size(), kept_results); ++i) {
      if (states.size() == most || results[i].loss <= explained_loss) break;
      states.push_back({Region::near_zero, {}, round_to_finite<Scalar>(results[i].at)});
    }
  }
  return states;
}

template std::vector<SampledState<double>> lossy_states(const SystemUnderTest&,
                                                        const SamplingOptions&);
template std::vector<SampledState<float>> lossy_states(const SystemUnderTest&,
                                                       const SamplingOptions&);

}  // namespace elgen
