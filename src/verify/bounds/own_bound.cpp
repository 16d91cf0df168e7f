// Running bounds along a function, and errors measured in them.
#include "verify/bounds/own_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/more_digits.hpp"

namespace elgen {
namespace {

/// The worst that holds of one instruction. Where bounds run along, the error of what cancels may
/// overflow while its value does not.
Regime regime_of(const Bound& x, const Rounding& rounding, bool is_running) {
  if (!x.value.is_defined()) return Regime::undefined;
  const Real reach = is_running ? abs(x.value) + rounding.roundoff * x.bound : abs(x.value);
  if (!(reach <= rounding.largest)) return Regime::overflow;
  if (x.lost) return Regime::ill_conditioned;
  return Regime::regular;
}

/// Under constraints S is made of what M gives, and more is solved with what S gives: bounds of
/// first order would grow with every solve.
bool solves_in_a_row(const Program& program, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  return row.steps || (row.solves && !program.leaves.multipliers.empty());
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

BoundedRun bounded_run(const Program& program, const Function& function, const State& state,
                       const Rounding& rounding, const std::vector<Bound>& accelerations) {
  BoundedRun run;
  const bool is_running = solves_in_a_row(program, function);
  const std::vector<Bound> values = with_enough_digits([&] {
    const auto leaf = [&](const cln::cl_R& value) { return leaf_bound(value, rounding); };
    LeafValues<Bound> leaves = map_leaves(leaf, state);
    if (!accelerations.empty()) leaves.a = accelerations;
    const BoundRules rules{leaves, rounding};
    return is_running ? fold<Bound>(RunningBoundRules{rules}, program, function)
                      : fold<Bound>(rules, program, function);
  });
  for (const Bound& value : values) {
    const Regime here = regime_of(value, rounding, is_running);
    run.regime = worse(run.regime, here);
    if (here != Regime::undefined) run.largest = max(run.largest, abs(value.value));
  }
  run.entries = entries_of(function, values);
  return run;
}

const Bound& judging_bound(const Bound& own, const Bound& closed) {
  return own.underflows ? own : closed;
}

Real excess_error(double x, const Real& exact, std::size_t operations, const Rounding& rounding) {
  if (!std::isfinite(x)) return Real::undefined();
  const Real eta = rounding.underflow * rounding.roundoff;
  const Real excess =
      abs(Real(exact_value(x)) - exact) - eta * Real(cln::cl_R(static_cast<long>(operations)));
  return max(excess, Real());
}

double in_bounds(const Real& excess, const Real& bound, const Rounding& rounding) {
  if (excess.is_defined() && cln::zerop(excess.value())) return 0;
  const Real figure = excess / (rounding.roundoff * bound);
  return figure.is_defined() ? ScalarTraits<double>::from_real(figure.value())
                             : std::numeric_limits<double>::infinity();
}

double error_in_bounds(double x, const Bound& entry, std::size_t operations,
                       const Rounding& rounding) {
  return in_bounds(excess_error(x, entry.value, operations, rounding), covering_bound(entry),
                   rounding);
}

}  // namespace elgen
