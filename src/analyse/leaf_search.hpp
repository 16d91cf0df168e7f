// Leaf search: which atoms of an algebra hold leaves of one sort.
#pragma once

#include <functional>
#include <map>

#include "elgen/closed_forms.hpp"

namespace elgen {

class LeafSearch {
 public:
  /// `is_wanted` is asked of leaves.
  LeafSearch(const Algebra& algebra, std::function<bool(const Atom&)> is_wanted)
      : algebra_(algebra), is_wanted_(std::move(is_wanted)) {}

  [[nodiscard]] bool holds(AtomId id);
  [[nodiscard]] bool holds(const Polynomial& sum);
  [[nodiscard]] bool holds(const Fraction& form);

 private:
  const Algebra& algebra_;
  std::function<bool(const Atom&)> is_wanted_;
  std::map<AtomId, bool> known_ = {};
};

}  // namespace elgen
