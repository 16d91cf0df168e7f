// Formulas: closed forms taken apart, and as programs and numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"
#include "forms/present/arithmetic.hpp"
#include "program/network/linearise.hpp"

namespace elgen {

/// Whether a form is more than numbers and pi.
[[nodiscard]] bool holds_leaves(const Algebra& algebra, const Fraction& form);

/// The powers that stand below in the monomials of a form, with positive exponents.
[[nodiscard]] Monomial divisor_powers(const Fraction& form);

/// The least product that makes a sum without divisors of a form: its monomials' negative powers
/// and its denominator.
[[nodiscard]] Value divisor_of(Algebra& algebra, const Fraction& form);

/// A form as a program of one value; none where it is too long.
[[nodiscard]] std::optional<Linearised> form_program(const LeafNames& leaves,
                                                     const Algebra& algebra, const Fraction& form);

/// Its number in 64 digits; undefined where it has none, or is too long.
[[nodiscard]] Real value_of(const Algebra& algebra, const Fraction& form,
                            const Arguments<Real>& at);

}  // namespace elgen
