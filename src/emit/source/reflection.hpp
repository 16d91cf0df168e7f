// reflection: what a module knows of its functions and numbers, so that other libraries than its
// own can compute them, as `on(numpy)` in Python.
#pragma once

#include <string>
#include <vector>

#include "base/fill_template.hpp"
#include "elgen/program.hpp"
#include "elgen/spellings.hpp"
#include "emit/text/emission_input.hpp"

namespace elgen {

/// The functions of the library that the module calls, by its names.
[[nodiscard]] std::vector<std::string> called_functions(const Program& program,
                                                        const SourceSpelling& spelling);

/// Sets imports, exact numbers and lists of functions. `is_unbounded`: an array at the head of the
/// module has an infinite number.
void set_reflection(TemplateData& data, const EmissionInput& input, bool is_unbounded);

}  // namespace elgen
