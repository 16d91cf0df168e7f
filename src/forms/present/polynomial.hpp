// Polynomials in atoms with exponents of either sign and coefficients x + i y, all exact.
#pragma once

#include "elgen/closed_forms.hpp"

namespace elgen {

[[nodiscard]] Monomial product(const Monomial& x, const Monomial& y);
[[nodiscard]] Monomial power(const Monomial& x, std::int32_t exponent);

[[nodiscard]] Gaussian product(const Gaussian& x, const Gaussian& y);
/// x must not be 0.
[[nodiscard]] Gaussian reciprocal(const Gaussian& x);
[[nodiscard]] bool is_zero(const Gaussian& x);

/// to += coefficient * monomial, of a polynomial or another sum of products; no coefficient is 0.
template <class Sum>
void add_term(Sum& to, const typename Sum::key_type& monomial, const Gaussian& coefficient) {
  const auto [at, is_new] = to.try_emplace(monomial, coefficient);
  if (is_new) return;
  at->second.real = at->second.real + coefficient.real;
  at->second.imaginary = at->second.imaginary + coefficient.imaginary;
  if (is_zero(at->second)) to.erase(at);
}

[[nodiscard]] Polynomial constant(const cln::cl_RA& value);
/// Cost: as many terms as both have.
[[nodiscard]] Polynomial sum(const Polynomial& x, const Polynomial& y);
/// x * coefficient * monomial
[[nodiscard]] Polynomial scaled(const Polynomial& x, const Gaussian& coefficient,
                                const Monomial& monomial = {});
/// Cost: as many term products as the sizes multiplied.
[[nodiscard]] Polynomial product(const Polynomial& x, const Polynomial& y);

/// x / y where y divides x, by long division from the leading term; y has at least two terms, x
/// one. `work` is lowered by the term products; none also where it is used up.
[[nodiscard]] std::optional<Polynomial> quotient(const Polynomial& x, const Polynomial& y,
                                                 std::size_t& work);

/// Divides every denominator factor that the numerator has out of both; `work` as in quotient().
void divide_out(Fraction& x, const Algebra& algebra, std::size_t& work);

/// x/y, where it is a rational number; neither is the empty sum.
[[nodiscard]] std::optional<cln::cl_RA> ratio_of(const Polynomial& x, const Polynomial& y);

/// The rational number, where it is one.
[[nodiscard]] std::optional<cln::cl_RA> rational_value(const Polynomial& x);

[[nodiscard]] bool is_one(const Polynomial& sum);

/// cosh^2 = 1 + sinh^2 in the direction that leaves fewer terms.
[[nodiscard]] Polynomial by_hyperbolic_squares(const Algebra& algebra, Polynomial sum);

/// The product whose square is x; none where an exponent is odd.
[[nodiscard]] std::optional<Monomial> square_root(Monomial x);

/// The sum whose square is x, by long division from the leading term, which has coefficient 1.
[[nodiscard]] std::optional<Polynomial> square_root(const Polynomial& x);

/// 0 where the atom is not there.
[[nodiscard]] std::int32_t exponent_of(const Monomial& monomial, AtomId atom);

/// The factors of the powers of an atom, by exponent.
[[nodiscard]] std::map<std::int32_t, Polynomial> coefficients_of(const Polynomial& x, AtomId atom);

/// Least and greatest exponent of an atom in a sum; where it is absent its exponent is 0.
struct AtomRange {
  AtomId atom = 0;
  std::int32_t least = 0;
  std::int32_t greatest = 0;
  std::size_t terms = 0;  ///< that hold the atom
};

/// Ascending atoms.
[[nodiscard]] std::vector<AtomRange> exponents_of(const Polynomial& x);

/// The least exponent of every atom, where that is not 0: what is left has no divisors, and no
/// power that all terms have.
[[nodiscard]] Monomial common_powers(const Polynomial& x);

/// The negative powers of atoms other than exponentials, the lowest of each.
[[nodiscard]] Monomial lowest_powers(const Algebra& algebra, const Polynomial& sum);

/// Whether it is its own conjugate.
[[nodiscard]] bool is_real(const Algebra& algebra, const Polynomial& sum);

[[nodiscard]] bool holds_exponentials(const Algebra& algebra, const Polynomial& sum);

/// Ascending, each once.
[[nodiscard]] std::vector<AtomId> atoms_of(const Polynomial& sum);

/// The angle in a product of atoms: e^(i angle) is what its circular atoms make.
struct SplitMonomial {
  Monomial powers;  ///< of all other atoms
  Monomial angle;
};

[[nodiscard]] SplitMonomial split(const Algebra& algebra, const Monomial& monomial);

/// The terms by the part of them that is of such atoms: key -> what multiplies it.
[[nodiscard]] std::map<Monomial, Polynomial, MonomialLess> parts_by(const Algebra& algebra,
                                                                    const Polynomial& sum,
                                                                    bool (*is_of_key)(const Atom&));

}  // namespace elgen
