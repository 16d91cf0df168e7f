// BookSum: a value in textbook notation, a sum of products in reading order.
//
//     1/2 m (r'^2 + r^2 phi'^2)     one product: 1/2, m, and a sum of two products
//
// Places order the factors of a product by group: multipliers, parameters, sums that contain other
// leaves than parameters, coordinates, rates, accelerations, inputs, functions. Within a group the
// rank decides.
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

/// number * product of powers. Powers with negative exponents are divisors.
struct BookProduct {
  cln::cl_RA number = 1;
  std::vector<BookFactor> factors;  // no initializer: BookFactor is incomplete here
};

/// A sum; 0 if it has no terms. Unlike a Polynomial it has brackets, and an order of terms and
/// factors for readers.
struct BookSum {
  std::vector<BookProduct> terms;
};

enum class BookFactorKind : std::uint8_t {
  atom,    ///< atom of the algebra: a leaf, pi, a root, a call
  sine,    ///< of `angle`
  cosine,  ///< of `angle`
  tangent,
  sum,        ///< in brackets
  name,       ///< a definition of the model with the value `sum`
  prescribed  ///< a prescribed function of the model with the value `sum`
};

struct BookFactor {
  FactorPlace place = {};
  BookFactorKind kind = BookFactorKind::atom;
  std::int32_t exponent = 1;
  AtomId atom = 0;
  Monomial angle = {};
  BookSum sum;
  std::uint32_t definition = 0;  ///< index in Model::definitions or Model::prescribed
};

/// The number of printed factors, including factors in sums, but not factors ±1. A name counts as
/// one factor, or as the factors of its value if `opens_names`.
[[nodiscard]] std::size_t written_factors(const BookSum& sum, bool opens_names = false);

[[nodiscard]] FactorPlace place_of(const Atom& atom, const std::vector<std::uint32_t>& places);

/// True for velocities, momenta, accelerations, inputs and multipliers.
[[nodiscard]] bool is_moving(const Atom& atom);

/// True if a factor of the term is_moving().
[[nodiscard]] bool moves(const Algebra& algebra, const Monomial& term);

/// True for pi, and for roots and functions of rational numbers.
[[nodiscard]] bool is_number(const Atom& atom);

/// True if a sum contains only numbers and parameters.
[[nodiscard]] bool is_of_parameters(const Algebra& algebra, const Polynomial& sum);

/// Inserts a factor at its place; equal bases become one power.
void add_factor(BookProduct& product, BookFactor factor);

void multiply(BookProduct& product, const BookProduct& by);

/// Divides product by by^exponent.
void divide(BookProduct& product, const BookProduct& by, std::int32_t exponent = 1);

void append(BookSum& to, BookSum from);

/// Multiplies `product` by `power`, a power of the sine and a power of the cosine of one angle.
void multiply(BookProduct& product, const Algebra& algebra, const CircularPower& power);

/// Divides `sum` by the largest number that leaves integer coefficients and a positive first term.
/// Returns this number.
[[nodiscard]] cln::cl_RA take_number(BookSum& sum);

/// Divides by the sines and cosines common to all terms, and returns them.
[[nodiscard]] std::vector<BookFactor> take_sinusoids(BookSum& sum);

/// Moves the first positive term to the front, as in 1 - v^2/c^2 under a root. The other terms keep
/// their order.
[[nodiscard]] BookSum positive_first(BookSum sum);

/// Sorts terms by their factors; positive terms come first.
void sort_terms(BookSum& sum);

}  // namespace elgen
