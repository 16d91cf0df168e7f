// reflection: lists of the functions and numbers of a module. With these lists another library can
// evaluate the module, for example numpy by `on(numpy)` in Python.
#pragma once

#include <string>
#include <vector>

#include "base/fill_template.hpp"
#include "elgen/program.hpp"
#include "elgen/spellings.hpp"
#include "emit/text/emission_input.hpp"

namespace elgen {

/// The library functions that the module calls, by their names in the library.
[[nodiscard]] std::vector<std::string> called_library_functions(const Program& program,
                                                                const SourceSpelling& spelling);

/// Sets imports, exact numbers and lists of functions. `is_unbounded`: an array at the head of the
/// module contains infinity, whose name must be imported.
void set_reflection(TemplateData& data, const EmissionInput& input, bool is_unbounded);

}  // namespace elgen
