// Formulas: closed forms taken apart, with values in the place of leaves, and as programs and
// numbers.
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

/// Whether a form contains more than numbers and pi.
[[nodiscard]] bool holds_leaves(const Algebra& algebra, const Fraction& form);

/// The powers with negative exponents in the monomials of a form, made positive.
[[nodiscard]] Monomial divisor_powers(const Fraction& form);

/// The smallest product that clears all divisors of a form: negative powers in its monomials, and
/// its denominator.
[[nodiscard]] Value divisor_of(Algebra& algebra, const Fraction& form);

/// A form as a program of one value; none where it is too long.
[[nodiscard]] std::optional<Linearised> form_program(const LeafNames& leaves,
                                                     const Algebra& algebra, const Fraction& form);

/// The value in 64 digits; undefined if there is none, or the form is too long.
[[nodiscard]] Real value_of(const Algebra& algebra, const Fraction& form,
                            const Arguments<Real>& at);

/// Which atoms of an algebra hold leaves of one sort.
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

/// The value that replaces a leaf. The cosine and sine of an angle such as acos(c) are given, to
/// avoid functions of functions.
struct Replacement {
  Fraction value = {};
  std::optional<CosineAndSine> sinusoids = {};
};
/// Replacements by kind and number.
using Replacements = std::map<std::pair<Opcode, std::uint32_t>, Replacement>;

/// The form with these values; none if the form is none, is undefined there (a denominator becomes
/// 0), or exceeds the budget.
[[nodiscard]] Value substituted(Algebra& algebra, const Value& form,
                                const Replacements& replacements);

/// The leaf that the argument of a function is a multiple of; null where it is none.
[[nodiscard]] const Atom* leaf_within(const Algebra& algebra, const Atom& function);

/// The values of all parameters; none if one is no rational number.
[[nodiscard]] std::optional<Replacements> parameter_values(const std::vector<cln::cl_R>& values);

}  // namespace elgen
