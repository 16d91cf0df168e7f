// function_names: every function that expressions know: those of functions.def, those of
// composite_functions.def, and those that are expanded where they are called.
#pragma once

#include <string>
#include <vector>

namespace elgen {

[[nodiscard]] const std::vector<std::string>& function_names();

}  // namespace elgen
