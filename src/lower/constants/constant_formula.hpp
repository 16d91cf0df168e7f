// constant_formula: an exact constant as a formula.
//
//     model language    1/2*cos(3/10)     sqrt(3)^(-1)
//     LaTeX             \frac{1}{2} \cos \frac{3}{10}    \frac{1}{\sqrt{3}}
#pragma once

#include "base/formula.hpp"
#include "elgen/constant.hpp"

namespace elgen {

[[nodiscard]] Formula constant_formula(const Spelling& spelling, const ConstantForm& form);

}  // namespace elgen
