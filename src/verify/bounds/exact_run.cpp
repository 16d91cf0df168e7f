// Exact runs of a function, and errors in units of the unit roundoff.
#include "verify/bounds/exact_run.hpp"

#include <cmath>
#include <limits>

#include "numbers/more_digits.hpp"

namespace elgen {
namespace {

/// The worst regime that applies to one instruction.
Regime regime_of(const RunningValue<Real>& x, const RoundingConstants<Real>& rounding) {
  if (!x.value.is_defined()) return Regime::undefined;
  if (!(abs(x.value) <= rounding.largest)) return Regime::overflow;
  if (x.is_lost) return Regime::ill_conditioned;
  const bool may_overflow = !(abs(x.value) + rounding.roundoff * x.error <= rounding.largest);
  return may_overflow ? Regime::overflow : Regime::regular;
}

}  // namespace

Regime worse_regime(Regime x, Regime y) {
  if (x == Regime::regular) return y;
  if (y == Regime::regular) return x;
  return x < y ? x : y;
}

ExactRun run_exactly(const Program& program, const Function& function, const State& state,
                     const RoundingConstants<Real>& rounding) {
  ExactRun run;
  run.values = with_enough_digits([&] {
    const auto leaf = [&](const cln::cl_R& value) { return running_leaf(value, rounding); };
    const RunningErrorRules<Real> rules{map_leaves(leaf, state), rounding};
    return fold<RunningValue<Real>>(rules, program, function);
  });
  for (const RunningValue<Real>& value : run.values) {
    run.regime = worse_regime(run.regime, regime_of(value, rounding));
  }
  run.entries = entries_of(function, run.values);
  return run;
}

Real excess_error(double x, const Real& exact, std::size_t operations,
                  const RoundingConstants<Real>& rounding) {
  if (!std::isfinite(x)) return Real::undefined();
  const Real eta = rounding.underflow * rounding.roundoff;
  const Real excess =
      abs(Real(exact_value(x)) - exact) - eta * Real(cln::cl_R(static_cast<long>(operations)));
  return max(excess, Real());
}

double error_in_roundoffs(const Real& excess, const Real& scale,
                          const RoundingConstants<Real>& rounding) {
  if (excess.is_defined() && cln::zerop(excess.value())) return 0;
  const Real figure = excess / (rounding.roundoff * scale);
  return figure.is_defined() ? to_double(figure.value()) : std::numeric_limits<double>::infinity();
}

}  // namespace elgen
