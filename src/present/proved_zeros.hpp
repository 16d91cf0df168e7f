// proved_zeros: which entries of a function are 0, or are not, by their closed forms.
#pragma once

#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/program.hpp"

namespace elgen {

enum class ZeroProof : std::uint8_t {
  open,
  zero,      ///< the empty sum
  not_zero,  ///< another sum of leaves, numbers, pi, sines and cosines, which has one form
};

/// Of the closed form of each entry, in the order of the fields. A form that is given up is no
/// proof. Cost: that of the forms, within the budget.
[[nodiscard]] std::vector<ZeroProof> proved_zeros(const Program& program, Function function,
                                                  const PresentBudget& budget = {});

}  // namespace elgen
