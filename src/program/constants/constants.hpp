// The form of a constant -> its value, and a formula.
#pragma once

#include <optional>

#include "elgen/constant.hpp"
#include "elgen/formula.hpp"
#include "numbers/enclosed_number.hpp"

namespace elgen {

/// The value with a bound of the error: a float of at least 220 digits unless exact, its error at
/// most 1e-200 |value|, or 1e-200 where 1760 digits cancelled. None where the form has no real
/// value, or where 1760 digits do not tell whether it has one.
[[nodiscard]] std::optional<EnclosedNumber> enclosure_of(const ConstantForm& form);

/// As a formula:
///
///     model language    1/2*cos(3/10)     sqrt(3)^(-1)
///     LaTeX             \frac{1}{2} \cos \frac{3}{10}    \frac{1}{\sqrt{3}}
[[nodiscard]] Formula constant_formula(const ConstantForm& form);

}  // namespace elgen
