// Differing terms: the difference of a closed form from the right one, term by term.
//
//     right    m l^2 a + m g l sin(theta)
//     written  m l^2 a - m g l sin(theta)     the term m*g*l*sin(theta) has the other sign
//     written  2 m l^2 a + m g l sin(theta)   the term m*l^2*a has 2 times its factor
//     written  m l^2 a + m g l cos(theta)     m*g*l*cos(theta) stands in the place of
//                                             m*g*l*sin(theta)
//
//     right    n/(a + 4 b)
//     written  n/(a + 2 b)                    in the denominator the term 4*b has 1/2 of its factor
//
// Sines and cosines with equal powers of all other factors form one term.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "elgen/closed_forms.hpp"
#include "elgen/model.hpp"

namespace elgen {

using TermsByPowers = std::map<Monomial, Polynomial, MonomialLess>;

/// The terms of a sum without denominator, grouped by their factors except sines and cosines.
[[nodiscard]] TermsByPowers terms_by_powers(const Algebra& algebra, const Polynomial& sum);

struct DifferingTerms {
  std::size_t count = 0;
  /// Right terms, by the factor (not 1) with which they are written.
  std::map<cln::cl_RA, Fraction> multiples = {};
  Fraction missing = {};
  Fraction surplus = {};
  bool of_denominator = false;  ///< all terms belong to the denominator
};

/// None if the budget is exceeded. Over a product of different divisors, a term may occur in
/// neither form. Then the denominators are compared if the numerators are multiples of each other;
/// otherwise the result is none.
[[nodiscard]] std::optional<DifferingTerms> differing_terms(Algebra& algebra, const Fraction& right,
                                                            const Fraction& written);

/// The form in the model language; "" if it is too long to read.
[[nodiscard]] std::string short_form(const Model& model, const Algebra& algebra,
                                     const Fraction& form);

/// The terms in words; "" if there are too many, or they are too long.
[[nodiscard]] std::string differing_terms_text(const Model& model, const Algebra& algebra,
                                               const DifferingTerms& terms);

}  // namespace elgen
