// Polynomials in atoms, with exponents of either sign and exact coefficients x + i y.
#pragma once

#include "elgen/closed_forms.hpp"

namespace elgen {

[[nodiscard]] Monomial product(const Monomial& x, const Monomial& y);
[[nodiscard]] Monomial power(const Monomial& x, std::int32_t exponent);

[[nodiscard]] GaussianRational product(const GaussianRational& x, const GaussianRational& y);
/// 1/x; x must not be 0.
[[nodiscard]] GaussianRational reciprocal(const GaussianRational& x);
[[nodiscard]] bool is_zero(const GaussianRational& x);

/// to += coefficient * monomial, for a polynomial or another map of terms. The coefficient must not
/// be 0; a term whose coefficient becomes 0 is erased.
template <class Sum>
void add_term(Sum& to, const typename Sum::key_type& monomial,
              const GaussianRational& coefficient) {
  const auto [at, is_new] = to.try_emplace(monomial, coefficient);
  if (is_new) return;
  at->second.real = at->second.real + coefficient.real;
  at->second.imaginary = at->second.imaginary + coefficient.imaginary;
  if (is_zero(at->second)) to.erase(at);
}

[[nodiscard]] Polynomial constant_polynomial(const cln::cl_RA& value);
/// x + y. Cost: x.size() + y.size() comparisons of monomials.
[[nodiscard]] Polynomial sum(const Polynomial& x, const Polynomial& y);
/// x * coefficient * monomial
[[nodiscard]] Polynomial multiply_by_term(const Polynomial& x, const GaussianRational& coefficient,
                                          const Monomial& monomial = {});
/// x y. Cost: x.size() * y.size() products of terms.
[[nodiscard]] Polynomial product(const Polynomial& x, const Polynomial& y);

/// x / y if y divides x, by long division from the leading term; otherwise none. y must have at
/// least two terms, x at least one. Decreases `work` by the number of products of terms; the result
/// is also none if `work` is used up.
[[nodiscard]] std::optional<Polynomial> quotient(const Polynomial& x, const Polynomial& y,
                                                 std::size_t& work);

/// Cancels all denominator factors that divide the numerator; `work` as in quotient().
void cancel_common_factors(Fraction& x, const Algebra& algebra, std::size_t& work);

/// x/y if x/y is a rational number; otherwise none. Neither x nor y may be the empty sum.
[[nodiscard]] std::optional<cln::cl_RA> ratio_of(const Polynomial& x, const Polynomial& y);

/// The value of x if it is a rational number; otherwise none.
[[nodiscard]] std::optional<cln::cl_RA> rational_value(const Polynomial& x);

[[nodiscard]] bool is_one(const Polynomial& sum);

/// `sum` after cosh^2 = 1 + sinh^2 is applied in the direction that gives fewer terms, if any.
[[nodiscard]] Polynomial reduce_hyperbolic_squares(const Algebra& algebra, Polynomial sum);

/// The product whose square is x; none if an exponent is odd.
[[nodiscard]] std::optional<Monomial> square_root(Monomial x);

/// The sum whose square is x, by long division from the leading term, whose coefficient must be 1.
/// None if x is not a square.
[[nodiscard]] std::optional<Polynomial> square_root(const Polynomial& x);

/// The exponent of `atom` in `monomial`; 0 if `monomial` does not contain the atom.
[[nodiscard]] std::int32_t exponent_of(const Monomial& monomial, AtomId atom);

/// The coefficients of x as a polynomial in `atom`, by exponent.
[[nodiscard]] std::map<std::int32_t, Polynomial> coefficients_of(const Polynomial& x, AtomId atom);

/// The least and greatest exponent of an atom in a sum. Terms without the atom have exponent 0.
struct ExponentRange {
  AtomId atom = 0;
  std::int32_t least = 0;
  std::int32_t greatest = 0;
  std::size_t terms = 0;  ///< number of terms with the atom
};

/// The range of each atom in x, in ascending order of atoms.
[[nodiscard]] std::vector<ExponentRange> exponent_ranges(const Polynomial& x);

/// The product of all atoms, each to its least exponent in x if that is not 0. After division by
/// this product, x has neither divisors nor a power common to all terms.
[[nodiscard]] Monomial common_powers(const Polynomial& x);

/// The product of all atoms except exponentials, each to its least exponent if that is negative.
[[nodiscard]] Monomial common_divisor_powers(const Algebra& algebra, const Polynomial& sum);

/// True if the sum is its own complex conjugate.
[[nodiscard]] bool is_real(const Algebra& algebra, const Polynomial& sum);

[[nodiscard]] bool contains_exponentials(const Algebra& algebra, const Polynomial& sum);

/// The atoms in `sum`, ascending, without duplicates.
[[nodiscard]] std::vector<AtomId> atoms_of(const Polynomial& sum);

/// A product of atoms as powers * e^(i angle).
struct SplitMonomial {
  Monomial powers;  ///< of all atoms that are not exponentials
  Monomial angle;
};

[[nodiscard]] SplitMonomial split_monomial(const Algebra& algebra, const Monomial& monomial);

/// Maps each product of atoms that satisfy `is_key_atom` to its coefficient, a sum of products of
/// the other atoms.
[[nodiscard]] std::map<Monomial, Polynomial, MonomialLess> group_terms_by_atoms(
    const Algebra& algebra, const Polynomial& sum, bool (*is_key_atom)(const Atom&));

}  // namespace elgen
