// Formulas: divisors of closed forms, substitution of values for leaves, and numeric evaluation.
//
//     m R (g cos(theta) - R W^2 cos(2 theta))   at theta = pi   ->   -m R (g + R W^2)
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "elgen/analyse.hpp"
#include "elgen/closed_forms.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"
#include "forms/present/arithmetic.hpp"
#include "program/network/linearise.hpp"

namespace elgen {

/// True if the numerator of a form contains more than numbers and pi.
[[nodiscard]] bool contains_leaves(const Algebra& algebra, const Fraction& form);

/// The smallest monomial whose product with the numerator of a form has no negative exponents.
[[nodiscard]] Monomial monomial_denominator(const Fraction& form);

/// The smallest product that clears all divisors of a form: negative powers in its monomials, and
/// its denominator.
[[nodiscard]] OptionalFraction full_denominator(Algebra& algebra, const Fraction& form);

/// A form as a program of one value; none if the form is too long.
[[nodiscard]] std::optional<LinearisedNetwork> form_program(const LeafNames& leaves,
                                                            const Algebra& algebra,
                                                            const Fraction& form);

/// The value of `form` at `at` in 64 digits; undefined if the form has no value or is too long.
[[nodiscard]] Real evaluate_form(const Algebra& algebra, const Fraction& form,
                                 const Arguments<Real>& at);

/// Finds the atoms and forms that contain a wanted leaf; the results for atoms are memoised.
class LeafSearch {
 public:
  /// `is_wanted` is true for the leaves to be found.
  LeafSearch(const Algebra& algebra, std::function<bool(const Atom&)> is_wanted)
      : algebra_(algebra), is_wanted_(std::move(is_wanted)) {}

  [[nodiscard]] bool contains(AtomId id) {
    if (const auto known = known_.find(id); known != known_.end()) return known->second;
    const Atom& atom = algebra_.atoms[id];
    const bool found = atom.kind == AtomKind::leaf
                           ? is_wanted_(atom)
                           : std::ranges::any_of(atom.arguments, [this](const Fraction& argument) {
                               return contains(argument);
                             });
    known_[id] = found;
    return found;
  }
  [[nodiscard]] bool contains(const Polynomial& sum) {
    return std::ranges::any_of(sum, [this](const auto& term) {
      return std::ranges::any_of(term.first,
                                 [this](const AtomPower& power) { return contains(power.atom); });
    });
  }
  [[nodiscard]] bool contains(const Fraction& form) {
    return contains(form.numerator) ||
           std::ranges::any_of(form.denominator, [this](const auto& factor) {
             return contains(algebra_.factors[factor.first].shown);
           });
  }

 private:
  const Algebra& algebra_;
  std::function<bool(const Atom&)> is_wanted_;
  std::map<AtomId, bool> known_ = {};
};

/// The value that replaces a leaf. For an angle such as acos(c), `sinusoids` are its cosine and
/// sine, so that no cos(acos(c)) arises.
struct Replacement {
  Fraction value = {};
  std::optional<CosineAndSine> sinusoids = {};
};
/// (kind, index) of a leaf -> its replacement.
using Replacements = std::map<std::pair<Opcode, std::uint32_t>, Replacement>;

/// The form after the replacements; none if the form is none, if a denominator becomes 0, or if the
/// result exceeds the budget.
[[nodiscard]] OptionalFraction substitute(Algebra& algebra, const OptionalFraction& form,
                                          const Replacements& replacements);

/// The leaf x if the function's argument is a numeric multiple of x, else null.
[[nodiscard]] const Atom* find_argument_leaf(const Algebra& algebra, const Atom& function);

/// Replacements of all parameters by their values; none if a value is not rational.
[[nodiscard]] std::optional<Replacements> parameter_replacements(
    const std::vector<cln::cl_R>& values);

}  // namespace elgen
