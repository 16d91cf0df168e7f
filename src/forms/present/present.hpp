// present: the functions of a program as closed forms, one after another within one budget.
#pragma once

#include <functional>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "forms/present/arithmetic.hpp"

namespace elgen {

/// The closed forms of all instructions of a function.
using ValuesOf = std::function<std::vector<Value>(Arithmetic&, const Function&)>;

/// Appends the closed forms of every function's entries; a function that repeats others has none.
void present_functions(const Program& program, const PresentBudget& budget, ClosedForms& forms,
                       const ValuesOf& values_of);

}  // namespace elgen
