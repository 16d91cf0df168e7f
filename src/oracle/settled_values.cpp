// Settled values: values are computed with twice as many digits each time (a "look"), until the
// first 62 digits agree.
//
// If all terms cancel, a value consists of rounding errors and shrinks with every look. It counts
// as 0 if the earlier of two looks had enough digits to show a non-zero Taylor term: 1 -
// cos(1e-100) is 5e-201, which 155 digits do not show. A value that does not change is accepted
// under the same condition, or at the last look: with 155 digits log(exp(x)) - x wrongly gives -x
// at x = 1e-300.
//
// Irrational numbers of a state, such as pi, have 100 digits. A value such as sin(pi) counts as 0
// if it is far larger with these numbers rounded to 60 digits.
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
constexpr unsigned digits_of_first_look = 60;
constexpr unsigned digits_of_last_look = 1920;
static_assert(working_digits + digits_of_last_look >= max_stable_digits);

/// Two looks agree if this many digits agree: two more than elgen prints.
constexpr int digits_that_stay = 62;

/// Pads the floats of a state with zeros to more digits than a look computes with.
State lengthened(const State& state, unsigned digits) {
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

/// A state has 100 digits. The difference to 100 must exceed the 20 digits of share_of_a_zero().
constexpr unsigned digits_of_rounded_state = 60;

/// A value is taken for rounding errors if it shrinks by at least this factor from one look to the
/// next.
const cl_R& share_of_a_zero() {
  static const cl_R share = power_of_ten(-20);
  return share;
}

/// The state with its floats rounded to 60 digits; empty if all of its numbers are rational.
std::optional<State> rounded(const State& state) {
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

/// The digits needed to show eighth powers of the leaves, of the literals, and of their
/// differences.
unsigned digits_of_powers(const Model& model, const State& state) {
  double most = 0;
  const auto look = [&most](const cl_R& x) { most = std::max(most, size_in_digits(x)); };
  for_each_leaf([&](Opcode, std::uint32_t, const cl_R& x) { look(x); }, state);
  for (const Expression& e : model.expressions) {
    if (e.kind == ExpressionKind::number) look(e.number);
  }
  return static_cast<unsigned>(std::min(8 * most, 1e6));
}

struct Look {
  OracleValues values = {};
  bool is_beyond = false;  ///< a number is too large to compute
  unsigned hidden = 0;     ///< digits that exponentials may hide
};

using Computation = std::function<std::vector<cl_R>(const State&)>;

Look look_at(const Computation& values, const State& state, unsigned digits) {
  Look look;
  (void)MoreDigits::hidden();
  const State longer = lengthened(state, digits);
  const auto noting = [&] {
    try {
      return values(longer);
    } catch (const oracle::BeyondReach&) {
      look.is_beyond = true;
      throw;
    }
  };
  look.values = with_digits(digits, [&] { return oracle::attempt_with_enough_digits(noting); });
  look.hidden = MoreDigits::hidden();
  return look;
}

struct LookPair {
  bool is_conclusive = false;  ///< the first look has enough digits to show a non-zero value
  bool is_last = false;
};

/// The value from two looks; empty if it is not settled.
std::optional<cl_R> settled_value(const cl_R& before, const cl_R& now, const LookPair& looks) {
  static const cl_R share_that_stays = power_of_ten(-digits_that_stay);
  const bool stays = cln::abs(now - before) <= cln::abs(now) * share_that_stays;
  const bool is_zero = cln::zerop(now) || cln::zerop(before) ||
                       cln::abs(now) <= cln::abs(before) * share_of_a_zero();
  if (is_rational(now) && stays) return now;
  if (is_zero) return looks.is_conclusive ? std::optional<cl_R>(0) : std::nullopt;
  return stays && (looks.is_conclusive || looks.is_last) ? std::optional(now) : std::nullopt;
}

/// All values from two looks; empty if one is not settled.
std::optional<StableValues> settled_by(const Look& before, const Look& now, const LookPair& looks) {
  const bool has_no_value = !before.values && !now.values;
  if (has_no_value && looks.is_conclusive) return StableValues{};
  if (!before.values || !now.values) return std::nullopt;
  std::vector<cl_R> values;
  for (std::size_t i = 0; i < now.values->size(); ++i) {
    const auto value = settled_value((*before.values)[i], (*now.values)[i], looks);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return StableValues{std::move(values)};
}

/// Sets to 0 each value that is far smaller than its value at the rounded state.
void clear_rounding(std::vector<cl_R>& settled, const OracleValues& at_rounded) {
  if (!at_rounded) return;
  for (std::size_t i = 0; i < settled.size(); ++i) {
    const cl_R& there = (*at_rounded)[i];
    if (cln::abs(settled[i]) <= cln::abs(there) * share_of_a_zero()) settled[i] = 0;
  }
}

StableValues settled(const Model& model, const State& state, const Computation& values) {
  const StableValues undecided{.is_decided = false};
  const unsigned needed_digits = digits_of_powers(model, state);
  // With too few digits, both looks may agree on the wrong value 1 for 1 + (1 - cos(e))/e^2.
  unsigned digits = digits_of_first_look;
  while (2 * digits < digits_of_last_look && working_digits + digits < needed_digits) digits *= 2;
  Look before = look_at(values, state, digits);
  for (; digits < digits_of_last_look; digits *= 2) {
    Look now = look_at(values, state, 2 * digits);
    if (before.is_beyond || now.is_beyond) return undecided;
    const LookPair looks{.is_conclusive = working_digits + digits >=
                                          std::max({needed_digits, before.hidden, now.hidden}),
                         .is_last = 2 * digits >= digits_of_last_look};
    if (auto found = settled_by(before, now, looks)) {
      const std::optional<State> rough = found->values ? rounded(state) : std::nullopt;
      if (rough) clear_rounding(*found->values, look_at(values, *rough, 2 * digits).values);
      return *found;
    }
    before = std::move(now);
  }
  return undecided;
}

}  // namespace

StableValues stable_values(const Model& model, const OutputRequest& output, const State& state) {
  return settled(model, state,
                 [&](const State& at) { return oracle::output_values(model, output, at); });
}

StableValues stable_expression_value(const Model& model, ExpressionId expression,
                                     const State& state) {
  return settled(model, state, [&](const State& at) {
    const oracle::Motion motion = oracle::motion_of(at);
    return std::vector<cl_R>{oracle::Evaluation(model, motion).value(expression).real()};
  });
}

}  // namespace elgen
