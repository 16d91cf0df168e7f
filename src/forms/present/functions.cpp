// Functions of closed forms. Sines and cosines become exponentials of the terms of their angle. A
// root of a number becomes a product of roots of primes. Any other call is an opaque atom with
// canonical arguments.
#include <cln/integer.h>

#include <array>

#include "forms/present/arithmetic.hpp"
#include "forms/present/polynomial.hpp"
#include "numbers/enclosed_number.hpp"

namespace elgen {

using cln::cl_I;
using cln::cl_RA;

namespace {

/// Larger prime factors are not searched: their product remains under one root.
constexpr int largest_prime = 10'000;

/// Larger exponents of exponentials could overflow when powers are multiplied.
constexpr int largest_exponent = 1'000'000;

bool is_pi(const Algebra& algebra, const Monomial& monomial) {
  return monomial.size() == 1 && monomial[0].exponent == 1 &&
         algebra.atoms[monomial[0].atom].kind == AtomKind::pi;
}

std::optional<cl_RA> rational_number(const Fraction& x) {
  return x.denominator.empty() ? rational_value(x.numerator) : std::nullopt;
}

/// True if the leading coefficient a + i b has a < 0, or has a = 0 and b < 0.
bool has_negative_lead(const Fraction& x) {
  if (x.numerator.empty()) return false;
  const GaussianRational& lead = x.numerator.rbegin()->second;
  return cln::zerop(lead.real) ? cln::minusp(lead.imaginary) : cln::minusp(lead.real);
}

}  // namespace

/// sqrt of a positive integer: square factors are extracted, and each prime gets its own root.
OptionalFraction Arithmetic::root_of_integer(cl_I value) {
  cl_RA outside = 1;
  std::vector<cl_I> primes;
  for (cl_I p = 2; p <= largest_prime && p * p <= value; p = p + 1) {
    while (cln::zerop(cln::mod(value, p * p))) {
      outside = outside * p;
      value = cln::exquo(value, p * p);
    }
    if (cln::zerop(cln::mod(value, p))) {
      primes.push_back(p);
      value = cln::exquo(value, p);
    }
  }
  cl_I root;
  if (cln::sqrtp(value, &root)) {
    outside = outside * root;
  } else {
    primes.push_back(value);
  }
  OptionalFraction result = fraction_of(outside);
  for (const cl_I& prime : primes) {
    result = multiply(
        result, intern_atom({.kind = AtomKind::root, .arguments = {fraction_of(cl_RA(prime))}}));
  }
  return result;
}

OptionalFraction Arithmetic::square_root(const OptionalFraction& x) {
  if (!x) return std::nullopt;
  const auto number = x->denominator.empty() ? rational_value(x->numerator) : std::nullopt;
  if (!number) return intern_atom({.kind = AtomKind::root, .arguments = {*x}});
  if (cln::minusp(*number)) return std::nullopt;
  if (cln::zerop(*number)) return x;
  const cl_I denominator = cln::denominator(*number);
  return multiply(root_of_integer(cln::numerator(*number) * denominator),
                  fraction_of(cl_RA(1) / denominator));
}

/// cos(k pi/12) + i sin(k pi/12) for k = twelfths, in terms of sqrt(2) and sqrt(3).
OptionalFraction Arithmetic::root_of_unity(long twelfths) {
  // cos(k pi/12) = (a + b sqrt2 + c sqrt3 + d sqrt6)/4 for k = 0 … 6
  static constexpr std::array<std::array<int, 4>, 7> cosines{
      {{4, 0, 0, 0}, {0, 1, 0, 1}, {0, 0, 2, 0}, {0, 2, 0, 0}, {2, 0, 0, 0}, {0, -1, 0, 1}, {}}};
  const OptionalFraction root2 = root_of_integer(2);
  const OptionalFraction root3 = root_of_integer(3);
  const std::array<OptionalFraction, 4> basis{fraction_of(cl_RA(1)), root2, root3,
                                              multiply(root2, root3)};
  const auto cosine = [&](long k) {
    k = ((k % 24) + 24) % 24;
    if (k > 12) k = 24 - k;
    const int sign = k > 6 ? -1 : 1;
    const auto& row = cosines[static_cast<std::size_t>(k > 6 ? 12 - k : k)];
    OptionalFraction value = Fraction{};
    for (std::size_t i = 0; i < basis.size(); ++i) {
      const OptionalFraction weight = fraction_of(cl_RA(sign * row[i]) / 4);
      value = add(value, multiply(weight, basis[i]));
    }
    return value;
  };
  const OptionalFraction real = cosine(twelfths);
  const OptionalFraction imaginary = cosine(twelfths - 6);
  return add(real,
             multiply(imaginary, fraction_of(Polynomial{{Monomial{}, GaussianRational{0, 1}}})));
}

/// e^(i coefficient monomial)
OptionalFraction Arithmetic::exponential_of_term(const Monomial& monomial,
                                                 const cl_RA& coefficient) {
  const cl_RA twelfths = coefficient * units_per_angle;
  const cl_I divisor = cln::denominator(twelfths);
  const cl_I exponent = cln::numerator(twelfths);
  if (cln::abs(exponent) > largest_exponent) return std::nullopt;
  const long power = cln::cl_I_to_long(exponent);
  if (is_pi(algebra_, monomial) && divisor == 1) return root_of_unity(power);
  const Fraction unit =
      intern_atom({.kind = AtomKind::circular,
                   .divisor = cl_RA(divisor) * units_per_angle,
                   .arguments = {fraction_of(Polynomial{{monomial, GaussianRational{1, 0}}})}});
  const Monomial base = unit.numerator.begin()->first;
  return fraction_of(
      Polynomial{{elgen::power(base, static_cast<std::int32_t>(power)), GaussianRational{1, 0}}});
}

/// e^(i x), or e^(-i x) if `conjugate`: the product over the terms of x, which must be a sum of
/// real monomials.
OptionalFraction Arithmetic::exponential(const Fraction& x, bool conjugate) {
  OptionalFraction result = fraction_of(cl_RA(1));
  for (const auto& [monomial, coefficient] : x.numerator) {
    const cl_RA signed_part = conjugate ? -coefficient.real : coefficient.real;
    result = multiply(result, exponential_of_term(monomial, signed_part));
  }
  return result;
}

OptionalFraction Arithmetic::sine_or_cosine(FunctionId function, const Fraction& x) {
  const bool is_sum_of_monomials =
      x.denominator.empty() && !contains_exponentials(algebra_, x.numerator);
  OptionalFraction forward;
  OptionalFraction backward;
  if (is_sum_of_monomials) {
    forward = exponential(x, false);
    backward = exponential(x, true);
  } else {
    const bool is_negated = has_negative_lead(x);
    const OptionalFraction angle = is_negated ? negate(x) : OptionalFraction(x);
    const Fraction unit = intern_atom({.kind = AtomKind::circular, .arguments = {*angle}});
    forward = power(unit, is_negated ? -1 : 1);
    backward = power(unit, is_negated ? 1 : -1);
  }
  const bool is_sine = function == FunctionId::sin;
  const GaussianRational half =
      is_sine ? GaussianRational{0, cl_RA(-1) / 2} : GaussianRational{cl_RA(1) / 2, 0};
  const OptionalFraction both = add(forward, is_sine ? negate(backward) : backward);
  return multiply(both, fraction_of(Polynomial{{Monomial{}, half}}));
}

/// stumpff(x, k) as a quotient; none at x = 0 if k > 0:
///
///     k = 0    cos(x)
///     k = 1    sin(x)/x
///     k = 2    (1 - cos(x))/x^2
///     k > 2    (1/(k - 2)! - stumpff(x, k - 2))/x^2
OptionalFraction Arithmetic::stumpff_quotient(const Fraction& x, const cl_I& order) {
  if (order == 0) return sine_or_cosine(FunctionId::cos, x);
  if (order == 1) return divide(sine_or_cosine(FunctionId::sin, x), x);
  const auto below = static_cast<unsigned>(cln::cl_I_to_ulong(order - 2));
  const Fraction first = fraction_of(cln::recip(cl_RA(cln::factorial(below))));
  return divide(subtract(first, stumpff_quotient(x, order - 2)), multiply(x, x));
}

/// e^x as a product over the terms of x. Each factor is a power of e^(m/12) or e^(i m/12), with m a
/// monomial over the denominator of x. If x contains sines, the factors are complex, but their
/// product is e^x.
OptionalFraction Arithmetic::real_exponential(const Fraction& x) {
  Monomial result;
  const auto multiply_by = [&](const Monomial& monomial, const cl_RA& coefficient,
                               const GaussianRational& unit) {
    const cl_RA parts = coefficient * units_per_angle;
    const cl_I exponent = cln::numerator(parts);
    if (cln::abs(exponent) > largest_exponent) return false;
    if (cln::zerop(exponent)) return true;
    const GaussianRational part =
        elgen::product(unit, {1 / cl_RA(cln::denominator(parts) * units_per_angle), 0});
    const Fraction base =
        intern_atom({.kind = AtomKind::call,
                     .function = FunctionId::exp,
                     .arguments = {Fraction{Polynomial{{monomial, part}}, x.denominator}}});
    const auto power = static_cast<std::int32_t>(cln::cl_I_to_long(exponent));
    result = elgen::product(result, elgen::power(base.numerator.begin()->first, power));
    return true;
  };
  for (const auto& [monomial, coefficient] : x.numerator) {
    if (!multiply_by(monomial, coefficient.real, {1, 0})) return std::nullopt;
    if (!multiply_by(monomial, coefficient.imaginary, {0, 1})) return std::nullopt;
  }
  return fraction_of(Polynomial{{result, GaussianRational{1, 0}}});
}

/// exp, sinh, cosh and tanh in terms of e^x and e^-x.
OptionalFraction Arithmetic::expand_in_exponentials(FunctionId function, const Fraction& x) {
  const OptionalFraction forward = real_exponential(x);
  if (function == FunctionId::exp) return forward;
  const OptionalFraction backward = power(forward, -1);
  const OptionalFraction half = fraction_of(cl_RA(1) / 2);
  const OptionalFraction sine = multiply(half, subtract(forward, backward));
  const OptionalFraction cosine = multiply(half, add(forward, backward));
  if (function == FunctionId::tanh) return divide(sine, cosine);
  return function == FunctionId::sinh ? sine : cosine;
}

/// The value of `function` at (x, y); log1p, expm1 and hypot are replaced by log, exp and a root.
OptionalFraction Arithmetic::call(FunctionId function, const OptionalFraction& x,
                                  const OptionalFraction& y) {
  const FunctionRow& row = function_row(function);
  if (!x || (row.arity > 1 && !y)) return std::nullopt;
  const Fraction one = fraction_of(cl_RA(1));
  const auto first = rational_number(*x);
  const auto last = row.arity > 1 ? rational_number(*y) : first;
  const auto known = first && last ? exact_function_value(function, *first, *last) : std::nullopt;
  if (known) return fraction_of(*known);
  const bool is_quotient = algebra_.has_quotients && function == FunctionId::stumpff;
  if (is_quotient && last && cln::plusp(*last)) return stumpff_quotient(*x, cln::numerator(*last));
  if (is_circular(function)) return sine_or_cosine(function, *x);
  if (algebra_.has_exponentials && has_exponential_form(function))
    return expand_in_exponentials(function, *x);
  if (function == FunctionId::tan) {
    const OptionalFraction sine = sine_or_cosine(FunctionId::sin, *x);
    return divide(sine, sine_or_cosine(FunctionId::cos, *x));
  }
  if (function == FunctionId::log1p) return call(FunctionId::log, add(one, x), {});
  if (function == FunctionId::expm1) return subtract(call(FunctionId::exp, x, {}), one);
  if (function == FunctionId::hypot) return square_root(add(multiply(x, x), multiply(y, y)));
  std::vector<Fraction> values{*x};
  if (row.arity > 1) values.push_back(*y);
  bool turned = false;
  if (row.parity != Parity::none && has_negative_lead(values[0])) {
    values[0] = *negate(values[0]);
    turned = row.parity == Parity::odd;
  }
  const OptionalFraction value =
      intern_atom({.kind = AtomKind::call, .function = function, .arguments = std::move(values)});
  return turned ? negate(value) : value;
}

OptionalFraction Arithmetic::pi() { return intern_atom({.kind = AtomKind::pi}); }

OptionalFraction Arithmetic::constant(const ConstantForm& form) {
  std::vector<OptionalFraction> operands;
  for (const ConstantOperand& part : form.operands) {
    const OptionalFraction value = constant(part.form);
    const bool is_factor = form.kind == ConstantKind::product;
    operands.push_back(is_factor         ? power(value, part.weight)
                       : part.weight < 0 ? negate(value)
                                         : value);
  }
  switch (form.kind) {
    case ConstantKind::rational:
      return fraction_of(form.number);
    case ConstantKind::pi:
      return pi();
    case ConstantKind::square_root:
      return square_root(operands.front());
    case ConstantKind::call:
      return call(form.function, operands.front(), operands.back());
    case ConstantKind::sum: {
      OptionalFraction total = Fraction{};
      for (const OptionalFraction& term : operands) total = add(total, term);
      return total;
    }
    case ConstantKind::product: {
      OptionalFraction total = fraction_of(cl_RA(1));
      for (const OptionalFraction& factor : operands) total = multiply(total, factor);
      return total;
    }
  }
  return std::nullopt;
}

}  // namespace elgen
