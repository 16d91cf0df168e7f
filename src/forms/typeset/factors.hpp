// factors: where the factors of a product stand, and which of them are one.
#pragma once

#include "forms/typeset/book_sum.hpp"
#include "forms/typeset/typed.hpp"
#include "forms/write/real_terms.hpp"

namespace elgen {

[[nodiscard]] FactorPlace place_of(const Atom& atom, const std::vector<std::uint32_t>& places);

/// Velocities, momenta, accelerations, inputs and multipliers.
[[nodiscard]] bool is_moving(const Atom& atom);

/// Whether a term has such a factor.
[[nodiscard]] bool moves(const Algebra& algebra, const Monomial& term);

/// pi, or a root or function of a rational number.
[[nodiscard]] bool is_number(const Atom& atom);

/// A number, a parameter, or what is made of these.
[[nodiscard]] bool is_of_parameters(const Algebra& algebra, const Polynomial& sum);

/// In the order of their places, equal ones as one power.
void add_factor(BookProduct& product, BookFactor factor);

void multiply(BookProduct& product, const BookProduct& by);

void append(BookSum& to, BookSum from);

/// The sine and the cosine of an angle, to their exponents.
void multiply(BookProduct& product, const Algebra& algebra, const CircularPower& power);

/// Takes the greatest number out of all terms that leaves whole numbers, with the sign of the
/// first.
[[nodiscard]] cln::cl_RA take_number(BookSum& sum);

/// Takes the sines and cosines out that all terms have.
[[nodiscard]] std::vector<BookFactor> take_waves(BookSum& sum);

/// By the factors of the terms; a positive one comes first.
void sort_terms(BookSum& sum);

}  // namespace elgen
