// Integrates the coefficient of each v_k with respect to q_k and subtracts the integral's rate.
// The remaining rate contains no v_k and is integrated with respect to t.
#include "analyse/total_integral.hpp"

#include "analyse/formulas.hpp"
#include "forms/present/arithmetic.hpp"
#include "forms/present/polynomial.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

OptionalFraction monomial_form(const Monomial& monomial,
                               const GaussianRational& coefficient = {1, 0}) {
  return fraction_of(Polynomial{{monomial, coefficient}});
}

/// Rates of 0 for all leaves.
LeafRates zero_rates(const Model& model) {
  const std::vector<Fraction> velocities(model.velocities.size());
  const std::vector<OpenValueRateTerm> constant_value{{0, {}}};
  return {std::vector<Fraction>(model.coordinates.size()),
          velocities,
          velocities,
          OpenValueRates(model.open_values.size(), constant_value),
          {}};
}

/// Integrals with respect to one leaf.
class LeafIntegrator {
 public:
  LeafIntegrator(ClosedForms& forms, const Model& model, Opcode kind, std::uint32_t index)
      : forms_(forms),
        arithmetic_(forms.algebra),
        search_(forms.algebra,
                [=](const Atom& leaf) { return leaf.leaf == kind && leaf.index == index; }),
        leaf_(*arithmetic_.leaf(kind, index)),
        unit_(zero_rates(model)) {
    const Fraction one = fraction_of(cl_RA(1));
    (kind == Opcode::time ? unit_.time : unit_.coordinates[index]) = one;
  }

  OptionalFraction integrate(const Fraction& x) {
    for (const auto& [factor, exponent] : x.denominator) {
      if (search_.contains(forms_.algebra.factors[factor].shown)) return std::nullopt;
    }
    OptionalFraction sum = Fraction{};
    for (const auto& [monomial, coefficient] : x.numerator) {
      sum = arithmetic_.add(sum, integrate_term(monomial, coefficient));
    }
    return arithmetic_.multiply(sum, Fraction{constant_polynomial(1), x.denominator});
  }

 private:
  /// The integral of x^n e^(r x): e^(r x) sum_k (-1)^k n!/(n-k)! x^(n-k)/r^(k+1), or
  /// x^(n+1)/(n+1) if r = 0. None for x^-1, for other functions of x, and for n < 0 with r != 0.
  OptionalFraction integrate_term(const Monomial& monomial, const GaussianRational& coefficient) {
    const AtomId own = leaf_.numerator.begin()->first[0].atom;
    std::int32_t n = 0;
    Monomial rest;
    OptionalFraction growth = Fraction{};
    OptionalFraction turn = Fraction{};
    for (const AtomPower& power : monomial) {
      if (power.atom == own) {
        n = power.exponent;
        continue;
      }
      rest.push_back(power);
      if (!search_.contains(power.atom)) continue;
      OptionalFraction& rate =
          forms_.algebra.atoms[power.atom].kind == AtomKind::call ? growth : turn;
      rate = arithmetic_.add(rate, exponential_rate(power));
    }
    const OptionalFraction factor = monomial_form(rest, coefficient);
    if (!growth || !turn) return std::nullopt;
    if (growth->numerator.empty() && turn->numerator.empty()) {
      if (n == -1) return std::nullopt;
      const OptionalFraction power = monomial_form({{own, n + 1}}, {cl_RA(1) / (n + 1), 0});
      return arithmetic_.multiply(factor, power);
    }
    if (n < 0) return std::nullopt;
    OptionalFraction sum = Fraction{};
    const OptionalFraction inverse = inverse_rate(growth, turn);
    OptionalFraction over = inverse;
    cl_RA weight = 1;
    for (std::int32_t k = 0; k <= n; ++k) {
      const OptionalFraction power =
          k == n ? fraction_of(weight) : monomial_form({{own, n - k}}, {weight, 0});
      sum = arithmetic_.add(sum, arithmetic_.multiply(power, over));
      over = arithmetic_.multiply(over, inverse);
      weight = -weight * (n - k);
    }
    return arithmetic_.multiply(factor, sum);
  }

  /// 1/(a + i b) with a real denominator, so that forms can be printed.
  OptionalFraction inverse_rate(const OptionalFraction& a, const OptionalFraction& b) {
    const OptionalFraction turned = arithmetic_.multiply(monomial_form({}, {0, -1}), b);
    if (a->numerator.empty()) return arithmetic_.divide(monomial_form({}, {0, -1}), b);
    if (b->numerator.empty()) return arithmetic_.divide(monomial_form({}), a);
    const OptionalFraction square =
        arithmetic_.add(arithmetic_.multiply(a, a), arithmetic_.multiply(b, b));
    return arithmetic_.divide(arithmetic_.add(a, turned), square);
  }

  /// The rate k a of exp(a x)^k, or k b of (e^(i b x))^k; none for other functions of x.
  OptionalFraction exponential_rate(const AtomPower& power) {
    const Atom atom = forms_.algebra.atoms[power.atom];  // a copy, as atoms may be added
    const bool is_real = atom.kind == AtomKind::call && atom.function == FunctionId::exp;
    if (!is_real && atom.kind != AtomKind::circular) return std::nullopt;
    const OptionalFraction slope = directional_derivative(forms_, atom.arguments[0], unit_);
    if (!slope || search_.contains(*slope)) return std::nullopt;
    const cl_RA share = power.exponent / atom.divisor;
    return arithmetic_.multiply(fraction_of(is_real ? cl_RA(power.exponent) : share), slope);
  }

  ClosedForms& forms_;
  Arithmetic arithmetic_;
  LeafSearch search_;
  Fraction leaf_;
  LeafRates unit_;
};

/// The coefficient of v_k in a form linear in the velocities.
OptionalFraction coefficient_of(ClosedForms& forms, const Model& model, const Fraction& form,
                                std::uint32_t velocity) {
  LeafRates unit = zero_rates(model);
  unit.velocities[velocity] = fraction_of(cl_RA(1));
  return directional_derivative(forms, form, unit);
}

}  // namespace

std::optional<Fraction> integrate_total_derivative(ClosedForms& forms, const Model& model,
                                                   const std::vector<Fraction>& rates,
                                                   const OpenValueRates& open_values,
                                                   const Fraction& rate) {
  Arithmetic arithmetic(forms.algebra);
  const LeafRates motion{rates, {}, {}, open_values, fraction_of(cl_RA(1))};
  OptionalFraction rest = rate;
  OptionalFraction total = Fraction{};
  const auto integrate_part = [&](const OptionalFraction& slope, Opcode kind, std::uint32_t index) {
    if (!slope) return false;
    if (slope->numerator.empty()) return true;
    const OptionalFraction part = LeafIntegrator(forms, model, kind, index).integrate(*slope);
    if (!part) return false;
    total = arithmetic.add(total, part);
    rest = arithmetic.subtract(rest, directional_derivative(forms, *part, motion));
    return total && rest;
  };
  for (std::uint32_t i = 0; i < model.coordinates.size() && !rest->numerator.empty(); ++i) {
    if (model.coordinates[i].rotation) continue;
    const OptionalFraction slope =
        coefficient_of(forms, model, *rest, model.coordinates[i].velocity);
    if (!integrate_part(slope, Opcode::coordinate, i)) return std::nullopt;
  }
  if (!rest->numerator.empty() && !integrate_part(rest, Opcode::time, 0)) return std::nullopt;
  if (!rest->numerator.empty()) return std::nullopt;
  return total;
}

}  // namespace elgen
