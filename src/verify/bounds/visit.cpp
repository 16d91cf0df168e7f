// Visits: runs of one function after another, each compared and measured once.
#include "verify/bounds/visit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "elgen/outputs.hpp"
#include "numbers/more_digits.hpp"
#include "verify/bounds/projection.hpp"

namespace elgen {
namespace {

/// Digits of looks at values that differ: each look has twice the digits of the one before.
constexpr unsigned digits_of_first_look = 64;
constexpr unsigned digits_of_last_look = 1024;

/// Constants that are not rational are known to 200 digits: more of them say nothing.
unsigned most_digits(const Program& program) {
  constexpr unsigned digits_of_constants = 256;
  const auto is_exact = [](const Constant& constant) { return is_rational(constant); };
  const bool are_exact = std::ranges::all_of(program.constants, is_exact);
  return are_exact ? digits_of_last_look : digits_of_constants;
}

/// Two looks that say the same are right where the first has so many digits. With fewer 1 - cos(x)
/// may be 0 in both, and its quotients by x^2 are as wrong as they are steady. Second derivatives
/// of such quotients depend on powers of x up to the eighth. Parameters are near their values.
double telling_digits(const State& state) {
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
  return ScalarTraits<double>::from_real(difference.value()) /
         static_cast<double>(next - magnitude);
}

double cancellation(const Bound& entry) {
  if (cln::zerop(entry.value.value())) return 0;
  return ScalarTraits<double>::from_real((entry.bound / abs(entry.value)).value());
}

Mismatch mismatch(std::size_t entry, const Real& value, const Real& truth) {
  return {fmt::format("entry {} is {}, the oracle says {}", entry + 1, short_text(value),
                      short_text(truth)),
          value, truth};
}

std::vector<Bound> slice(const std::vector<Bound>& entries, std::size_t first, std::size_t count) {
  const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

/// Solutions that cancel have own bounds which say nothing: more than a tenth of the largest entry.
bool says_something(const std::vector<Bound>& entries, const Real& roundoff) {
  Real largest;
  Real error;
  for (const Bound& entry : entries) {
    if (!entry.value.is_defined()) return false;
    largest = max(largest, abs(entry.value));
    error = max(error, Real(80) * roundoff * entry.bound);
  }
  return error.value() <= largest.value();
}

}  // namespace

template <class Scalar>
Visit<Scalar>::Visit(const Subject& subject, const SampledState<Scalar>& sample,
                     const VisitOptions& options)
    : subject_(subject),
      sample_(sample),
      options_(options),
      oracle_(subject, exact_state(subject, sample.values)),
      solutions_(subject.model, options.parts, oracle_.state(), rounding<Scalar>()),
      losses_(subject, oracle_.state(), rounding<Scalar>()) {}

template <class Scalar>
void Visit<Scalar>::run(const FieldPlace& place) {
  if (place.function != function_) {
    function_ = place.function;
    exact_ = bounded_run(subject_.program, *function_, state(), rounding<Scalar>());
    values_ = evaluate(subject_.program, *function_, sample_.values);
    if (options_.as_users != nullptr) {
      users_values_ = options_.as_users->call(function_->name, sample_.values);
    }
    const bool is_repeated =
        options_.comparison == Comparison::projections && function_->fields.size() == 1;
    if (is_repeated) known_[function_->name] = exact_.entries;
  }
  if (!place.judge.is_closed_form || place.judge.function == judge_) return;
  judge_ = place.judge.function;
  judge_run_ = bounded_run(subject_.program, *judge_, state(), rounding<Scalar>());
}

template <class Scalar>
auto Visit<Scalar>::judged(const FieldPlace& place) -> Judged {
  const std::size_t count = place.field().entries.size();
  Judged result{exact_.regime, slice(exact_.entries, place.first, count), {}};
  if (place.judge.is_closed_form) {
    result.regime = worse(exact_.regime, judge_run_.regime);
    result.entries = slice(judge_run_.entries, place.judge.first, count);
    return result;
  }
  // A remainder cancels, and is known to the rounding of its terms.
  const bool solves = output_row(place.request.kind).solves && !place.is_remainder();
  if (!solves || !has_values(result.regime)) return result;
  result.columns = solutions_.columns(place, exact_.entries);
  if (!result.columns.empty()) {
    result.regime = Regime::regular;
  } else if (!says_something(result.entries, rounding<Scalar>().roundoff)) {
    result.regime = Regime::ill_conditioned;
  }
  return result;
}

template <class Scalar>
Mismatch Visit<Scalar>::differing_entry(const FieldPlace& place, const Judged& judged,
                                        Finding& finding) {
  const OracleValues& truth = oracle_.values(place.request);
  const bool solves = output_row(place.request.kind).solves;
  if (!truth || (solves && !oracle_.solves())) {
    finding.regime = truth ? Regime::ill_conditioned : Regime::undefined;
    return {};
  }
  std::vector<Real> bounds;
  for (const Bound& entry : judged.entries) bounds.push_back(entry.bound);
  for (const SolvedColumn& column : judged.columns) {
    for (std::size_t i = 0; i < column.entries.size(); ++i) {
      bounds[column.entries[i]] = column.bound / column.weights[i];
    }
  }
  for (std::size_t i = 0; i < judged.entries.size(); ++i) {
    const Bound& own = exact_.entries[place.first + i];
    const cln::cl_R& exact = (*truth)[place.first_oracle + i];
    const Real own_bound = judged.columns.empty() ? own.bound : bounds[i];
    for (const Measured& number :
         {Measured{own.value, own_bound}, Measured{judged.entries[i].value, bounds[i]}}) {
      if (agrees_with_oracle(number, exact, exact_.largest, oracle_)) continue;
      return mismatch(i, number.value, Real(exact));
    }
  }
  return {};
}

template <class Scalar>
Mismatch Visit<Scalar>::differing_from(const FieldPlace& place, const std::vector<Bound>& others,
                                       std::string_view of) const {
  for (std::size_t i = 0; i < others.size(); ++i) {
    const Real& own = exact_.entries[place.first + i].value;
    const Bound& other = others[i];
    if (!own.is_defined() && !other.value.is_defined()) continue;
    if (agrees({other.value, other.bound}, own, exact_.largest)) continue;
    return {fmt::format("entry {} is {}, but {} in {}", i + 1, short_text(own),
                        short_text(other.value), of),
            own, other.value};
  }
  return {};
}

template <class Scalar>
bool Visit<Scalar>::is_defined(const FieldPlace& place) const {
  const auto first = exact_.entries.begin() + static_cast<std::ptrdiff_t>(place.first);
  const auto count = static_cast<std::ptrdiff_t>(place.field().entries.size());
  return std::all_of(first, first + count, [](const Bound& x) { return x.value.is_defined(); });
}

template <class Scalar>
Mismatch Visit<Scalar>::differing_projection(const FieldPlace& place, const Judged& judged,
                                             Random& random) {
  const bool repeats = output_row(place.function->kind).repeats;
  const auto known = repeats ? known_.find(place.field().name) : known_.end();
  if (known != known_.end())
    return differing_from(place, known->second, "the function of its name");
  // An entry without a value is compared with the oracle alone: a closed form may have one outside
  // of the domain, where a solution that it belongs to has none.
  const bool has_form = place.judge.is_closed_form && is_defined(place);
  const Mismatch differs =
      has_form ? differing_from(place, judged.entries, "its closed form") : Mismatch();
  return differs.text.empty() ? compare_projection(subject_, place, exact_, oracle_, random)
                              : differs;
}

template <class Scalar>
void Visit<Scalar>::add_error(const FieldPlace& place, std::size_t entry, double error,
                              Finding& finding) const {
  const double largest = finding.error.value_or(0);
  const bool is_new = !finding.error || std::isnan(error) || error > largest;
  if (!is_new || std::isnan(largest)) return;
  finding.error = error;
  if (error <= promised_bounds) return;
  finding.imprecision = fmt::format("{:.17g} instead of {} is {:.2g} times its error bound",
                                    values_[place.first + entry],
                                    short_text(exact_.entries[place.first + entry].value), error);
}

template <class Scalar>
double Visit<Scalar>::error_in_norm(const FieldPlace& place, const SolvedColumn& column) const {
  const std::size_t operations = place.function->instructions.size();
  Real square;
  for (std::size_t i = 0; i < column.entries.size(); ++i) {
    const std::size_t at = place.first + column.entries[i];
    const Real error =
        excess_error(values_[at], exact_.entries[at].value, operations, rounding<Scalar>());
    const Real weighted = error * column.weights[i];
    square = square + weighted * weighted;
  }
  return in_bounds(sqrt(square), column.bound, rounding<Scalar>());
}

/// None where nothing bounds it. Beyond the ranges the code may round more on its way to M and b
/// than M and b themselves do, and a solution that is 0 on paper is rounding of the code's own
/// terms: there its own bound decides.
template <class Scalar>
std::optional<double> Visit<Scalar>::error_of(const FieldPlace& place,
                                              const SolvedColumn& column) const {
  static const Real nothing(power_of_ten(-40));
  const double in_norm = error_in_norm(place, column);
  std::vector<Bound> own;
  for (const std::size_t entry : column.entries) own.push_back(exact_.entries[place.first + entry]);
  const bool keeps = in_norm <= promised_bounds;
  const bool vanishes = std::ranges::all_of(own, [](const Bound& x) {
    return x.value.is_defined() && abs(x.value).value() <= (x.bound * nothing).value();
  });
  if (keeps || (sample_.region == Region::nominal && !vanishes)) return in_norm;
  const bool has_own = exact_.regime == Regime::regular &&
                       (vanishes || says_something(own, rounding<Scalar>().roundoff));
  if (!has_own) return std::nullopt;
  double largest = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const Scalar x = values_[place.first + column.entries[i]];
    const std::size_t operations = place.function->instructions.size();
    largest = std::max(largest, error_in_bounds(x, own[i], operations, rounding<Scalar>()));
  }
  return std::min(in_norm, largest);
}

template <class Scalar>
void Visit<Scalar>::measure(const FieldPlace& place, const Judged& judged, Finding& finding) const {
  const std::size_t operations = place.function->instructions.size();
  finding.in_norm = !judged.columns.empty();
  std::vector<bool> by_norm(judged.entries.size());
  for (const SolvedColumn& column : judged.columns) {
    for (const std::size_t entry : column.entries) by_norm[entry] = true;
    const std::optional<double> error = error_of(place, column);
    if (!error) {
      finding = Finding{.regime = Regime::ill_conditioned};
      return;
    }
    add_error(place, column.entries.front(), *error, finding);
  }
  for (std::size_t i = 0; i < judged.entries.size(); ++i) {
    const Bound& own = exact_.entries[place.first + i];
    const Scalar x = values_[place.first + i];
    if (!by_norm[i]) {
      const Bound& bound = judging_bound(own, judged.entries[i]);
      add_error(place, i, error_in_bounds(x, bound, operations, rounding<Scalar>()), finding);
      finding.cancellation = std::max(finding.cancellation, cancellation(bound));
    }
    if (sample_.region != Region::nominal || cln::zerop(own.value.value())) continue;
    finding.ulps.push_back(ulps_apart(x, own.value));
  }
}

template <class Scalar>
void Visit<Scalar>::measure_users(const FieldPlace& place, const Judged& judged, Finding& finding) {
  Finding users;
  std::swap(values_, users_values_);
  measure(place, judged, users);
  std::swap(values_, users_values_);
  finding.users_error = users.error;
  finding.users_imprecision = std::move(users.imprecision);
}

/// Exact values have 60 digits of the largest of what they are made of: values and errors that are
/// no larger than what is left out of them are 0, and so are errors of what underflows on the way.
/// NaN and infinity have no digit, wherever there is an exact value.
template <class Scalar>
auto Visit<Scalar>::deviations(const FieldPlace& place, const Judged& judged,
                               std::span<const Scalar> values, std::size_t operations) const
    -> std::optional<Deviations> {
  static const Real negligible(power_of_ten(-45));
  Deviations result;
  for (std::size_t i = 0; i < judged.entries.size(); ++i) {
    const Bound& own = exact_.entries[place.first + i];
    if (!own.value.is_defined()) return std::nullopt;
    const Real all = (abs(own.value) + Real(1)) / rounding<Scalar>().roundoff;
    const Real error = std::isfinite(values[i])
                           ? excess_error(values[i], own.value, operations, rounding<Scalar>())
                           : all;
    const Real unknown = own.bound * negligible;
    const bool is_known = error.value() > unknown.value();
    result.errors.push_back(is_known && !own.underflows ? error : Real());
    result.exact.push_back(abs(own.value).value() > unknown.value() ? own.value : Real());
  }
  return result;
}

template <class Scalar>
std::optional<Loss> Visit<Scalar>::measured_loss(const FieldPlace& place, const Judged& judged) {
  const std::span<const Scalar> values(&values_[place.first], judged.entries.size());
  const auto found = deviations(place, judged, values, place.function->instructions.size());
  if (!found) return std::nullopt;
  Loss loss = losses_.of_field(place, found->errors, found->exact, judged.columns);
  // Where the largest entry itself cancels, what the inputs' rounding costs is no loss.
  double& of_field = loss.of_field.figure;
  if (sample_.region == Region::near_zero) of_field = std::min(of_field, loss.of_entry.figure);
  return loss;
}

template <class Scalar>
Finding Visit<Scalar>::look_at(const FieldPlace& place, Random& random) {
  const Random directions = random;
  Finding first = found(place, random);
  if (first.mistake.empty()) return first;
  const double telling = telling_digits(state());
  const unsigned most = most_digits(subject_.program);
  Mismatch before = mismatch_;
  for (unsigned digits = digits_of_first_look; digits < most; digits *= 2) {
    const auto closer_look = [&]() -> std::optional<Finding> {
      Visit closer(subject_, sample_, options_);
      Random same = directions;
      Finding finding = closer.found(place, same);
      const bool is_told = digits >= telling && is_settled(before, closer.mismatch_);
      if (finding.mistake.empty() || is_told) return finding;
      before = closer.mismatch_;
      return std::nullopt;
    };
    const auto finding = with_digits(2 * digits - digits_of_first_look, closer_look);
    if (finding) return *finding;
  }
  return Finding{.regime = Regime::unsettled};
}

template <class Scalar>
Finding Visit<Scalar>::found(const FieldPlace& place, Random& random) {
  run(place);
  mismatch_ = {};
  const Judged judged = this->judged(place);
  Finding finding;
  finding.regime = judged.regime;
  // At ordinary states the oracle is asked all the same: what has a value there must have one here.
  if (!has_values(judged.regime) && sample_.region != Region::nominal) return finding;
  mismatch_ = options_.comparison == Comparison::entries
                  ? differing_entry(place, judged, finding)
                  : differing_projection(place, judged, random);
  finding.mistake = mismatch_.text;
  const bool is_measured = finding.mistake.empty() && finding.regime == Regime::regular;
  if (is_measured) measure(place, judged, finding);
  if (is_measured && options_.as_users != nullptr) measure_users(place, judged, finding);
  const bool can_lose = finding.mistake.empty() && has_values(judged.regime) &&
                        !place.is_remainder() && losses_.knows_angles();
  const bool is_looked_at =
      options_.losing == Losing::everywhere ||
      (options_.losing == Losing::inside_ranges &&
       (sample_.region == Region::nominal || sample_.region == Region::near_zero));
  if (is_looked_at && can_lose) finding.loss = measured_loss(place, judged);
  return finding;
}

std::size_t work_of_state(const Subject& subject) {
  std::size_t work = 1;
  for (const Function& function : subject.program.functions) work += function.instructions.size();
  if (subject.model.constraints.empty()) return work;
  // Elimination: n^3 operations on fractions whose digits grow with n. A 32nd of it leaves loops of
  // a few bars all their states, and a chain of twelve rods (n = 36) five.
  const std::size_t n = subject.model.velocities.size() + subject.model.constraints.size();
  return work + n * n * n * n / 32;
}

template class Visit<double>;
template class Visit<float>;

}  // namespace elgen
