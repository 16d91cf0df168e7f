// self_check: compares a program with the oracle before every write, at a number of states that
// depends on the cost of a comparison.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "elgen/certificate.hpp"
#include "elgen/outputs.hpp"
#include "elgen/references.hpp"
#include "elgen/scalars.hpp"
#include "elgen/wording.hpp"
#include "model/requests.hpp"
#include "verify/bounds/oracle_cache.hpp"
#include "verify/bounds/projection.hpp"
#include "verify/bounds/visit.hpp"

namespace elgen {
namespace {

constexpr std::size_t min_checked_states = 4;
constexpr std::size_t max_checked_states = 32;
/// Limit of states times state_check_cost(). Most textbook models get 32 states, two links 9, an
/// arm of seven joints 4. With twice this limit, generating all models would take 5 % longer.
constexpr std::size_t checked_work = 16'000;
/// At many of the drawn states, some models have no value.
constexpr std::size_t draws_per_state = 8;

/// While the program executes one instruction, the oracle evaluates this many nodes of the
/// energies. The number matters if one coordinate moves ten thousand points: then the oracle takes
/// longer than the program.
constexpr std::size_t nodes_per_instruction = 8;

std::size_t checked_state_count(const SystemUnderTest& subject) {
  const std::size_t nodes =
      reachable_expressions(subject.model, equation_roots(subject.model)).size();
  const std::size_t work = std::max(state_check_cost(subject), nodes / nodes_per_instruction);
  return std::clamp(checked_work / work, min_checked_states, max_checked_states);
}

/// The number of entries that rely on zeros found by sampling. `dynamics` is not counted, because
/// it repeats other outputs.
std::size_t count_sampled_zeros(const Program& program) {
  std::size_t count = 0;
  for (const Function& function : program.functions) {
    if (!output_row(function.kind).is_summary) count += function.sampled_zeros.size();
  }
  return count;
}

bool may_be_undefined(const Expression& node) {
  return node.kind == ExpressionKind::divide || node.kind == ExpressionKind::power ||
         node.kind == ExpressionKind::function;
}

/// The first expression of the output that is undefined at all states; operands come before the
/// expressions that use them. None if only a derivative or the solution of the equations is
/// undefined.
std::optional<ExpressionId> undefined_expression(const Model& model, const Function& function,
                                                 const std::vector<State>& states) {
  const auto roots = output_row(function.kind).is_user_output ? output_roots(model, function.user)
                                                              : equation_roots(model);
  for (const ExpressionId id : reachable_expressions(model, roots)) {
    const auto is_undefined = [&](const State& state) {
      return !oracle_expression_value(model, id, state);
    };
    if (!may_be_undefined(model.expressions[id])) continue;
    if (std::all_of(states.begin(), states.end(), is_undefined)) return id;
  }
  return std::nullopt;
}

/// Runs the self-check, state by state.
class SelfChecker {
 public:
  explicit SelfChecker(const SystemUnderTest& subject)
      : subject_(subject),
        is_undefined_so_far_(subject.program.functions.size(), true),
        has_compared_pivots_(subject.program.functions.size(), false) {
    result_.sampled_zeros = count_sampled_zeros(subject.program);
  }

  /// Compares all functions at one state.
  void check_state(const SampledState<double>& sample) {
    StateCheck<double> visit(
        subject_, sample,
        {ComparisonMode::projections, LossStates::inside_ranges, loss_.value_or(0)});
    states_.push_back(visit.state());
    bool is_compared = false;
    bool is_outside = false;
    is_infinite_ = false;
    for (std::size_t index = 0; index < subject_.program.functions.size(); ++index) {
      const Regime regime = check_function(visit, index);
      is_compared = is_compared || regime == Regime::regular || regime == Regime::ill_conditioned;
      is_outside = is_outside || regime == Regime::undefined;
      is_undefined_so_far_[index] = is_undefined_so_far_[index] && regime == Regime::undefined;
      if (!result_.failure.empty()) break;
    }
    result_.undefined_states += is_outside ? 1 : 0;
    if (sample.region == Region::nominal) {
      ++result_.states_in_ranges;
      result_.overflowing_states += is_infinite_ ? 1 : 0;
    }
    result_.states += is_compared || !result_.failure.empty() ? 1 : 0;
  }

  /// True if some output has been undefined at all states so far; then more states are drawn.
  [[nodiscard]] bool lacks_value() const {
    return std::ranges::find(is_undefined_so_far_, true) != is_undefined_so_far_.end();
  }

  [[nodiscard]] const SelfCheck& result() const { return result_; }

  SelfCheck finish() {
    if (result_.failure.empty() && lacks_value()) report_undefined_output();
    return std::move(result_);
  }

 private:
  /// Compares the fields of a function up to the first mistake, and returns the worst regime.
  Regime check_function(StateCheck<double>& visit, std::size_t index) {
    Regime regime = Regime::regular;
    for (const ComparedField& place : compared_fields(subject_, index)) {
      const bool is_once = is_projected_once(place, subject_.model);
      if (is_once && has_compared_pivots_[index]) continue;
      const Finding finding = visit.check_field(place, sampler_);
      if (is_once && finding.is_compared) has_compared_pivots_[index] = true;
      regime = worse_regime(regime, finding.regime);
      if (finding.regime == Regime::overflow && !finding.is_finite) is_infinite_ = true;
      if (finding.loss) {
        loss_ = std::max(loss_.value_or(0), finding.loss->relative_to_entry.loss);
        result_.digits_lost = digits_lost(*loss_, ScalarKind::double_precision);
      }
      if (finding.mistake.empty()) continue;
      result_.failure = fmt::format("`{}`: {}, at {}", place.function->name, finding.mistake,
                                    describe_state(subject_, visit.state()));
      break;
    }
    return regime;
  }

  void report_undefined_output() {
    const auto first = std::ranges::find(is_undefined_so_far_, true);
    const Function& function =
        subject_.program.functions[static_cast<std::size_t>(first - is_undefined_so_far_.begin())];
    result_.has_undefined_output = true;
    result_.failure =
        fmt::format("`{}` has no value at any of {} states", function.name, states_.size());
    const auto undefined = undefined_expression(subject_.model, function, states_);
    result_.place = request_span(function);
    result_.remedy = "declare a `range` inside the domain";
    if (!undefined) {
      const bool is_of_mass = divides_by_mass(output_row(function.kind)) && is_mass_singular();
      if (is_of_mass) result_.remedy = singular_text();
      return;
    }
    result_.place = subject_.model.expressions[*undefined].span;
    result_.failure += ", nor has " + in_backticks(*result_.place);
  }

  /// True if M is singular at all states.
  [[nodiscard]] bool is_mass_singular() const {
    return std::ranges::none_of(states_, [this](const State& state) {
      const OracleValues m =
          oracle_values(subject_.model, {.kind = OutputKind::mass_matrix}, state);
      return m && oracle_relative_pivots(*m, state.v.size());
    });
  }

  [[nodiscard]] std::string singular_text() const {
    std::string zeros;
    const std::vector<cln::cl_R> values = nominal_state(subject_.model, subject_.scene).parameters;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!cln::zerop(values[i])) continue;
      zeros += (zeros.empty() ? "" : ", ") + quote_text(subject_.model.parameters[i].name);
    }
    return "M is singular" + (zeros.empty() ? "" : " where 0 is the value of " + zeros);
  }

  /// The place in the scene that requests the output; the model's name if the scene requests all
  /// outputs.
  [[nodiscard]] Span request_span(const Function& function) const {
    const OutputRequest* request = find_request(subject_.scene, function.name);
    const bool was_named = request != nullptr && request->span.source != nullptr;
    return was_named ? request->span : subject_.model.name_span;
  }

  const SystemUnderTest& subject_;
  Sampler sampler_{1};
  std::vector<bool> is_undefined_so_far_;  ///< by function: undefined at all states so far
  std::vector<bool> has_compared_pivots_;  ///< by function
  bool is_infinite_ = false;  ///< some value is not finite in double at the current state
  std::vector<State> states_ = {};
  std::optional<double> loss_ = {};  ///< the largest loss so far
  SelfCheck result_ = {};
};

}  // namespace

SelfCheck self_check(const Model& model, const Scene& scene, const Program& program,
                     const Program& unrequested) {
  const SystemUnderTest subject{model, scene, program, &unrequested};
  SelfChecker checking(subject);
  const std::size_t wanted = checked_state_count(subject);
  StateSequence<double> states(subject, {draws_per_state * wanted, 1, false});
  while (const auto sample = states.next()) {
    if (checking.result().states >= wanted && !checking.lacks_value()) break;
    checking.check_state(*sample);
    if (!checking.result().failure.empty()) break;
  }
  return checking.finish();
}

std::string self_check_text(const SelfCheck& result) {
  std::string text =
      fmt::format("compared with 60-digit arithmetic at {}", count_text(result.states, "state"));
  if (result.digits_lost) text += "; " + lost_digits_text(*result.digits_lost);
  if (result.undefined_states > 0)
    text += fmt::format("; {} outside the domain", result.undefined_states);
  if (result.overflowing_states * 10 > result.states_in_ranges) {
    text += fmt::format("; not finite in double at {} of {} inside the ranges",
                        result.overflowing_states, count_text(result.states_in_ranges, "state"));
  }
  if (result.sampled_zeros == 0) return text;
  const bool is_one = result.sampled_zeros == 1;
  return text + fmt::format(
                    "; {} entr{} on zeros sampled at {} points, not proved: `elgen verify "
                    "-v` names {} and compares {} at more states",
                    result.sampled_zeros, is_one ? "y relies" : "ies rely", zero_sample_count,
                    is_one ? "it" : "them", is_one ? "it" : "them");
}

std::vector<OutputRequest> outputs_for_self_check(const Model& model, const Program& program) {
  const auto compares_pivots = [](const Function& function) {
    return output_row(function.kind).gives_pivots && has_pivots(function);
  };
  const bool needs_mass =
      !is_solved_by_oracle(model) && std::ranges::any_of(program.functions, compares_pivots);
  const bool has_mass = find_function(program, OutputKind::mass_matrix) != nullptr ||
                        find_function(program, OutputKind::inverse_dynamics) != nullptr;
  if (!needs_mass || has_mass) return {};
  return available_requests(model, {OutputKind::inverse_dynamics});
}

}  // namespace elgen
