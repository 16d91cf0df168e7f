// Settled values: values are computed in trials, each with twice as many digits as the previous
// one, until two trials agree in the first 62 digits.
//
// If all terms cancel, a value consists of rounding errors and shrinks with every trial. It counts
// as 0 if the earlier of two trials had enough digits to show a non-zero Taylor term: 1 -
// cos(1e-100) is 5e-201, which 155 digits do not show. A value that does not change is accepted
// under the same condition, or in the last trial. Without this condition, trials with 155 digits
// would agree on the wrong value -x of log(exp(x)) - x at x = 1e-300.
//
// Irrational numbers of a state, such as pi, have 100 digits. A value such as sin(pi) counts as 0
// if it is far larger at the state rounded to 60 digits.
#include <algorithm>
#include <cmath>
#include <functional>

#include "elgen/oracle.hpp"
#include "numbers/exact_number.hpp"
#include "oracle/mechanics.hpp"
#include "oracle/output_values.hpp"
#include "oracle/real_functions.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using oracle::working_digits;

/// Digits in addition to working_digits.
constexpr unsigned first_trial_digits = 60;
constexpr unsigned last_trial_digits = 1920;
static_assert(working_digits + last_trial_digits >= max_stable_digits);

/// Two trials agree if this many digits agree: two more than elgen prints.
constexpr int required_equal_digits = 62;

/// The state, its floats padded with zeros to more digits than a trial with `digits` uses.
State extend_floats(const State& state, unsigned digits) {
  constexpr unsigned spare_digits = 45;
  const cln::float_format_t format = cln::float_format(working_digits + digits + spare_digits);
  return map_leaves(
      [&](const cl_R& x) { return is_rational(x) ? x : cl_R(cln::cl_float(x, format)); }, state);
}

/// |decimal exponent| of a float; of a rational, the larger exponent of numerator and denominator:
/// 100 for 1 + 1e-100. Cancellation may remove this many digits.
double size_in_digits(const cl_R& x) {
  if (!is_rational(x)) return std::abs(decimal_exponent(x));
  const auto r = cln::the<cln::cl_RA>(x);
  return std::max(decimal_exponent(cln::numerator(r)), decimal_exponent(cln::denominator(r)));
}

/// A state has 100 digits. Rounding must remove more than the 20 digits of zero_shrink_ratio().
constexpr unsigned digits_of_rounded_state = 60;

/// A value is taken for rounding errors if it shrinks by at least this factor from one trial to the
/// next.
const cl_R& zero_shrink_ratio() {
  static const cl_R share = power_of_ten(-20);
  return share;
}

/// The state with its floats rounded to 60 digits; empty if all of its numbers are rational.
std::optional<State> round_floats(const State& state) {
  static const cln::float_format_t format = cln::float_format(digits_of_rounded_state);
  bool has_floats = false;
  const State result = map_leaves(
      [&](const cl_R& x) {
        if (is_rational(x)) return x;
        has_floats = true;
        return cl_R(cln::cl_float(x, format));
      },
      state);
  return has_floats ? std::optional(result) : std::nullopt;
}

/// The digits needed to show eighth powers of the leaves and the literals: 8 times the largest
/// size_in_digits() of these numbers; at most 1e6.
unsigned digits_of_powers(const Model& model, const State& state) {
  double most = 0;
  const auto look = [&most](const cl_R& x) { most = std::max(most, size_in_digits(x)); };
  for_each_leaf([&](Opcode, std::uint32_t, const cl_R& x) { look(x); }, state);
  for (const Expression& e : model.expressions) {
    if (e.kind == ExpressionKind::number) look(e.number);
  }
  return static_cast<unsigned>(std::min(8 * most, 1e6));
}

struct PrecisionTrial {
  OracleValues values = {};
  bool is_too_large = false;   ///< a number is too large to compute
  unsigned hidden_digits = 0;  ///< digits that exponentials may hide
};

using Computation = std::function<std::vector<cl_R>(const State&)>;

PrecisionTrial evaluate_with_digits(const Computation& values, const State& state,
                                    unsigned digits) {
  PrecisionTrial look;
  (void)ExtraDigits::take_hidden();
  const State longer = extend_floats(state, digits);
  const auto guarded_values = [&] {
    try {
      return values(longer);
    } catch (const oracle::NumberTooLarge&) {
      look.is_too_large = true;
      throw;
    }
  };
  look.values =
      with_digits(digits, [&] { return oracle::attempt_with_enough_digits(guarded_values); });
  look.hidden_digits = ExtraDigits::take_hidden();
  return look;
}

struct TrialPair {
  bool is_conclusive = false;  ///< the first trial has enough digits to show a non-zero value
  bool is_last = false;
};

/// The settled value from two trials; empty if the trials do not settle it.
std::optional<cl_R> stable_value(const cl_R& before, const cl_R& now, const TrialPair& looks) {
  static const cl_R share_that_stays = power_of_ten(-required_equal_digits);
  const bool stays = cln::abs(now - before) <= cln::abs(now) * share_that_stays;
  const bool is_zero = cln::zerop(now) || cln::zerop(before) ||
                       cln::abs(now) <= cln::abs(before) * zero_shrink_ratio();
  if (is_rational(now) && stays) return now;
  if (is_zero) return looks.is_conclusive ? std::optional<cl_R>(0) : std::nullopt;
  return stays && (looks.is_conclusive || looks.is_last) ? std::optional(now) : std::nullopt;
}

/// All settled values from two trials; empty if any value is not settled.
std::optional<StableValues> stable_values_of_trials(const PrecisionTrial& before,
                                                    const PrecisionTrial& now,
                                                    const TrialPair& looks) {
  const bool has_no_value = !before.values && !now.values;
  if (has_no_value && looks.is_conclusive) return StableValues{};
  if (!before.values || !now.values) return std::nullopt;
  std::vector<cl_R> values;
  for (std::size_t i = 0; i < now.values->size(); ++i) {
    const auto value = stable_value((*before.values)[i], (*now.values)[i], looks);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return StableValues{std::move(values)};
}

/// Sets to 0 each value that is far smaller than its value at the rounded state.
void clear_rounding_errors(std::vector<cl_R>& settled, const OracleValues& at_rounded) {
  if (!at_rounded) return;
  for (std::size_t i = 0; i < settled.size(); ++i) {
    const cl_R& there = (*at_rounded)[i];
    if (cln::abs(settled[i]) <= cln::abs(there) * zero_shrink_ratio()) settled[i] = 0;
  }
}

StableValues evaluate_until_stable(const Model& model, const State& state,
                                   const Computation& values) {
  const StableValues undecided{.is_decided = false};
  const unsigned needed_digits = digits_of_powers(model, state);
  // For small e, 1 + (1 - cos(e))/e^2 is 3/2. With too few digits, both trials may agree on 1.
  unsigned digits = first_trial_digits;
  while (2 * digits < last_trial_digits && working_digits + digits < needed_digits) digits *= 2;
  PrecisionTrial before = evaluate_with_digits(values, state, digits);
  for (; digits < last_trial_digits; digits *= 2) {
    PrecisionTrial now = evaluate_with_digits(values, state, 2 * digits);
    if (before.is_too_large || now.is_too_large) return undecided;
    const TrialPair looks{
        .is_conclusive = working_digits + digits >=
                         std::max({needed_digits, before.hidden_digits, now.hidden_digits}),
        .is_last = 2 * digits >= last_trial_digits};
    if (auto found = stable_values_of_trials(before, now, looks)) {
      const std::optional<State> rough = found->values ? round_floats(state) : std::nullopt;
      if (rough)
        clear_rounding_errors(*found->values,
                              evaluate_with_digits(values, *rough, 2 * digits).values);
      return *found;
    }
    before = std::move(now);
  }
  return undecided;
}

}  // namespace

StableValues stable_values(const Model& model, const OutputRequest& output, const State& state) {
  return evaluate_until_stable(
      model, state, [&](const State& at) { return oracle::output_values(model, output, at); });
}

StableValues stable_expression_value(const Model& model, ExpressionId expression,
                                     const State& state) {
  return evaluate_until_stable(model, state, [&](const State& at) {
    const oracle::Motion motion = oracle::make_motion(at);
    return std::vector<cl_R>{oracle::Evaluation(model, motion).value(expression).real()};
  });
}

}  // namespace elgen
