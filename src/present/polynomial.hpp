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

/// to += coefficient * monomial
void add_term(Polynomial& to, const Monomial& monomial, const Gaussian& coefficient);

[[nodiscard]] Polynomial constant(const cln::cl_RA& value);
[[nodiscard]] Polynomial sum(Polynomial x, const Polynomial& y);
/// x * coefficient * monomial
[[nodiscard]] Polynomial scaled(const Polynomial& x, const Gaussian& coefficient,
                                const Monomial& monomial = {});
/// Cost: as many term products as the sizes multiplied.
[[nodiscard]] Polynomial product(const Polynomial& x, const Polynomial& y);

/// x / y where y divides x, by long division from the leading term; y has at least two terms.
/// `work` is lowered by the term products; none also where it is used up.
[[nodiscard]] std::optional<Polynomial> quotient(const Polynomial& x, const Polynomial& y,
                                                 std::size_t& work);

/// The rational number, where it is one.
[[nodiscard]] std::optional<cln::cl_RA> rational_value(const Polynomial& x);

}  // namespace elgen
