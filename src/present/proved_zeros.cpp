// proved_zeros: the empty sum is the one form of zero.
#include "present/proved_zeros.hpp"

#include <utility>

namespace elgen {

std::vector<bool> proved_zeros(const Program& program, Function function,
                               const PresentBudget& budget) {
  function.kind = OutputKind::momentum;  // any but `dynamics`, which has no closed form of its own
  const ClosedForms forms =
      present({program.leaves, program.constants, {std::move(function)}}, budget);
  std::vector<bool> result;
  for (const ClosedField& field : forms.functions[0].fields) {
    for (const std::optional<Fraction>& form : field.entries) {
      result.push_back(form && form->numerator.empty());
    }
  }
  return result;
}

}  // namespace elgen
