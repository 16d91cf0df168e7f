// Rates along the motion: de/dt = ∂e/∂q v + ∂e/∂v a + ∂e/∂t, by the chain rule on canonical sums.
#include <algorithm>
#include <array>

#include "base/function_slopes.hpp"
#include "elgen/model.hpp"
#include "forms/present/arithmetic.hpp"
#include "forms/present/polynomial.hpp"

namespace elgen {

using cln::cl_RA;

namespace {

/// A closed form with operators that use `arithmetic`, so that the table of derivatives
/// (function_derivatives.def) applies to closed forms.
struct ArithmeticValue {
  Arithmetic* arithmetic;
  OptionalFraction value;

  friend ArithmeticValue operator+(const ArithmeticValue& x, const ArithmeticValue& y) {
    return {x.arithmetic, x.arithmetic->add(x.value, y.value)};
  }
  friend ArithmeticValue operator-(const ArithmeticValue& x) {
    return {x.arithmetic, x.arithmetic->negate(x.value)};
  }
  friend ArithmeticValue operator-(const ArithmeticValue& x, const ArithmeticValue& y) {
    return x + (-y);
  }
  friend ArithmeticValue operator*(const ArithmeticValue& x, const ArithmeticValue& y) {
    return {x.arithmetic, x.arithmetic->multiply(x.value, y.value)};
  }
  friend ArithmeticValue operator*(const ArithmeticValue& x, int factor) {
    return {x.arithmetic, x.arithmetic->multiply(x.value, fraction_of(cl_RA(factor)))};
  }
  friend ArithmeticValue operator/(const ArithmeticValue& x, const ArithmeticValue& y) {
    return {x.arithmetic, x.arithmetic->divide(x.value, y.value)};
  }
};

ArithmeticValue sqrt(const ArithmeticValue& x) {
  return {x.arithmetic, x.arithmetic->square_root(x.value)};
}

ArithmeticValue called(FunctionId function, const ArithmeticValue& x, const ArithmeticValue& y) {
  const bool is_binary = function_row(function).arity == 2;
  return {x.arithmetic,
          x.arithmetic->call(function, x.value, is_binary ? y.value : OptionalFraction())};
}

/// The derivatives of `atom`, an opaque function, with respect to each argument. `call`: `atom` as
/// a fraction. A derivative is none if the budget is used up or the function has kinks.
///
///     tanh(x) -> 1 - tanh(x)^2      atan2(x, y) -> y/(x^2 + y^2), -x/(x^2 + y^2)
std::vector<OptionalFraction> call_derivatives(Arithmetic& arithmetic, const Atom& atom,
                                               const Fraction& call) {
  std::vector<OptionalFraction> result(atom.arguments.size());
  if (is_kinked(atom.function)) return result;
  const ArithmeticValue x{&arithmetic, atom.arguments.front()};
  const ArithmeticValue y{&arithmetic, atom.arguments.back()};
  const ArithmeticValue one{&arithmetic, fraction_of(cl_RA(1))};
  const auto all = function_slopes(atom.function, x, y, {&arithmetic, call}, one);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = all[i].value;
  return result;
}

bool is_input(const Atom& atom) {
  return atom.kind == AtomKind::leaf && atom.leaf == Opcode::input;
}

class TimeDifferentiator {
 public:
  TimeDifferentiator(Arithmetic& arithmetic, const Algebra& algebra, const LeafRates& motion)
      : arithmetic_(arithmetic), algebra_(algebra), motion_(motion) {}

  OptionalFraction differentiate(const Fraction& x) {
    OptionalFraction result = arithmetic_.multiply(of(x.numerator), reciprocal_denominator(x));
    // (1/d^k)' = -k d'/d^(k+1)
    for (const auto& [factor, exponent] : x.denominator) {
      const Polynomial shown = algebra_.factors[factor].shown;
      const OptionalFraction relative = arithmetic_.divide(of(shown), fraction_of(shown));
      const OptionalFraction term = arithmetic_.multiply(fraction_of(cl_RA(-exponent)), relative);
      result = arithmetic_.add(result, arithmetic_.multiply(term, x));
    }
    return result;
  }

 private:
  static Fraction reciprocal_denominator(const Fraction& x) {
    return {constant_polynomial(1), x.denominator};
  }

  OptionalFraction of(const Polynomial& sum) {
    OptionalFraction result = Fraction{};
    for (const auto& [monomial, coefficient] : sum) {
      for (const AtomPower& power : monomial) {
        const OptionalFraction own = atom_rate(power.atom);
        if (!own) return std::nullopt;
        if (own->numerator.empty()) continue;
        // n x^(n-1) x'
        const GaussianRational factor = elgen::product(coefficient, {power.exponent, 0});
        const Monomial lowered = elgen::product(monomial, {{power.atom, -1}});
        const Fraction slope = fraction_of(Polynomial{{lowered, factor}});
        result = arithmetic_.add(result, arithmetic_.multiply(slope, own));
      }
    }
    return result;
  }

  OptionalFraction atom_rate(AtomId id) {
    if (const auto known = known_.find(id); known != known_.end()) return known->second;
    const Atom atom = algebra_.atoms[id];  // a copy, because atoms may be added
    const OptionalFraction rate =
        new_atom_rate(atom, fraction_of(Polynomial{{Monomial{{id, 1}}, GaussianRational{1, 0}}}));
    known_[id] = rate;
    return rate;
  }

  OptionalFraction new_atom_rate(const Atom& atom, const Fraction& atom_form) {
    switch (atom.kind) {
      case AtomKind::leaf:
        return leaf_rate(atom);
      case AtomKind::pi:
        return Fraction{};
      case AtomKind::circular: {
        const GaussianRational i{0, 1 / atom.divisor};
        const Fraction slope{elgen::multiply_by_term(atom_form.numerator, i), {}};
        return arithmetic_.multiply(slope, differentiate(atom.arguments[0]));
      }
      case AtomKind::root: {
        const OptionalFraction twice = arithmetic_.multiply(fraction_of(cl_RA(2)), atom_form);
        return arithmetic_.divide(differentiate(atom.arguments[0]), twice);
      }
      case AtomKind::unexpanded_sum:
        return differentiate(atom.arguments[0]);
      case AtomKind::call:
        return call_rate(atom, atom_form);
    }
    return std::nullopt;
  }

  /// df(x, y)/dt = df/dx x' + df/dy y'. Constant arguments are skipped, so a function with a kink
  /// has the rate 0 if its arguments are constant.
  OptionalFraction call_rate(const Atom& atom, const Fraction& itself) {
    std::vector<OptionalFraction> slopes;
    OptionalFraction result = Fraction{};
    for (std::size_t i = 0; i < atom.arguments.size(); ++i) {
      const OptionalFraction own = differentiate(atom.arguments[i]);
      if (own && own->numerator.empty()) continue;
      if (slopes.empty()) slopes = call_derivatives(arithmetic_, atom, itself);
      result = arithmetic_.add(result, arithmetic_.multiply(slopes[i], own));
    }
    return result;
  }

  OptionalFraction leaf_rate(const Atom& atom) {
    const auto given = [&atom](const std::vector<Fraction>& rates) -> OptionalFraction {
      return atom.index < rates.size() ? OptionalFraction(rates[atom.index]) : std::nullopt;
    };
    if (atom.leaf == Opcode::parameter) return Fraction{};
    if (atom.leaf == Opcode::time) return motion_.time;
    if (atom.leaf == Opcode::open_value) return open_value_rate(atom.index);
    if (atom.leaf == Opcode::velocity) return given(motion_.velocities);
    if (atom.leaf == Opcode::acceleration) return given(motion_.accelerations);
    if (atom.leaf != Opcode::coordinate) return std::nullopt;
    if (OptionalFraction rate = given(motion_.coordinates)) return rate;
    return arithmetic_.leaf(Opcode::velocity, atom.index);
  }

  OptionalFraction open_value_rate(std::uint32_t index) {
    if (index >= motion_.open_values.size() || motion_.open_values[index].empty()) {
      return std::nullopt;
    }
    OptionalFraction result = Fraction{};
    for (const OpenValueRateTerm& term : motion_.open_values[index]) {
      const OptionalFraction slope = arithmetic_.leaf(Opcode::open_value, term.derivative);
      result = arithmetic_.add(result, arithmetic_.multiply(slope, differentiate(term.argument)));
    }
    return result;
  }

  Arithmetic& arithmetic_;
  const Algebra& algebra_;
  const LeafRates& motion_;
  std::map<AtomId, OptionalFraction> known_;
};

/// The rate of one component of the quaternion e: de/dt = 1/2 e (0, w), with angular velocity w.
OptionalFraction quaternion_rate(Arithmetic& arithmetic, const Rotation& rotation,
                                 std::uint32_t coordinate) {
  struct Product {
    std::uint32_t component;
    std::uint32_t axis;
    int sign;
  };
  static constexpr std::array<std::array<Product, axis_count>, quaternion_size> rows{
      {{{{1, 0, -1}, {2, 1, -1}, {3, 2, -1}}},
       {{{0, 0, 1}, {2, 2, 1}, {3, 1, -1}}},
       {{{0, 1, 1}, {3, 0, 1}, {1, 2, -1}}},
       {{{0, 2, 1}, {1, 1, 1}, {2, 0, -1}}}}};
  OptionalFraction sum = Fraction{};
  for (const auto& [component, axis, sign] : rows[coordinate - rotation.first_coordinate]) {
    const OptionalFraction e =
        arithmetic.leaf(Opcode::coordinate, rotation.first_coordinate + component);
    const OptionalFraction w = arithmetic.leaf(Opcode::velocity, rotation.first_velocity + axis);
    const OptionalFraction half = fraction_of(cl_RA(sign) / 2);
    sum = arithmetic.add(sum, arithmetic.multiply(half, arithmetic.multiply(e, w)));
  }
  return sum;
}

/// x at u = 0; none if a denominator contains an input.
OptionalFraction without_inputs(const Algebra& algebra, const Fraction& x) {
  const auto has_input = [&](const auto& term) {
    return std::any_of(term.first.begin(), term.first.end(),
                       [&](const AtomPower& power) { return is_input(algebra.atoms[power.atom]); });
  };
  for (const auto& [factor, exponent] : x.denominator) {
    const Polynomial& shown = algebra.factors[factor].shown;
    if (std::any_of(shown.begin(), shown.end(), has_input)) return std::nullopt;
  }
  Fraction result{{}, x.denominator};
  for (const auto& term : x.numerator) {
    if (!has_input(term)) result.numerator.try_emplace(term.first, term.second);
  }
  return result;
}

}  // namespace

std::vector<Fraction> coordinate_rates(ClosedForms& forms, const Model& model) {
  std::vector<Fraction> rates;
  if (model.rotations.empty()) return rates;
  Arithmetic arithmetic(forms.algebra);
  for (std::uint32_t i = 0; i < model.coordinates.size(); ++i) {
    const Coordinate& coordinate = model.coordinates[i];
    const OptionalFraction rate =
        coordinate.rotation ? quaternion_rate(arithmetic, model.rotations[*coordinate.rotation], i)
                            : arithmetic.leaf(Opcode::velocity, coordinate.velocity);
    rates.push_back(rate.value());  // a few products never exceed the budget
  }
  return rates;
}

std::optional<Fraction> directional_derivative(ClosedForms& forms, const Fraction& x,
                                               const LeafRates& rates) {
  Arithmetic arithmetic(forms.algebra);
  return TimeDifferentiator(arithmetic, forms.algebra, rates).differentiate(x);
}

std::optional<Fraction> partial_derivative(ClosedForms& forms, const Fraction& x,
                                           std::uint32_t coordinate, std::size_t coordinates) {
  LeafRates alone{std::vector<Fraction>(coordinates)};
  alone.coordinates[coordinate] = fraction_of(cl_RA(1));
  return directional_derivative(forms, x, alone);
}

OptionalFraction unforced_rate(ClosedForms& forms, const Fraction& x,
                               const std::vector<Fraction>& accelerations,
                               const std::vector<Fraction>& coordinate_rates,
                               const OpenValueRates& open_values) {
  LeafRates free_motion{coordinate_rates, {}, {}, open_values, fraction_of(cl_RA(1))};
  for (const Fraction& acceleration : accelerations) {
    OptionalFraction free = without_inputs(forms.algebra, acceleration);
    if (!free) return std::nullopt;
    free_motion.velocities.push_back(std::move(*free));
  }
  return directional_derivative(forms, x, free_motion);
}

}  // namespace elgen
