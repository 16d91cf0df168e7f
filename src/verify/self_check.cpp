// self_check: what precedes every write. At each state every function is run in double, in 64
// digits with its error bound, and projected on random directions against the oracle. The clock
// decides only how many states are visited: a state is always finished.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "accuracy.hpp"
#include "agreement.hpp"
#include "elgen/certificate.hpp"
#include "projection.hpp"
#include "sampled_zeros.hpp"
#include "states.hpp"
#include "time_share.hpp"

namespace elgen {
namespace {

constexpr std::size_t most_states = 32;

/// One state on its way through all functions.
class Visit {
 public:
  Visit(const Subject& subject, const SampledState<double>& sample, Random& random)
      : subject_(subject),
        sample_(sample),
        random_(random),
        oracle_(subject, exact_state(subject, sample.values)) {}

  /// What is wrong with a function here; empty where nothing is.
  std::string mistake(std::size_t index) {
    const Function& function = subject_.program.functions[index];
    BoundedRun run = bounded_run<double>(subject_.program, function, oracle_.state());
    const bool has_values = run.regime != Regime::undefined && run.regime != Regime::overflow;
    // At ordinary states the oracle is asked all the same: what has a value there must have one
    // here.
    if (!has_values && sample_.region != Region::nominal) return {};
    compared_ += has_values ? 1 : 0;
    if (run.regime == Regime::regular) {
      const std::string wrong = imprecise_entry(index, run);
      if (!wrong.empty()) return wrong;
    }
    if (function.kind == OutputKind::dynamics) return differing_field(function, run);
    std::string wrong = compare_projection(subject_, {function, run}, oracle_, random_);
    exact_.emplace_back(&function, std::move(run));
    return wrong;
  }

  [[nodiscard]] std::size_t compared() const { return compared_; }
  [[nodiscard]] std::optional<double> worst() const { return worst_; }
  [[nodiscard]] std::string where() const { return describe(subject_, oracle_.state()); }

 private:
  /// Rounded entries against exact ones, in the bounds of their judges.
  std::string imprecise_entry(std::size_t index, const BoundedRun& own) {
    const Function& function = subject_.program.functions[index];
    const std::vector<double> rounded = evaluate(subject_.program, function, sample_.values);
    std::size_t first = 0;
    for (const Field& field : function.fields) {
      const Judge judge = judge_of(subject_.program, index, field, first);
      BoundedRun other;
      if (judge.is_closed_form)
        other = bounded_run<double>(subject_.program, *judge.function, oracle_.state());
      const std::vector<Bound>& bounds = judge.is_closed_form ? other.entries : own.entries;
      for (std::size_t i = 0; other.regime == Regime::regular && i < field.entries.size(); ++i) {
        const Bound& bound = judging_bound(own.entries[first + i], bounds[judge.first + i]);
        const double x = rounded[first + i];
        const double error = error_in_bounds(x, bound, function.instructions.size());
        worst_ = std::max(worst_.value_or(0), error);
        if (!(error <= promised_bounds)) return imprecise(x, bound, error);
      }
      first += field.entries.size();
    }
    return {};
  }

  static std::string imprecise(double x, const Bound& entry, double error) {
    return fmt::format("{:.17g} instead of {} is {:.2g} times its error bound", x,
                       short_text(entry.value.value()), error);
  }

  /// `dynamics` repeats other functions, which come before it and are checked by themselves.
  std::string differing_field(const Function& dynamics, const BoundedRun& run) const {
    std::size_t first = 0;
    for (const Field& field : dynamics.fields) {
      const auto same = std::find_if(exact_.begin(), exact_.end(), [&field](const auto& known) {
        return known.first->name == field.name;
      });
      if (same != exact_.end() && !equal_entries(same->second, run, first)) {
        return fmt::format("field {} differs from the function of that name", field.name);
      }
      first += field.entries.size();
    }
    return {};
  }

  static bool equal_entries(const BoundedRun& alone, const BoundedRun& within, std::size_t first) {
    for (std::size_t i = 0; i < alone.entries.size(); ++i) {
      const Bound& entry = alone.entries[i];
      const Real& repeated = within.entries[first + i].value;
      const bool is_defined = entry.value.is_defined();
      if (is_defined != repeated.is_defined()) return false;
      const Measured number{entry.value, entry.bound, {}};
      if (is_defined && !agrees(number, repeated, within.largest)) return false;
    }
    return true;
  }

  const Subject& subject_;
  const SampledState<double>& sample_;
  Random& random_;
  OracleCache oracle_;
  std::vector<std::pair<const Function*, BoundedRun>> exact_ = {};
  std::size_t compared_ = 0;
  std::optional<double> worst_ = {};
};

/// Visits all functions at one state; adds to `result`.
void check_state(SelfCheck& result, const Subject& subject, const SampledState<double>& sample,
                 Random& random) {
  Visit visit(subject, sample, random);
  for (std::size_t index = 0; index < subject.program.functions.size(); ++index) {
    const std::string mistake = visit.mistake(index);
    if (mistake.empty()) continue;
    ++result.states;
    result.failure = fmt::format("`{}`: {}, at {}", subject.program.functions[index].name, mistake,
                                 visit.where());
    return;
  }
  result.states += visit.compared() > 0 ? 1 : 0;
  if (visit.worst()) result.worst = std::max(result.worst.value_or(0), *visit.worst());
}

}  // namespace

SelfCheck self_check(const Model& model, const Scene& scene, const Program& program,
                     double seconds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const Subject subject{model, scene, program};
  Random random(1);
  SelfCheck result;
  TimeShare share(seconds);
  result.sampled_zeros = count_sampled_zeros(program);
  for (const auto& sample : sample_states<double>(subject, {most_states, 1, false})) {
    if (!share.fits_another(result.states)) break;
    check_state(result, subject, sample, random);
    if (!result.failure.empty()) break;
    share.add_state(std::chrono::duration<double>(Clock::now() - start).count());
  }
  if (result.states == 0 && result.failure.empty() && !program.functions.empty()) {
    result.failure = fmt::format("no output has a value at any of {} states", most_states);
  }
  return result;
}

std::string receipt(const SelfCheck& result) {
  const std::string worst =
      result.worst ? fmt::format("{:.2g} uB", *result.worst) : "without a bound of rounding";
  std::string text = fmt::format("checked {} state{} against 60 digits: {}", result.states,
                                 result.states == 1 ? "" : "s", worst);
  if (result.sampled_zeros == 0) return text;
  const bool is_one = result.sampled_zeros == 1;
  return text + fmt::format("; {} entr{} on zeros found at {} points, not proved",
                            result.sampled_zeros, is_one ? "y rests" : "ies rest", zero_points);
}

}  // namespace elgen
