// Exact runs of a function, and errors in units of the unit roundoff.
#include "verify/bounds/exact_run.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "elgen/fold.hpp"
#include "numbers/more_digits.hpp"
#include "program/evaluate/sines.hpp"

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

using ErrorValue = RunningValue<Real>;

bool is_exact_zero(const ErrorValue& x) { return is_zero(x.value) && is_zero(x.error); }

/// The rules of one scalar in a step, see run_mixed_exactly().
struct StepRules : RunningErrorRules<Real> {
  Real sine_error = {};  ///< of sines and cosines in packs, in u
  std::optional<Real> domain = {};

  [[nodiscard]] ErrorValue add(const ErrorValue& x, const ErrorValue& y) const {
    ErrorValue sum = RunningErrorRules::add(x, y);
    if (is_exact_zero(x) || is_exact_zero(y)) sum.error = x.error + y.error;
    return sum;
  }

  [[nodiscard]] ErrorValue call(FunctionId function, const ErrorValue& x,
                                const ErrorValue& y) const {
    ErrorValue result = RunningErrorRules::call(function, x, y);
    if (!is_circular(function)) return result;
    result.error = result.error + sine_error;
    result.is_lost = result.is_lost || (domain && abs(x.value) > *domain);
    return result;
  }
};

template <class Scalar>
StepRules step_rules(const State& state, const Numerics* packs) {
  const RoundingConstants<Real>& rounding = rounding_constants<Scalar>();
  const auto leaf = [&](const cln::cl_R& value) { return running_leaf(value, rounding); };
  StepRules rules{{map_leaves(leaf, state), rounding}};
  if (packs == nullptr) return rules;
  constexpr ScalarKind scalar = scalar_kind<Scalar>;
  rules.sine_error = Real(sine_error(*packs, SineArithmetic::packs, scalar)) / rounding.roundoff;
  rules.domain = Real(exact_value(angle_reduction(scalar).domain));
  return rules;
}

/// The values of operands in the scalar of the instruction that reads them.
class StepOperands {
 public:
  StepOperands(const Function& function, const std::vector<ErrorValue>& values, bool is_inner)
      : function_(function), values_(values), is_inner_(is_inner) {}

  [[nodiscard]] ErrorValue operator[](std::uint32_t at) const {
    if (function_.instructions[at].is_inner == is_inner_) return values_[at];
    return is_inner_ ? rounded_to_float(values_[at]) : widened_to_double(values_[at]);
  }

 private:
  static const RoundingConstants<Real>& in_float() { return rounding_constants<float>(); }
  /// u of float in u of double.
  static Real ratio() { return in_float().roundoff / rounding_constants<double>().roundoff; }

  static ErrorValue widened_to_double(ErrorValue x) {
    x.error = x.error * ratio();
    return x;
  }

  static ErrorValue rounded_to_float(ErrorValue x) {
    const bool is_number = x.value.is_defined();
    const bool is_exact = is_number && is_zero(x.error) && in_float().is_exact(x.value.value());
    x.error = x.error / ratio() + (is_exact ? Real() : abs(x.value));
    if (!is_zero(x.value) && abs(x.value) < in_float().smallest) {
      x.error = x.error + in_float().underflow;
      x.underflows = true;
    }
    x.is_lost = x.is_lost || abs(x.value) > in_float().largest;
    return x;
  }

  const Function& function_;
  const std::vector<ErrorValue>& values_;
  bool is_inner_;
};

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

ExactRun run_mixed_exactly(const Program& program, const Function& function, const State& state,
                           const Numerics* packs) {
  ExactRun run;
  run.values = with_enough_digits([&] {
    const StepRules wide = step_rules<double>(state, packs);
    const StepRules narrow = step_rules<float>(state, packs);
    std::vector<ErrorValue> values;
    for (const Instruction& i : function.instructions) {
      values.push_back(fold_instruction(i.is_inner ? narrow : wide, program, i,
                                        StepOperands(function, values, i.is_inner)));
    }
    return values;
  });
  for (std::size_t i = 0; i < run.values.size(); ++i) {
    const bool is_inner = function.instructions[i].is_inner;
    const auto& rounding = is_inner ? rounding_constants<float>() : rounding_constants<double>();
    run.regime = worse_regime(run.regime, regime_of(run.values[i], rounding));
  }
  const StepOperands in_double(function, run.values, false);
  for (const std::uint32_t entry : entries_of(function)) run.entries.push_back(in_double[entry]);
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
