#include "analyse/leaf_search.hpp"

#include <algorithm>

namespace elgen {

bool LeafSearch::holds(AtomId id) {
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

bool LeafSearch::holds(const Polynomial& sum) {
  return std::ranges::any_of(sum, [this](const auto& term) {
    return std::ranges::any_of(term.first,
                               [this](const AtomPower& power) { return holds(power.atom); });
  });
}

bool LeafSearch::holds(const Fraction& form) {
  return holds(form.numerator) || std::ranges::any_of(form.denominator, [this](const auto& factor) {
           return holds(algebra_.factors[factor.first].shown);
         });
}

}  // namespace elgen
