// Field operations on fractions. A denominator is a product of powers of Algebra::factors, to which
// each division may add a factor. A later multiplication cancels these factors by exact division,
// so no general gcd is needed.
#include "forms/present/arithmetic.hpp"

#include <algorithm>

#include "forms/present/polynomial.hpp"

namespace elgen {

using cln::cl_RA;

Fraction fraction_of(const Polynomial& numerator) { return {numerator, {}}; }
Fraction fraction_of(const cl_RA& value) { return {constant_polynomial(value), {}}; }

namespace {

/// Equal atoms have equal hashes. Of an argument, only the monomials of the numerator are hashed.
std::size_t hash_of(const Atom& atom) {
  std::size_t hash = 0;
  const auto mix = [&hash](std::size_t part) { hash = hash * 1'000'003 + part; };
  mix(static_cast<std::size_t>(atom.kind));
  mix(static_cast<std::size_t>(atom.leaf));
  mix(atom.index);
  mix(static_cast<std::size_t>(atom.function));
  for (const Fraction& argument : atom.arguments) {
    for (const auto& [monomial, coefficient] : argument.numerator) {
      for (const AtomPower& power : monomial) {
        mix(power.atom);
        mix(static_cast<std::size_t>(power.exponent));
      }
    }
  }
  return hash;
}

/// The angles of the exponentials in x, but only angles with a positive first exponent. If all
/// exponents of an angle are even, the half of this angle precedes the angle.
std::vector<Monomial> angles_of(const Polynomial& x, const Algebra& algebra) {
  std::vector<Monomial> angles;
  const auto add = [&](const Monomial& angle) {
    if (std::find(angles.begin(), angles.end(), angle) == angles.end()) angles.push_back(angle);
  };
  for (const auto& [monomial, coefficient] : x) {
    const Monomial angle = split_monomial(algebra, monomial).angle;
    if (angle.empty() || angle.front().exponent < 0) continue;
    if (const auto half = square_root(angle)) add(*half);
    add(angle);
  }
  return angles;
}

}  // namespace

Fraction Arithmetic::intern_atom(Atom wanted) {
  const auto [first, last] = algebra_.atoms_by_hash.equal_range(hash_of(wanted));
  const auto found = std::find_if(
      first, last, [&](const auto& known) { return algebra_.atoms[known.second] == wanted; });
  const auto id = found == last ? static_cast<AtomId>(algebra_.atoms.size()) : found->second;
  if (found == last) {
    algebra_.atoms_by_hash.emplace(hash_of(wanted), id);
    algebra_.atoms.push_back(std::move(wanted));
  }
  return fraction_of(Polynomial{{Monomial{{id, 1}}, GaussianRational{1, 0}}});
}

OptionalFraction Arithmetic::leaf(Opcode leaf, std::uint32_t index) {
  return intern_atom({.kind = AtomKind::leaf, .leaf = leaf, .index = index});
}

OptionalFraction Arithmetic::unexpanded_sum(std::uint32_t index, const Fraction& form) {
  return intern_atom({.kind = AtomKind::unexpanded_sum, .index = index, .arguments = {form}});
}

OptionalFraction Arithmetic::check_term_limit(Fraction x) const {
  if (x.numerator.size() > most_terms_) return std::nullopt;
  return x;
}

std::optional<Polynomial> Arithmetic::multiply_sums(const Polynomial& x, const Polynomial& y) {
  const std::size_t products = x.size() * y.size();
  if (products > remaining_products_) {
    remaining_products_ = 0;
    return std::nullopt;
  }
  remaining_products_ -= products;
  return product(x, y);
}

/// x * factors[factor]^exponent; none if the budget is used up.
std::optional<Polynomial> Arithmetic::multiply_by_factor(Polynomial x, std::uint32_t factor,
                                                         std::int32_t exponent) {
  for (std::int32_t i = 0; i < exponent; ++i) {
    auto next = multiply_sums(x, algebra_.factors[factor].shown);
    if (!next) return std::nullopt;
    x = std::move(*next);
  }
  return x;
}

/// The numerator of x over `denominator`, which must be a multiple of x's own denominator.
std::optional<Polynomial> Arithmetic::expand_numerator(
    const Fraction& x, const std::map<std::uint32_t, std::int32_t>& denominator) {
  std::optional<Polynomial> result = x.numerator;
  for (const auto& [factor, exponent] : denominator) {
    const auto own = x.denominator.find(factor);
    const std::int32_t missing = exponent - (own == x.denominator.end() ? 0 : own->second);
    if (result) result = multiply_by_factor(std::move(*result), factor, missing);
  }
  return result;
}

OptionalFraction Arithmetic::add(const OptionalFraction& x, const OptionalFraction& y) {
  if (!x || !y) return std::nullopt;
  if (x->denominator == y->denominator) {
    Fraction result{sum(x->numerator, y->numerator), x->denominator};
    return result.denominator.empty() ? check_term_limit(std::move(result))
                                      : cancel_factors(std::move(result));
  }
  std::map<std::uint32_t, std::int32_t> common = x->denominator;
  for (const auto& [factor, exponent] : y->denominator) {
    common[factor] = std::max(common[factor], exponent);
  }
  const auto left = expand_numerator(*x, common);
  const auto right = expand_numerator(*y, common);
  if (!left || !right) return std::nullopt;
  return reduce_roots({sum(*left, *right), common});
}

OptionalFraction Arithmetic::negate(const OptionalFraction& x) const {
  if (!x) return std::nullopt;
  return Fraction{multiply_by_term(x->numerator, {-1, 0}), x->denominator};
}

OptionalFraction Arithmetic::multiply(const OptionalFraction& x, const OptionalFraction& y) {
  if (!x || !y) return std::nullopt;
  auto numerator = multiply_sums(x->numerator, y->numerator);
  if (!numerator) return std::nullopt;
  Fraction result{std::move(*numerator), x->denominator};
  for (const auto& [factor, exponent] : y->denominator) result.denominator[factor] += exponent;
  return reduce_roots(std::move(result));
}

OptionalFraction Arithmetic::cancel_factors(Fraction x) {
  if (x.numerator.empty()) return Fraction{};
  cancel_common_factors(x, algebra_, remaining_products_);
  return check_term_limit(std::move(x));
}

/// Replaces sqrt(r)^k by sqrt(r)^(k mod 2) r^(k div 2).
OptionalFraction Arithmetic::reduce_roots(Fraction x) {
  const auto has_excess_exponent = [&](const AtomPower& factor) {
    return algebra_.atoms[factor.atom].kind == AtomKind::root &&
           (factor.exponent < 0 || factor.exponent > 1);
  };
  const auto is_reducible = [&](const auto& term) {
    return std::any_of(term.first.begin(), term.first.end(), has_excess_exponent);
  };
  if (std::none_of(x.numerator.begin(), x.numerator.end(), is_reducible)) {
    return cancel_factors(std::move(x));
  }
  OptionalFraction result = Fraction{};
  Fraction reduced;
  for (const auto& term : x.numerator) {
    if (!is_reducible(term)) {
      reduced.numerator.try_emplace(term.first, term.second);
      continue;
    }
    Monomial rest;
    OptionalFraction factor = fraction_of(cl_RA(1));
    for (AtomPower power : term.first) {
      if (has_excess_exponent(power)) {
        const std::int32_t odd = ((power.exponent % 2) + 2) % 2;
        const Fraction radicand = algebra_.atoms[power.atom].arguments[0];
        factor = multiply(factor, this->power(radicand, (power.exponent - odd) / 2));
        power.exponent = odd;
      }
      if (power.exponent != 0) rest.push_back(power);
    }
    const Fraction own{{{rest, term.second}}, {}};
    result = add(result, multiply(own, factor));
  }
  result = add(result, reduced);
  if (!result) return std::nullopt;
  for (const auto& [factor, exponent] : x.denominator) result->denominator[factor] += exponent;
  return cancel_factors(std::move(*result));
}

/// The index of the factor for which polynomial/factor is a single term; adds this factor if it is
/// missing. `unit` becomes polynomial/factor.
std::uint32_t Arithmetic::factor_index(const Polynomial& polynomial, Polynomial& unit) {
  const auto inverse = [](const Monomial& x) { return elgen::power(x, -1); };
  const Monomial powers = common_powers(polynomial);
  Polynomial normal = multiply_by_term(polynomial, {1, 0}, inverse(powers));
  normal = multiply_by_term(normal, elgen::reciprocal(normal.rbegin()->second));
  const auto known = std::ranges::find(algebra_.factors, normal, &Algebra::Factor::normal);
  const auto index = static_cast<std::uint32_t>(known - algebra_.factors.begin());
  if (known == algebra_.factors.end()) {
    // Exponentials remain in the sum, so that the printed factor is real.
    Monomial common = split_monomial(algebra_, powers).powers;
    erase_if(common, [](const AtomPower& power) { return power.exponent < 0; });
    algebra_.factors.push_back({multiply_by_term(polynomial, {1, 0}, inverse(common)), normal});
  }
  const Polynomial& shown = algebra_.factors[index].shown;
  unit =
      Polynomial{{product(polynomial.rbegin()->first, inverse(shown.rbegin()->first)),
                  product(polynomial.rbegin()->second, elgen::reciprocal(shown.rbegin()->second))}};
  return index;
}

/// Divides `rest` by every known factor that divides it, and counts these factors in `denominator`.
/// False if the budget is used up.
bool Arithmetic::split_factors(Polynomial& rest,
                               std::map<std::uint32_t, std::int32_t>& denominator) {
  for (std::uint32_t i = 0; i < algebra_.factors.size(); ++i) {
    while (rest.size() > 1) {
      auto divided = quotient(rest, algebra_.factors[i].shown, remaining_products_);
      if (!divided) break;
      rest = std::move(*divided);
      ++denominator[i];
    }
  }
  return remaining_products_ > 0;
}

/// Adds each sine and cosine that divides `rest` to the factors. For example, sin(x)
/// divides 1 - cos(2 x) = 2 sin(x)^2.
void Arithmetic::add_circular_factors(const Polynomial& rest) {
  const cl_RA half = cl_RA(1) / 2;
  for (const Monomial& angle : angles_of(rest, algebra_)) {
    const Monomial opposite = elgen::power(angle, -1);
    const Polynomial sine{{angle, GaussianRational{0, -half}},
                          {opposite, GaussianRational{0, half}}};
    const Polynomial cosine{{angle, GaussianRational{half, 0}},
                            {opposite, GaussianRational{half, 0}}};
    for (const Polynomial& factor : {sine, cosine}) {
      Polynomial unit;
      if (quotient(rest, factor, remaining_products_)) (void)factor_index(factor, unit);
    }
  }
}

OptionalFraction Arithmetic::reciprocal(const Fraction& x) {
  if (x.numerator.empty()) return std::nullopt;
  Fraction result = fraction_of(cl_RA(1));
  Polynomial rest = x.numerator;
  if (rest.size() > 1) add_circular_factors(rest);
  if (!split_factors(rest, result.denominator)) return std::nullopt;
  if (rest.size() > 1) {
    Polynomial unit;
    ++result.denominator[factor_index(rest, unit)];
    rest = std::move(unit);
  }
  const auto& [monomial, coefficient] = *rest.begin();
  result.numerator = Polynomial{{elgen::power(monomial, -1), elgen::reciprocal(coefficient)}};
  for (const auto& [factor, exponent] : x.denominator) {
    auto numerator = multiply_by_factor(std::move(result.numerator), factor, exponent);
    if (!numerator) return std::nullopt;
    result.numerator = std::move(*numerator);
  }
  return reduce_roots(std::move(result));
}

OptionalFraction Arithmetic::divide(const OptionalFraction& x, const OptionalFraction& y) {
  if (!x || !y) return std::nullopt;
  return multiply(x, reciprocal(*y));
}

OptionalFraction Arithmetic::power(const OptionalFraction& x, std::int32_t exponent) {
  if (!x) return std::nullopt;
  if (exponent < 0) return power(reciprocal(*x), -exponent);
  OptionalFraction result = fraction_of(cl_RA(1));
  for (std::int32_t i = 0; i < exponent; ++i) result = multiply(result, x);
  return result;
}

}  // namespace elgen
