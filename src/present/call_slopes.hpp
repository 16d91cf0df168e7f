// call_slopes: the derivatives of functions that closed forms do not take apart.
//
//     tanh(x) -> 1 - tanh(x)^2      atan2(x, y) -> y/(x^2 + y^2), -x/(x^2 + y^2)
#pragma once

#include "present/arithmetic.hpp"

namespace elgen {

/// d call/d argument for each argument, by functions.def; `call` is the atom as a sum. None beyond
/// the budget, and of functions with kinks.
[[nodiscard]] std::vector<Value> call_slopes(Arithmetic& arithmetic, const Atom& atom,
                                             const Fraction& call);

}  // namespace elgen
