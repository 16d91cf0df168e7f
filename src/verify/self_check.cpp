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
#include "elgen/wording.hpp"
#include "projection.hpp"
#include "sampled_zeros.hpp"
#include "states.hpp"
#include "time_share.hpp"
#include "undefined_expression.hpp"

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
    undefined_.push_back(run.regime == Regime::undefined);
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
  /// By function, of those visited.
  [[nodiscard]] const std::vector<bool>& undefined() const { return undefined_; }
  [[nodiscard]] const State& state() const { return oracle_.state(); }
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
  std::vector<bool> undefined_ = {};
  std::size_t compared_ = 0;
  std::optional<double> worst_ = {};
};

/// What all states say together.
class SelfChecking {
 public:
  explicit SelfChecking(const Subject& subject)
      : subject_(subject), without_value_(subject.program.functions.size(), true) {
    result_.sampled_zeros = count_sampled_zeros(subject.program);
  }

  /// Visits all functions at one state.
  void visit(const SampledState<double>& sample) {
    Visit visit(subject_, sample, random_);
    states_.push_back(visit.state());
    for (std::size_t index = 0; index < subject_.program.functions.size(); ++index) {
      const std::string mistake = visit.mistake(index);
      without_value_[index] = without_value_[index] && visit.undefined()[index];
      if (mistake.empty()) continue;
      ++result_.states;
      result_.failure = fmt::format("`{}`: {}, at {}", subject_.program.functions[index].name,
                                    mistake, visit.where());
      return;
    }
    const std::vector<bool>& undefined = visit.undefined();
    result_.outside += std::count(undefined.begin(), undefined.end(), true) > 0 ? 1U : 0U;
    result_.states += visit.compared() > 0 ? 1 : 0;
    if (visit.worst()) result_.worst = std::max(result_.worst.value_or(0), *visit.worst());
  }

  /// An output that is undefined so far, which calls for more states.
  [[nodiscard]] bool lacks_value() const {
    return std::find(without_value_.begin(), without_value_.end(), true) != without_value_.end();
  }

  [[nodiscard]] const SelfCheck& result() const { return result_; }

  SelfCheck finish() {
    if (result_.failure.empty() && lacks_value()) refuse();
    return std::move(result_);
  }

 private:
  void refuse() {
    const auto first = std::find(without_value_.begin(), without_value_.end(), true);
    const Function& function =
        subject_.program.functions[static_cast<std::size_t>(first - without_value_.begin())];
    result_.lacks_value = true;
    result_.failure =
        fmt::format("`{}` has no value at any of {} states", function.name, states_.size());
    const auto undefined = undefined_expression(subject_.model, function, states_);
    result_.place = place_of(function);
    if (!undefined) return;
    result_.place = subject_.model.expressions[*undefined].span;
    result_.failure += ", nor has " + quoted(*result_.place);
  }

  /// Where an output was asked for; the model's name where all of them were.
  [[nodiscard]] Span place_of(const Function& function) const {
    for (const OutputRequest& request : subject_.scene.outputs) {
      if (request.name == function.name && request.span.source != nullptr) return request.span;
    }
    return subject_.model.name_span;
  }

  const Subject& subject_;
  Random random_{1};
  std::vector<bool> without_value_;  ///< by function
  std::vector<State> states_ = {};
  SelfCheck result_ = {};
};

}  // namespace

SelfCheck self_check(const Model& model, const Scene& scene, const Program& program,
                     double seconds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const Subject subject{model, scene, program};
  SelfChecking checking(subject);
  TimeShare share(seconds);
  for (const auto& sample : sample_states<double>(subject, {most_states, 1, false})) {
    const bool is_enough = !share.fits_another(checking.result().states);
    if (is_enough && !checking.lacks_value()) break;
    checking.visit(sample);
    if (!checking.result().failure.empty()) break;
    share.add_state(std::chrono::duration<double>(Clock::now() - start).count());
  }
  return checking.finish();
}

std::string receipt(const SelfCheck& result) {
  const std::string worst =
      result.worst ? fmt::format("{:.2g} uB", *result.worst) : "without a bound of rounding";
  std::string text = fmt::format("checked {} state{} against 60 digits: {}", result.states,
                                 result.states == 1 ? "" : "s", worst);
  if (result.outside > 0) text += fmt::format("; {} outside the domain", result.outside);
  if (result.sampled_zeros == 0) return text;
  const bool is_one = result.sampled_zeros == 1;
  return text + fmt::format("; {} entr{} on zeros found at {} points, not proved",
                            result.sampled_zeros, is_one ? "y rests" : "ies rest", zero_points);
}

}  // namespace elgen
