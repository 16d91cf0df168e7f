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
[[nodiscard]] bool holds_leaves(const Algebra& algebra, const Fraction& form);

/// The smallest monomial whose product with the numerator of a form has no negative exponents.
[[nodiscard]] Monomial divisor_powers(const Fraction& form);

/// The smallest product that clears all divisors of a form: negative powers in its monomials, and
/// its denominator.
[[nodiscard]] Value divisor_of(Algebra& algebra, const Fraction& form);

/// A form as a program of one value; none if the form is too long.
[[nodiscard]] std::optional<Linearised> form_program(const LeafNames& leaves,
                                                     const Algebra& algebra, const Fraction& form);

/// The value in 64 digits; undefined if the form has no value or is too long.
[[nodiscard]] Real value_of(const Algebra& algebra, const Fraction& form,
                            const Arguments<Real>& at);

/// Finds the atoms and forms that contain a wanted leaf; the results for atoms are memoised.
class LeafSearch {
 public:
  /// `is_wanted` selects leaves.
  LeafSearch(const Algebra& algebra, std::function<bool(const Atom&)> is_wanted)
      : algebra_(algebra), is_wanted_(std::move(is_wanted)) {}

  [[nodiscard]] bool holds(AtomId id) {
    if (const auto known = known_.find(id); known != known_.end()) return known->second;
    const Atom& atom = algebra_.atoms[id];
    const bool found = atom.kind == AtomKind::leaf
                           ? is_wanted_(atom)
                           : std::ranges::any_of(atom.arguments, [this](const Fraction& argument) {
                               return holds(argument);
                             });
    known_[id] = found;
    return found;
  }
  [[nodiscard]] bool holds(const Polynomial& sum) {
    return std::ranges::any_of(sum, [this](const auto& term) {
      return std::ranges::any_of(term.first,
                                 [this](const AtomPower& power) { return holds(power.atom); });
    });
  }
  [[nodiscard]] bool holds(const Fraction& form) {
    return holds(form.numerator) ||
           std::ranges::any_of(form.denominator, [this](const auto& factor) {
             return holds(algebra_.factors[factor.first].shown);
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
/// Replacements by kind and index of the leaf.
using Replacements = std::map<std::pair<Opcode, std::uint32_t>, Replacement>;

/// The form after the replacements; none if the form is none, if a denominator becomes 0, or if the
/// result exceeds the budget.
[[nodiscard]] Value substituted(Algebra& algebra, const Value& form,
                                const Replacements& replacements);

/// The leaf x if the function's argument is a numeric multiple of x, else null.
[[nodiscard]] const Atom* leaf_within(const Algebra& algebra, const Atom& function);

/// Replacements of all parameters by their values; none if a value is not rational.
[[nodiscard]] std::optional<Replacements> parameter_values(const std::vector<cln::cl_R>& values);

}  // namespace elgen
