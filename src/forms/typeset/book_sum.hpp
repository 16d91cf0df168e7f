// BookSum: a value as a book writes it, a sum of products in the order in which they are read.
//
//     1/2 m (r'^2 + r^2 phi'^2)     one product: 1/2, m, and a sum of two products
//
// Places order the factors of a product: multipliers, parameters, sums of more than parameters,
// coordinates, rates, accelerations, inputs, functions; within a group by rank.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "forms/write/real_terms.hpp"

namespace elgen {

enum class FactorGroup : std::uint8_t {
  multiplier,
  parameter,
  sum,
  coordinate,
  rate,
  acceleration,
  input,
  function
};

struct FactorPlace {
  FactorGroup group = FactorGroup::parameter;
  std::uint32_t rank = 0;
  friend auto operator<=>(const FactorPlace&, const FactorPlace&) = default;
};

struct BookFactor;

/// number * product of the factors, each to its exponent; those with negative ones stand below.
struct BookProduct {
  cln::cl_RA number = 1;
  std::vector<BookFactor> factors;  // no initializer: BookFactor is incomplete here
};

/// No terms: 0.
struct BookSum {
  std::vector<BookProduct> terms;
};

enum class BookFactorKind : std::uint8_t {
  atom,    ///< of the algebra: a leaf, pi, a root, a call
  sine,    ///< of `angle`
  cosine,  ///< likewise
  tangent,
  sum,  ///< in brackets
  name  ///< a definition of the model, whose value is `sum`
};

struct BookFactor {
  FactorPlace place = {};
  BookFactorKind kind = BookFactorKind::atom;
  std::int32_t exponent = 1;
  AtomId atom = 0;
  Monomial angle = {};
  BookSum sum;
  std::uint32_t definition = 0;  ///< of a name, in Model::definitions
};

/// Factors that a reader sees, those in sums too; 1 is none. A name is one, or all that it stands
/// for.
[[nodiscard]] std::size_t written_factors(const BookSum& sum, bool opens_names = false);

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

/// product / by^exponent
void divide(BookProduct& product, const BookProduct& by, std::int32_t exponent = 1);

void append(BookSum& to, BookSum from);

/// The sine and the cosine of an angle, to their exponents.
void multiply(BookProduct& product, const Algebra& algebra, const CircularPower& power);

/// Takes the greatest number out of all terms that leaves whole numbers, with the sign of the
/// first.
[[nodiscard]] cln::cl_RA take_number(BookSum& sum);

/// Takes the sines and cosines out that all terms have.
[[nodiscard]] std::vector<BookFactor> take_sinusoids(BookSum& sum);

/// 1 - v^2/c^2 under a root: a positive term comes first, the others in their order.
[[nodiscard]] BookSum positive_first(BookSum sum);

/// By the factors of the terms; a positive one comes first.
void sort_terms(BookSum& sum);

}  // namespace elgen
