// term_text: a closed form in the model language, term by term, as it stands in the sum.
//
//     1/4 m e^(2i theta) + its conjugate     ->     0.5*m*cos(2*theta)
#pragma once

#include <string>

#include "elgen/closed_forms.hpp"
#include "elgen/leaf_names.hpp"

namespace elgen {

[[nodiscard]] std::string term_text(const Algebra& algebra, const LeafNames& names,
                                    const Fraction& x);

}  // namespace elgen
