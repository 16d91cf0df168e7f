// Visits one state: runs each function once, compares its fields and measures their errors.
#include "verify/bounds/visit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "elgen/outputs.hpp"
#include "numbers/more_digits.hpp"
#include "verify/bounds/projection.hpp"

namespace elgen {
namespace {

/// Decimal digits of the runs. If values differ, runs are repeated, each with twice the digits.
constexpr unsigned first_run_digits = 64;
constexpr unsigned last_run_digits = 1024;

/// The largest number of digits of a repeated run. Only 200 digits of an irrational constant are
/// correct, so with such constants a run beyond 256 digits decides nothing more.
unsigned max_run_digits(const Program& program) {
  constexpr unsigned enough_for_constants = 256;
  const auto is_exact = [](const Constant& constant) { return is_rational(constant); };
  const bool are_exact = std::ranges::all_of(program.constants, is_exact);
  return are_exact ? last_run_digits : enough_for_constants;
}

/// The number of digits from which two agreeing runs prove a difference. With fewer digits, 1 -
/// cos(x) may be 0 in both runs, so that quotients by x^2 agree but are wrong. Second derivatives
/// of such quotients contain powers of x up to the eighth. Parameters are ignored, because they are
/// near their nominal values.
double sufficient_digits(const State& state) {
  double farthest = 0;
  const auto look = [&farthest](Opcode kind, std::uint32_t, const cln::cl_R& x) {
    if (kind == Opcode::parameter) return;
    farthest = std::max(farthest, std::abs(decimal_exponent(x)));
  };
  for_each_leaf(look, state);
  return 8 * farthest;
}

bool has_values(Regime regime) {
  return regime == Regime::regular || regime == Regime::ill_conditioned;
}

template <class Scalar>
double error_in_ulps(Scalar x, const Real& truth) {
  const Scalar magnitude = std::abs(ScalarTraits<Scalar>::from_real(truth.value()));
  const Scalar next = std::nextafter(magnitude, std::numeric_limits<Scalar>::infinity());
  const Real difference = abs(Real(exact_value(static_cast<double>(x))) - truth);
  return to_double(difference.value()) / static_cast<double>(next - magnitude);
}

Mismatch entry_mismatch(std::size_t entry, const Real& value, const Real& truth) {
  return {fmt::format("entry {} is {}, the oracle says {}", entry + 1, short_text(value),
                      short_text(truth)),
          value, truth};
}

/// The function that the field `place` of `dynamics` repeats, if this function has a single field;
/// otherwise null.
const Function* repeated_function(const Program& program, const ComparedField& place) {
  if (!output_row(place.function->kind).is_summary) return nullptr;
  const auto found = std::ranges::find(program.functions, place.field().name, &Function::name);
  return found == program.functions.end() || found->fields.size() != 1 ? nullptr : &*found;
}

}  // namespace

template <class Scalar>
StateCheck<Scalar>::StateCheck(const SystemUnderTest& subject, const SampledState<Scalar>& sample,
                               const StateCheckOptions& options)
    : subject_(subject),
      sample_(sample),
      options_(options),
      sines_(subject.scene, SineArithmetic::numbers),
      oracle_(subject, exact_state(subject, sample.values)),
      losses_(subject, oracle_, rounding_constants<Scalar>(), options.min_loss) {}

template <class Scalar>
const ExactRun& StateCheck<Scalar>::exact_run_of(const Function& function) {
  const auto known = exact_runs_.find(&function);
  if (known != exact_runs_.end()) return known->second;
  return exact_runs_[&function] =
             run_exactly(subject_.program, function, state(), rounding_constants<Scalar>());
}

template <class Scalar>
void StateCheck<Scalar>::run_function(const ComparedField& place) {
  if (place.function == function_) return;
  function_ = place.function;
  exact_ = &exact_run_of(*function_);
  values_ = evaluate_as_emitted(subject_.program, *function_, sample_.values, sines_);
  wide_runs_ = {{run_wide_code(options_.wide_code, nullptr),
                 run_wide_code(options_.wide_pack_code, &subject_.scene.numerics)}};
  if (options_.user_code == nullptr) return;
  user_code_values_ = options_.user_code->call(function_->name, sample_.values);
  user_code_values_.resize(values_.size(), std::numeric_limits<Scalar>::quiet_NaN());
}

template <class Scalar>
Mismatch StateCheck<Scalar>::compare_entries(const ComparedField& place, Finding& finding) {
  const OracleValues& truth = oracle_.values(place.request);
  if (!truth) {
    finding.regime = Regime::undefined;
    finding.is_compared = false;
    return {};
  }
  for (std::size_t i = 0; i < place.field().entries.size(); ++i) {
    const cln::cl_R& entry = (*truth)[place.first_oracle_entry + i];
    const RunningValue<Real>& own = exact_entry(place, i);
    if (!agrees_with_oracle(own, entry, oracle_)) return entry_mismatch(i, own.value, Real(entry));
    if (place.closed_form.function == nullptr) continue;
    const RunningValue<Real>& form =
        exact_run_of(*place.closed_form.function).entries[place.closed_form.first_entry + i];
    if (!agrees_with_oracle(form, entry, oracle_))
      return entry_mismatch(i, form.value, Real(entry));
  }
  return {};
}

template <class Scalar>
Mismatch StateCheck<Scalar>::compare_with_function(const ComparedField& place,
                                                   const Function& other_function,
                                                   std::size_t first, std::string_view name) {
  const ExactRun& others = exact_run_of(other_function);
  for (std::size_t i = 0; i < place.field().entries.size(); ++i) {
    const RunningValue<Real>& own = exact_entry(place, i);
    RunningValue<Real> other = others.entries[first + i];
    // Outside of the nominal states, one form may have a value although another is 0/0.
    const bool may_be_missing = sample_.region != Region::nominal || !own.value.is_defined();
    if (may_be_missing && !other.value.is_defined()) continue;
    other.error = other.error + own.error;
    if (agrees(other, own.value, Real())) continue;
    return {fmt::format("entry {} is {}, but {} in {}", i + 1, short_text(own.value),
                        short_text(other.value), name),
            own.value, other.value};
  }
  return {};
}

template <class Scalar>
Mismatch StateCheck<Scalar>::compare_by_projection(const ComparedField& place, Sampler& draw) {
  const Function* const same = repeated_function(subject_.program, place);
  if (same != nullptr)
    return compare_with_function(place, *same, 0, "the function of the same name");
  // If an entry is undefined, the closed form is not compared: outside of the domain it may have a
  // value although the solution has none.
  bool is_defined = true;
  for (std::size_t i = 0; i < place.field().entries.size(); ++i) {
    is_defined = is_defined && exact_entry(place, i).value.is_defined();
  }
  if (place.closed_form.function != nullptr && is_defined) {
    Mismatch differs = compare_with_function(place, *place.closed_form.function,
                                             place.closed_form.first_entry, "its closed form");
    if (!differs.text.empty()) return differs;
  }
  return compare_projection(subject_, place, *exact_, oracle_, draw).value_or(Mismatch());
}

template <class Scalar>
bool StateCheck<Scalar>::has_finite_values(const ComparedField& place) const {
  const auto first = values_.begin() + static_cast<std::ptrdiff_t>(place.first_entry);
  const auto size = static_cast<std::ptrdiff_t>(place.field().entries.size());
  return std::all_of(first, first + size, [](Scalar x) { return std::isfinite(x); });
}

template <class Scalar>
void StateCheck<Scalar>::measure_errors(const ComparedField& place, Finding& finding) const {
  const std::size_t operations = place.function->instructions.size();
  for (std::size_t i = 0; i < place.field().entries.size(); ++i) {
    const RunningValue<Real>& truth = exact_entry(place, i);
    const Scalar x = values_[place.first_entry + i];
    if (!std::isfinite(x)) {
      finding.mistake =
          fmt::format("entry {} is {} instead of {}", i + 1, x, short_text(truth.value));
      return;
    }
    if (sample_.region != Region::nominal || is_zero(truth.value)) continue;
    const Real error = excess_error(x, truth.value, operations, rounding_constants<Scalar>());
    finding.errors.push_back(
        place.is_remainder() ? error_in_roundoffs(error, truth.error, rounding_constants<Scalar>())
                             : error_in_ulps(x, truth.value));
  }
}

template <class Scalar>
template <class Reference>
CodeFinding StateCheck<Scalar>::compare_code(const ComparedField& place,
                                             const std::vector<Scalar>& values, double max_error,
                                             const Reference& reference_of) const {
  const std::size_t operations = place.function->instructions.size();
  CodeFinding finding{0.0, {}};
  for (std::size_t i = 0; i < place.field().entries.size(); ++i) {
    const Scalar x = values[place.first_entry + i];
    const auto [reference, size] = reference_of(i);
    const Real error = excess_error(x, reference, operations, rounding_constants<Scalar>());
    const double figure = error_in_roundoffs(error, size, rounding_constants<Scalar>());
    if (figure <= *finding.error) continue;
    finding.error = figure;
    if (figure <= max_error) continue;
    finding.mistake = fmt::format("entry {} is {:.17g} instead of {:.17g}", i + 1, x,
                                  ScalarTraits<Scalar>::from_real(reference.value()));
  }
  return finding;
}

template <class Scalar>
CodeFinding StateCheck<Scalar>::compare_user_code(const ComparedField& place) const {
  if (options_.user_code == nullptr) return {};
  return compare_code(place, user_code_values_, max_user_code_error, [&](std::size_t i) {
    const Real own(exact_value(static_cast<double>(values_[place.first_entry + i])));
    return std::pair(own, exact_entry(place, i).error);
  });
}

template <class Scalar>
CodeFinding StateCheck<Scalar>::compare_wide_code(const ComparedField& place,
                                                  const WideRun<Scalar>& run) const {
  if (run.values.empty()) return {};
  const Real factor(exact_value(max_user_code_error));
  if (!run.mixed_entries.empty()) {
    return compare_code(place, run.values, max_wide_code_error, [&](std::size_t i) {
      const auto& [value, error, is_lost, underflows] = run.mixed_entries[place.first_entry + i];
      const Real rest = max(error - abs(value), Real());
      return std::pair(value, is_zero(error) ? Real() : abs(value) + factor * rest);
    });
  }
  const double ratio = inner_scalar_row(subject_.scene.numerics.inner).roundoff /
                       to_double(rounding_constants<Scalar>().roundoff.value());
  const Real share = factor * Real(exact_value(ratio));
  return compare_code(place, run.values, max_wide_code_error, [&](std::size_t i) {
    const RunningValue<Real>& truth = exact_entry(place, i);
    return std::pair(truth.value, abs(truth.value) + share * truth.error);
  });
}

template <class Scalar>
WideRun<Scalar> StateCheck<Scalar>::run_wide_code(const CompiledModel* code,
                                                  const Numerics* packs) const {
  WideRun<Scalar> run;
  if (code == nullptr) return run;
  if (subject_.scene.numerics.has_mixed_precision()) {
    ExactRun exact = run_mixed_exactly(subject_.program, *function_, state(), packs);
    const bool is_bounded = exact.regime == Regime::regular &&
                            std::ranges::none_of(exact.entries, &RunningValue<Real>::underflows);
    if (!is_bounded) return run;
    run.mixed_entries = std::move(exact.entries);
  }
  run.values = code->call(function_->name, sample_.values);
  return run;
}

/// Values and errors below 1e-45 E count as 0, because exact values are rounded. Errors after an
/// underflow count as 0, too. NaN and infinity lose all digits if the exact value is defined.
template <class Scalar>
std::optional<Loss> StateCheck<Scalar>::measure_loss(const ComparedField& place) {
  static const Real negligible(power_of_ten(-45));
  std::vector<Real> errors;
  std::vector<Real> references;
  const std::size_t operations = place.function->instructions.size();
  for (std::size_t i = 0; i < place.field().entries.size(); ++i) {
    const RunningValue<Real>& own = exact_entry(place, i);
    if (!own.value.is_defined()) return std::nullopt;
    const Scalar x = values_[place.first_entry + i];
    const Real all = (abs(own.value) + Real(1)) / rounding_constants<Scalar>().roundoff;
    const Real error = std::isfinite(x)
                           ? excess_error(x, own.value, operations, rounding_constants<Scalar>())
                           : all;
    const Real unknown = own.error.is_defined() ? own.error * negligible : Real();
    errors.push_back(error > unknown && !own.underflows ? error : Real());
    references.push_back(abs(own.value) > unknown ? own.value : Real());
  }
  Loss loss = losses_.field_loss(place, *exact_, errors, references);
  // Near a zero, even the largest entry may cancel; then its error comes from rounded inputs, and
  // the smaller loss counts.
  double& of_field = loss.relative_to_field.loss;
  if (sample_.region == Region::near_zero)
    of_field = std::min(of_field, loss.relative_to_entry.loss);
  return loss;
}

template <class Scalar>
bool StateCheck<Scalar>::should_measure_loss(const ComparedField& place) const {
  const bool is_inside = sample_.region == Region::nominal || sample_.region == Region::near_zero ||
                         sample_.region == Region::remote;
  const bool is_looked_at = options_.loss_states == LossStates::everywhere ||
                            (options_.loss_states == LossStates::inside_ranges && is_inside);
  return is_looked_at && !place.is_remainder() && losses_.has_accurate_angles();
}

template <class Scalar>
Finding StateCheck<Scalar>::check_field(const ComparedField& place, Sampler& draw) {
  const Sampler directions = draw;
  FieldComparison look = compare_field(place, draw);
  const double sufficient = sufficient_digits(state());
  const unsigned most = max_run_digits(subject_.program);
  for (unsigned digits = first_run_digits; !look.mismatch.text.empty(); digits *= 2) {
    if (digits >= most) return Finding{.regime = Regime::unsettled};
    FieldComparison closer = with_digits(2 * digits - first_run_digits, [&] {
      Sampler same = directions;
      return StateCheck(subject_, sample_, options_).compare_field(place, same);
    });
    const bool is_confirmed =
        digits >= sufficient && is_stable_mismatch(look.mismatch, closer.mismatch);
    if (is_confirmed) return closer.finding;
    look = std::move(closer);
  }
  return look.finding;
}

template <class Scalar>
auto StateCheck<Scalar>::compare_field(const ComparedField& place, Sampler& draw)
    -> FieldComparison {
  run_function(place);
  FieldComparison look;
  Finding& finding = look.finding;
  finding.regime = exact_->regime;
  finding.is_compared = has_values(finding.regime);
  finding.is_finite = has_finite_values(place);
  // At a nominal state the program must have a value if the oracle has one.
  if (!finding.is_compared && sample_.region != Region::nominal) return look;
  look.mismatch = options_.comparison == ComparisonMode::entries
                      ? compare_entries(place, finding)
                      : compare_by_projection(place, draw);
  finding.mistake = look.mismatch.text;
  if (!finding.mistake.empty()) return look;
  if (has_values(exact_->regime) && should_measure_loss(place)) finding.loss = measure_loss(place);
  if (finding.regime != Regime::regular) return look;
  measure_errors(place, finding);
  if (!finding.mistake.empty()) return look;
  finding.user_code = compare_user_code(place);
  for (const WideRun<Scalar>& run : wide_runs_) {
    CodeFinding found = compare_wide_code(place, run);
    const bool is_worse = found.error.value_or(-1) > finding.wide_code.error.value_or(-1);
    if (is_worse) finding.wide_code = std::move(found);
  }
  return look;
}

std::size_t state_check_cost(const SystemUnderTest& subject) {
  std::size_t work = 1;
  for (const Function& function : subject.program.functions) work += function.instructions.size();
  if (subject.model.constraints.empty()) return work;
  // Elimination: n^3 operations on fractions whose digits grow with n. With the factor 1/32, loops
  // of a few bars are compared at all states, and a chain of twelve rods (n = 36) at five.
  const std::size_t n = subject.model.velocities.size() + subject.model.constraints.size();
  return work + n * n * n * n / 32;
}

template class StateCheck<double>;
template class StateCheck<float>;

}  // namespace elgen
