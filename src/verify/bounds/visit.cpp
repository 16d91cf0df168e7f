// Visits one state: runs each function once, compares its fields and measures their errors.
#include "verify/bounds/visit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "elgen/outputs.hpp"
#include "elgen/scalars.hpp"
#include "numbers/more_digits.hpp"
#include "verify/bounds/projection.hpp"

namespace elgen {
namespace {

/// Decimal digits of the runs. If values differ, runs are repeated, each with twice the digits.
constexpr unsigned digits_of_first_look = 64;
constexpr unsigned digits_of_last_look = 1024;

/// The largest number of digits of a repeated run. Irrational constants have 200 digits, so more
/// digits decide nothing.
unsigned most_digits(const Program& program) {
  constexpr unsigned digits_of_constants = 256;
  const auto is_exact = [](const Constant& constant) { return is_rational(constant); };
  const bool are_exact = std::ranges::all_of(program.constants, is_exact);
  return are_exact ? digits_of_last_look : digits_of_constants;
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
double ulps_apart(Scalar x, const Real& truth) {
  const Scalar magnitude = std::abs(ScalarTraits<Scalar>::from_real(truth.value()));
  const Scalar next = std::nextafter(magnitude, std::numeric_limits<Scalar>::infinity());
  const Real difference = abs(Real(exact_value(static_cast<double>(x))) - truth);
  return to_double(difference.value()) / static_cast<double>(next - magnitude);
}

Mismatch mismatch(std::size_t entry, const Real& value, const Real& truth) {
  return {fmt::format("entry {} is {}, the oracle says {}", entry + 1, short_text(value),
                      short_text(truth)),
          value, truth};
}

/// The function that the field `place` of `dynamics` repeats, if this function has a single field;
/// otherwise null.
const Function* repeated_function(const Program& program, const FieldPlace& place) {
  if (!output_row(place.function->kind).is_summary) return nullptr;
  const auto found = std::ranges::find(program.functions, place.field().name, &Function::name);
  return found == program.functions.end() || found->fields.size() != 1 ? nullptr : &*found;
}

}  // namespace

template <class Scalar>
Visit<Scalar>::Visit(const Subject& subject, const SampledState<Scalar>& sample,
                     const VisitOptions& options)
    : subject_(subject),
      sample_(sample),
      options_(options),
      sines_(subject.scene, SineArithmetic::numbers),
      oracle_(subject, exact_state(subject, sample.values)),
      losses_(subject, oracle_, rounding<Scalar>(), options.least_loss) {}

template <class Scalar>
const ExactRun& Visit<Scalar>::exact_run_of(const Function& function) {
  const auto known = exact_runs_.find(&function);
  if (known != exact_runs_.end()) return known->second;
  return exact_runs_[&function] =
             exact_run(subject_.program, function, state(), rounding<Scalar>());
}

template <class Scalar>
void Visit<Scalar>::run(const FieldPlace& place) {
  if (place.function == function_) return;
  function_ = place.function;
  exact_ = &exact_run_of(*function_);
  values_ = evaluate_code(subject_.program, *function_, sample_.values, sines_);
  wide_values_.clear();
  if (options_.wide != nullptr && fits_inner_scalar()) {
    wide_values_ = options_.wide->call(function_->name, sample_.values);
  }
  if (options_.as_users == nullptr) return;
  users_values_ = options_.as_users->call(function_->name, sample_.values);
  users_values_.resize(values_.size(), std::numeric_limits<Scalar>::quiet_NaN());
}

template <class Scalar>
Mismatch Visit<Scalar>::differing_entry(const FieldPlace& place, Finding& finding) {
  const OracleValues& truth = oracle_.values(place.request);
  if (!truth) {
    finding.regime = Regime::undefined;
    finding.is_compared = false;
    return {};
  }
  for (std::size_t i = 0; i < place.field().entries.size(); ++i) {
    const cln::cl_R& entry = (*truth)[place.first_oracle + i];
    const Running<Real>& own = exact(place, i);
    if (!agrees_with_oracle(own, entry, oracle_)) return mismatch(i, own.value, Real(entry));
    if (place.form.function == nullptr) continue;
    const Running<Real>& form = exact_run_of(*place.form.function).entries[place.form.first + i];
    if (!agrees_with_oracle(form, entry, oracle_)) return mismatch(i, form.value, Real(entry));
  }
  return {};
}

template <class Scalar>
Mismatch Visit<Scalar>::compare_with_entries(const FieldPlace& place,
                                             const Function& other_function, std::size_t first,
                                             std::string_view name) {
  const ExactRun& others = exact_run_of(other_function);
  for (std::size_t i = 0; i < place.field().entries.size(); ++i) {
    const Running<Real>& own = exact(place, i);
    Running<Real> other = others.entries[first + i];
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
Mismatch Visit<Scalar>::differing_projection(const FieldPlace& place, Sampler& draw) {
  const Function* const same = repeated_function(subject_.program, place);
  if (same != nullptr)
    return compare_with_entries(place, *same, 0, "the function of the same name");
  // If an entry is undefined, the closed form is not compared: outside of the domain it may have a
  // value although the solution has none.
  bool is_defined = true;
  for (std::size_t i = 0; i < place.field().entries.size(); ++i) {
    is_defined = is_defined && exact(place, i).value.is_defined();
  }
  if (place.form.function != nullptr && is_defined) {
    Mismatch differs =
        compare_with_entries(place, *place.form.function, place.form.first, "its closed form");
    if (!differs.text.empty()) return differs;
  }
  return compare_projection(subject_, place, *exact_, oracle_, draw);
}

template <class Scalar>
bool Visit<Scalar>::has_finite_values(const FieldPlace& place) const {
  const auto first = values_.begin() + static_cast<std::ptrdiff_t>(place.first);
  const auto size = static_cast<std::ptrdiff_t>(place.field().entries.size());
  return std::all_of(first, first + size, [](Scalar x) { return std::isfinite(x); });
}

template <class Scalar>
void Visit<Scalar>::measure(const FieldPlace& place, Finding& finding) const {
  const std::size_t operations = place.function->instructions.size();
  for (std::size_t i = 0; i < place.field().entries.size(); ++i) {
    const Running<Real>& truth = exact(place, i);
    const Scalar x = values_[place.first + i];
    if (!std::isfinite(x)) {
      finding.mistake =
          fmt::format("entry {} is {} instead of {}", i + 1, x, short_text(truth.value));
      return;
    }
    if (sample_.region != Region::nominal || is_zero(truth.value)) continue;
    const Real error = excess_error(x, truth.value, operations, rounding<Scalar>());
    finding.errors.push_back(place.is_remainder()
                                 ? in_roundoffs(error, truth.error, rounding<Scalar>())
                                 : ulps_apart(x, truth.value));
  }
}

template <class Scalar>
template <class Reference>
CodeFinding Visit<Scalar>::compare_code(const FieldPlace& place, const std::vector<Scalar>& values,
                                        double most, const Reference& reference_of) const {
  const std::size_t operations = place.function->instructions.size();
  CodeFinding finding{0.0, {}};
  for (std::size_t i = 0; i < place.field().entries.size(); ++i) {
    const Scalar x = values[place.first + i];
    const auto [reference, size] = reference_of(i);
    const Real error = excess_error(x, reference, operations, rounding<Scalar>());
    const double figure = in_roundoffs(error, size, rounding<Scalar>());
    if (figure <= *finding.error) continue;
    finding.error = figure;
    if (figure <= most) continue;
    finding.mistake = fmt::format("entry {} is {:.17g} instead of {:.17g}", i + 1, x,
                                  ScalarTraits<Scalar>::from_real(reference.value()));
  }
  return finding;
}

template <class Scalar>
CodeFinding Visit<Scalar>::compare_users_code(const FieldPlace& place) const {
  if (options_.as_users == nullptr) return {};
  return compare_code(place, users_values_, most_of_users, [&](std::size_t i) {
    const Real own(exact_value(static_cast<double>(values_[place.first + i])));
    return std::pair(own, exact(place, i).error);
  });
}

template <class Scalar>
CodeFinding Visit<Scalar>::compare_wide_code(const FieldPlace& place) const {
  if (wide_values_.empty()) return {};
  const double ratio = inner_row(subject_.scene.numerics.inner).roundoff /
                       to_double(rounding<Scalar>().roundoff.value());
  const Real share(exact_value(most_of_users * ratio));
  return compare_code(place, wide_values_, most_of_wide, [&](std::size_t i) {
    const Running<Real>& truth = exact(place, i);
    const Real& error = in_float_.empty() ? truth.error : in_float_[place.first + i].error;
    return std::pair(truth.value, abs(truth.value) + share * error);
  });
}

/// False if the inner scalar is float, and some value in float is undefined, too large, too small
/// or ill-conditioned.
template <class Scalar>
bool Visit<Scalar>::fits_inner_scalar() {
  in_float_.clear();
  if (subject_.scene.numerics.inner != InnerScalar::single_precision) return true;
  const ExactRun run = exact_run(subject_.program, *function_, state(), rounding<float>());
  in_float_ = run.entries;
  return run.regime == Regime::regular &&
         std::ranges::none_of(run.entries, &Running<Real>::underflows);
}

/// Values and errors below 1e-45 E count as 0, because exact values are rounded. Errors after an
/// underflow count as 0, too. NaN and infinity lose all digits if the exact value is defined.
template <class Scalar>
std::optional<Loss> Visit<Scalar>::measured_loss(const FieldPlace& place) {
  static const Real negligible(power_of_ten(-45));
  std::vector<Real> errors;
  std::vector<Real> references;
  const std::size_t operations = place.function->instructions.size();
  for (std::size_t i = 0; i < place.field().entries.size(); ++i) {
    const Running<Real>& own = exact(place, i);
    if (!own.value.is_defined()) return std::nullopt;
    const Scalar x = values_[place.first + i];
    const Real all = (abs(own.value) + Real(1)) / rounding<Scalar>().roundoff;
    const Real error =
        std::isfinite(x) ? excess_error(x, own.value, operations, rounding<Scalar>()) : all;
    const Real unknown = own.error.is_defined() ? own.error * negligible : Real();
    errors.push_back(error > unknown && !own.underflows ? error : Real());
    references.push_back(abs(own.value) > unknown ? own.value : Real());
  }
  Loss loss = losses_.of_field(place, *exact_, errors, references);
  // Near a zero, even the largest entry may cancel; then its error comes from rounded inputs, and
  // the smaller loss counts.
  double& of_field = loss.of_field.figure;
  if (sample_.region == Region::near_zero) of_field = std::min(of_field, loss.of_entry.figure);
  return loss;
}

template <class Scalar>
bool Visit<Scalar>::may_lose(const FieldPlace& place) const {
  const bool is_inside = sample_.region == Region::nominal || sample_.region == Region::near_zero;
  const bool is_looked_at = options_.loss_states == LossStates::everywhere ||
                            (options_.loss_states == LossStates::inside_ranges && is_inside);
  return is_looked_at && !place.is_remainder() && losses_.knows_angles();
}

template <class Scalar>
Finding Visit<Scalar>::look_at(const FieldPlace& place, Sampler& draw) {
  const Sampler directions = draw;
  Look look = found(place, draw);
  const double sufficient = sufficient_digits(state());
  const unsigned most = most_digits(subject_.program);
  for (unsigned digits = digits_of_first_look; !look.mismatch.text.empty(); digits *= 2) {
    if (digits >= most) return Finding{.regime = Regime::unsettled};
    Look closer = with_digits(2 * digits - digits_of_first_look, [&] {
      Sampler same = directions;
      return Visit(subject_, sample_, options_).found(place, same);
    });
    const bool is_told = digits >= sufficient && is_stable(look.mismatch, closer.mismatch);
    if (is_told) return closer.finding;
    look = std::move(closer);
  }
  return look.finding;
}

template <class Scalar>
auto Visit<Scalar>::found(const FieldPlace& place, Sampler& draw) -> Look {
  run(place);
  Look look;
  Finding& finding = look.finding;
  finding.regime = exact_->regime;
  finding.is_compared = has_values(finding.regime);
  finding.is_finite = has_finite_values(place);
  // At a nominal state the program must have a value if the oracle has one.
  if (!finding.is_compared && sample_.region != Region::nominal) return look;
  look.mismatch = options_.comparison == Comparison::entries ? differing_entry(place, finding)
                                                             : differing_projection(place, draw);
  finding.mistake = look.mismatch.text;
  if (!finding.mistake.empty()) return look;
  if (has_values(exact_->regime) && may_lose(place)) finding.loss = measured_loss(place);
  if (finding.regime != Regime::regular) return look;
  measure(place, finding);
  if (!finding.mistake.empty()) return look;
  finding.users = compare_users_code(place);
  finding.wide = compare_wide_code(place);
  return look;
}

std::size_t work_of_state(const Subject& subject) {
  std::size_t work = 1;
  for (const Function& function : subject.program.functions) work += function.instructions.size();
  if (subject.model.constraints.empty()) return work;
  // Elimination: n^3 operations on fractions whose digits grow with n. With the factor 1/32, loops
  // of a few bars are compared at all states, and a chain of twelve rods (n = 36) at five.
  const std::size_t n = subject.model.velocities.size() + subject.model.constraints.size();
  return work + n * n * n * n / 32;
}

template class Visit<double>;
template class Visit<float>;

}  // namespace elgen
