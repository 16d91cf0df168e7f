// BookSum: a value in textbook notation, a sum of products in reading order.
//
//     1/2 m (r'^2 + r^2 phi'^2)     one product: 1/2, m, and a sum of two products
//
// Places order the factors of a product: multipliers, parameters, sums beyond parameters,
// coordinates, rates, accelerations, inputs, functions; by rank within a group.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "forms/write/real_terms.hpp"

namespace elgen {

struct FactorPlace {
  FactorGroup group = FactorGroup::parameter;
  std::uint32_t rank = 0;
  friend auto operator<=>(const FactorPlace&, const FactorPlace&) = default;
};

struct BookFactor;

/// number * product of the powers. Those with negative exponents are divisors.
struct BookProduct {
  cln::cl_RA number = 1;
  std::vector<BookFactor> factors;  // no initializer: BookFactor is incomplete here
};

/// A sum. No terms mean 0.
struct BookSum {
  std::vector<BookProduct> terms;
};

enum class BookFactorKind : std::uint8_t {
  atom,    ///< of the algebra: a leaf, pi, a root, a call
  sine,    ///< of `angle`
  cosine,  ///< of `angle`
  tangent,
  sum,        ///< in brackets
  name,       ///< a definition of the model, whose value is `sum`
  prescribed  ///< a prescribed function of the model, whose value is `sum`
};

struct BookFactor {
  FactorPlace place = {};
  BookFactorKind kind = BookFactorKind::atom;
  std::int32_t exponent = 1;
  AtomId atom = 0;
  Monomial angle = {};
  BookSum sum;
  std::uint32_t definition = 0;  ///< of a name, in Model::definitions or Model::prescribed
};

/// The number of printed factors, including those in sums, but not 1. A name counts as one factor,
/// or as its value if `opens_names`.
[[nodiscard]] std::size_t written_factors(const BookSum& sum, bool opens_names = false);

[[nodiscard]] FactorPlace place_of(const Atom& atom, const std::vector<std::uint32_t>& places);

/// Whether an atom is a velocity, momentum, acceleration, input or multiplier.
[[nodiscard]] bool is_moving(const Atom& atom);

/// Whether a term has such a factor.
[[nodiscard]] bool moves(const Algebra& algebra, const Monomial& term);

/// Whether an atom is pi, or a root or function of a rational number.
[[nodiscard]] bool is_number(const Atom& atom);

/// Whether a sum contains only numbers and parameters.
[[nodiscard]] bool is_of_parameters(const Algebra& algebra, const Polynomial& sum);

/// Adds a factor at its place. Equal bases become one power.
void add_factor(BookProduct& product, BookFactor factor);

void multiply(BookProduct& product, const BookProduct& by);

/// Divides product by by^exponent.
void divide(BookProduct& product, const BookProduct& by, std::int32_t exponent = 1);

void append(BookSum& to, BookSum from);

/// Multiplies by the powers of the sine and cosine of an angle.
void multiply(BookProduct& product, const Algebra& algebra, const CircularPower& power);

/// Factors out the largest number that leaves whole coefficients, with the sign of the first term.
[[nodiscard]] cln::cl_RA take_number(BookSum& sum);

/// Factors out the sines and cosines common to all terms.
[[nodiscard]] std::vector<BookFactor> take_sinusoids(BookSum& sum);

/// Puts a positive term first and keeps the order of the others: 1 - v^2/c^2 under a root.
[[nodiscard]] BookSum positive_first(BookSum sum);

/// Sorts terms by their factors, a positive term first.
void sort_terms(BookSum& sum);

}  // namespace elgen
