// Read form: a closed form as a formula in the symbols of a model.
#pragma once

#include <optional>

#include "elgen/closed_forms.hpp"
#include "elgen/formula.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// In its shortest form; none where there is none, or it is too long to be read.
[[nodiscard]] std::optional<Formula> read_form(const Model& model, const Algebra& algebra,
                                               const std::optional<Fraction>& form);

}  // namespace elgen
