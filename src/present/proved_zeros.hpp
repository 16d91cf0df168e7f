// proved_zeros: which entries of a function are 0 by their closed forms.
#pragma once

#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// Whether the closed form of each entry, in the order of the fields, is known and the empty sum.
/// A form that is given up is no proof. Cost: that of the forms, within the budget.
[[nodiscard]] std::vector<bool> proved_zeros(const Program& program, Function function,
                                             const PresentBudget& budget = {});

}  // namespace elgen
