// polynomials: what is found in a polynomial before it is written.
#pragma once

#include <optional>

#include "elgen/closed_forms.hpp"

namespace elgen {

[[nodiscard]] bool is_one(const Polynomial& sum);

/// cosh^2 = 1 + sinh^2 in the direction that leaves fewer terms.
[[nodiscard]] Polynomial by_hyperbolic_squares(const Algebra& algebra, Polynomial sum);

/// The sum whose square is x, by long division from the leading term, which has coefficient 1.
[[nodiscard]] std::optional<Polynomial> square_root(const Polynomial& x);

/// The factor of the highest power of an atom.
[[nodiscard]] Polynomial highest_coefficient(const Polynomial& x, AtomId atom);

/// The negative powers of atoms other than exponentials, the lowest of each.
[[nodiscard]] Monomial lowest_powers(const Algebra& algebra, const Polynomial& sum);

/// Whether it is its own conjugate.
[[nodiscard]] bool is_real(const Algebra& algebra, const Polynomial& sum);

[[nodiscard]] bool holds_exponentials(const Algebra& algebra, const Polynomial& sum);

}  // namespace elgen
