// Differing terms: the difference between a closed form and the right one, term by term.
//
//     right    m l^2 a + m g l sin(theta)
//     written  m l^2 a - m g l sin(theta)     the term m*g*l*sin(theta) has the opposite sign
//     written  2 m l^2 a + m g l sin(theta)   the term m*l^2*a has 2 times its factor
//     written  m l^2 a + m g l cos(theta)     m*g*l*cos(theta) replaces m*g*l*sin(theta)
//
//     right    n/(a + 4 b)
//     written  n/(a + 2 b)                    in the denominator the term 4*b has 1/2 of its factor
//
// Products that differ only in sines and cosines count as one term.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "elgen/closed_forms.hpp"
#include "elgen/model.hpp"

namespace elgen {

using TermsByPowers = std::map<Monomial, Polynomial, MonomialLess>;

/// The terms of a sum without denominator. The key is a product of powers without sines and
/// cosines; the value is its coefficient.
[[nodiscard]] TermsByPowers group_by_powers(const Algebra& algebra, const Polynomial& sum);

struct DifferingTerms {
  std::size_t count = 0;
  /// Right terms that are written with another factor; the key is the written factor divided by the
  /// right factor.
  std::map<cln::cl_RA, Fraction> rescaled_terms = {};
  Fraction missing = {};
  Fraction surplus = {};
  bool is_of_denominator = false;  ///< the terms are terms of the denominator
};

/// The differing terms of both forms over one denominator, if these terms occur in the forms as
/// written. Otherwise the differing terms of both denominators, if the written numerator is a
/// multiple of the right numerator. None in all other cases, and if the budget is exceeded.
[[nodiscard]] std::optional<DifferingTerms> differing_terms(Algebra& algebra, const Fraction& right,
                                                            const Fraction& written);

/// The form in the model language; "" if it is longer than 100 characters.
[[nodiscard]] std::string short_form_text(const Model& model, const Algebra& algebra,
                                          const Fraction& form);

/// The terms in words; "" if there are none or more than four, or if a term has more than 100
/// characters.
[[nodiscard]] std::string differing_terms_text(const Model& model, const Algebra& algebra,
                                               const DifferingTerms& terms);

}  // namespace elgen
