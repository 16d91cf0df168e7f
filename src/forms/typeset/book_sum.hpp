// TextbookSum: a value in textbook notation, a sum of products in reading order.
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

struct TextbookFactor;

/// number * product of powers. Powers with negative exponents are divisors.
struct TextbookProduct {
  cln::cl_RA number = 1;
  std::vector<TextbookFactor> factors;  // no initializer: TextbookFactor is incomplete here
};

/// A sum; 0 if it has no terms. Unlike a Polynomial it has brackets, and an order of terms and
/// factors for readers.
struct TextbookSum {
  std::vector<TextbookProduct> terms;
};

enum class TextbookFactorKind : std::uint8_t {
  atom,    ///< atom of the algebra: a leaf, pi, a root, a call
  sine,    ///< of `angle`
  cosine,  ///< of `angle`
  tangent,
  sum,        ///< in brackets
  name,       ///< a definition of the model with the value `sum`
  prescribed  ///< a prescribed function of the model with the value `sum`
};

struct TextbookFactor {
  FactorPlace place = {};
  TextbookFactorKind kind = TextbookFactorKind::atom;
  std::int32_t exponent = 1;
  AtomId atom = 0;
  Monomial angle = {};
  TextbookSum sum;
  std::uint32_t definition = 0;  ///< index in Model::definitions or Model::prescribed
};

/// The number of printed factors, including factors in sums, but not factors ±1. A name counts as
/// one factor, or as the factors of its value if `opens_names`.
[[nodiscard]] std::size_t count_written_factors(const TextbookSum& sum, bool opens_names = false);

[[nodiscard]] FactorPlace place_of(const Atom& atom, const std::vector<std::uint32_t>& places);

/// True for velocities, momenta, accelerations, inputs and multipliers.
[[nodiscard]] bool is_moving(const Atom& atom);

/// True if is_moving() is true for a factor of the term.
[[nodiscard]] bool contains_rate(const Algebra& algebra, const Monomial& term);

/// True for pi, and for roots and functions of rational numbers.
[[nodiscard]] bool is_number(const Atom& atom);

/// True if a sum contains only numbers and parameters.
[[nodiscard]] bool contains_only_parameters(const Algebra& algebra, const Polynomial& sum);

/// Inserts a factor at its place; equal bases become one power.
void add_factor(TextbookProduct& product, TextbookFactor factor);

void multiply(TextbookProduct& product, const TextbookProduct& by);

/// Divides `product` by `by`^`exponent`.
void divide(TextbookProduct& product, const TextbookProduct& by, std::int32_t exponent = 1);

void append_terms(TextbookSum& to, TextbookSum from);

/// Multiplies `product` by `power`, a power of the sine and a power of the cosine of one angle.
void multiply(TextbookProduct& product, const Algebra& algebra, const CircularPower& power);

/// Divides `sum` by the largest number that leaves integer coefficients and a positive first term.
/// Returns this number.
[[nodiscard]] cln::cl_RA extract_numeric_content(TextbookSum& sum);

/// Divides `sum` by the sines and cosines common to all terms; returns these sines and cosines.
[[nodiscard]] std::vector<TextbookFactor> take_sinusoids(TextbookSum& sum);

/// Moves the first positive term to the front, as in 1 - v^2/c^2 under a root. The other terms keep
/// their order.
[[nodiscard]] TextbookSum move_positive_first(TextbookSum sum);

/// Sorts terms by their factors; positive terms come first.
void sort_terms(TextbookSum& sum);

}  // namespace elgen
