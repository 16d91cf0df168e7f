// Running bounds along a function, and errors measured in them.
#include "verify/bounds/own_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace elgen {
namespace {

/// The worst that holds of one instruction.
Regime regime_of(const Bound& x, const Rounding& rounding) {
  if (!x.value.is_defined()) return Regime::undefined;
  if (abs(x.value).value() > rounding.largest.value()) return Regime::overflow;
  if (x.lost) return Regime::ill_conditioned;
  return Regime::regular;
}

/// Roundings that 8 u B cover. Where more meet in one entry, in a long sum or a high power, their
/// number is the bound of first order: (x + y)^12 is off by up to 23 u, and B does not count.
constexpr std::uint32_t covered_roundings = 8;

}  // namespace

Real covering_bound(const Bound& entry) {
  if (entry.roundings <= covered_roundings) return entry.bound;
  return entry.bound * Real(cln::cl_RA(entry.roundings) / covered_roundings);
}

Regime worse(Regime x, Regime y) {
  if (x == Regime::regular) return y;
  if (y == Regime::regular) return x;
  return x < y ? x : y;
}

template <class Scalar>
BoundedRun bounded_run(const Program& program, const Function& function, const State& state,
                       const std::vector<Bound>& accelerations) {
  BoundedRun run;
  RealPrecision precision;
  std::vector<Bounded<Scalar>> values;
  do {
    // Made anew where more digits are needed.
    auto arguments = arguments_at<Bounded<Scalar>>(state);
    for (std::size_t i = 0; i < accelerations.size(); ++i) arguments.a[i] = {accelerations[i]};
    values = evaluate_instructions(program, function, arguments);
  } while (precision.grows());
  for (const Bound& value : values) {
    const Regime here = regime_of(value, rounding<Scalar>());
    run.regime = worse(run.regime, here);
    if (here != Regime::undefined) run.largest = max(run.largest, abs(value.value));
  }
  for (const std::uint32_t entry : entries_of(function)) run.entries.push_back(values[entry]);
  return run;
}

template BoundedRun bounded_run<double>(const Program&, const Function&, const State&,
                                        const std::vector<Bound>&);
template BoundedRun bounded_run<float>(const Program&, const Function&, const State&,
                                       const std::vector<Bound>&);

Judge judge_of(const Program& program, std::size_t index, const Field& field, std::size_t first) {
  const Function& function = program.functions[index];
  const Judge own{&function, first, false};
  if (function.form != Form::closed) return own;
  if (!output_row(function.kind).repeats) {
    const bool is_readable =
        index < program.readable.size() && !program.readable[index].fields.empty();
    return is_readable ? Judge{&program.readable[index], first, true} : own;
  }
  // `dynamics` repeats the entries of the function that bears the field's name.
  for (const Function& readable : program.readable) {
    if (readable.name == field.name && !readable.fields.empty()) return {&readable, 0, true};
  }
  return own;
}

const Bound& judging_bound(const Bound& own, const Bound& closed) {
  return own.underflows ? own : closed;
}

template <class Scalar>
Real excess_error(Scalar x, const Real& exact, std::size_t operations) {
  if (!std::isfinite(x)) return Real::undefined();
  const Real computed(exact_value(static_cast<double>(x)));
  const Rounding& constants = rounding<Scalar>();
  const Real eta = constants.underflow * constants.roundoff;
  const Real excess = abs(computed - exact) - eta * Real(cln::cl_R(static_cast<long>(operations)));
  return max(excess, Real());
}

template <class Scalar>
double in_bounds(const Real& excess, const Real& bound) {
  if (excess.is_defined() && cln::zerop(excess.value())) return 0;
  const Real figure = excess / (rounding<Scalar>().roundoff * bound);
  return figure.is_defined() ? ScalarTraits<double>::from_real(figure.value())
                             : std::numeric_limits<double>::infinity();
}

template <class Scalar>
double error_in_bounds(Scalar x, const Bound& entry, std::size_t operations) {
  return in_bounds<Scalar>(excess_error(x, entry.value, operations), covering_bound(entry));
}

template Real excess_error(double, const Real&, std::size_t);
template Real excess_error(float, const Real&, std::size_t);
template double in_bounds<double>(const Real&, const Real&);
template double in_bounds<float>(const Real&, const Real&);
template double error_in_bounds(double, const Bound&, std::size_t);
template double error_in_bounds(float, const Bound&, std::size_t);

}  // namespace elgen
