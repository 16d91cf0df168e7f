// Differing terms: how a closed form differs from the right one, term by term.
//
//     right    m l^2 a + m g l sin(theta)
//     written  m l^2 a - m g l sin(theta)     the term m*g*l*sin(theta) has the other sign
//     written  2 m l^2 a + m g l sin(theta)   the term m*l^2*a has 2 times its factor
//     written  m l^2 a + m g l cos(theta)     m*g*l*cos(theta) stands in the place of
//     m*g*l*sin(theta)
//
//     right    n/(a + 4 b)
//     written  n/(a + 2 b)                    in the denominator the term 4*b has 1/2 of its factor
//
// Sines and cosines with the same powers of all else beside them are one term.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "elgen/closed_forms.hpp"
#include "elgen/model.hpp"

namespace elgen {

using TermsByPowers = std::map<Monomial, Polynomial, MonomialLess>;

/// The terms of a sum without a denominator, by all but their sines and cosines.
[[nodiscard]] TermsByPowers terms_by_powers(const Algebra& algebra, const Polynomial& sum);

struct DifferingTerms {
  std::size_t count = 0;
  /// Right terms by the number of times that they are written, which is not 1.
  std::map<cln::cl_RA, Fraction> multiples = {};
  Fraction missing = {};
  Fraction surplus = {};
  bool of_denominator = false;  ///< all of these
};

/// None beyond the budget. Over a product of different divisors a term may be in neither form: then
/// the denominators are compared if the numerators are multiples of each other, else nothing.
[[nodiscard]] std::optional<DifferingTerms> differing_terms(Algebra& algebra, const Fraction& right,
                                                            const Fraction& written);

/// In the model language; "" where it is too long to be read.
[[nodiscard]] std::string short_form(const Model& model, const Algebra& algebra,
                                     const Fraction& form);

/// In words; "" where they are too many or too long.
[[nodiscard]] std::string text_of(const Model& model, const Algebra& algebra,
                                  const DifferingTerms& terms);

}  // namespace elgen
