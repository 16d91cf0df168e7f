// reflection: lists of the functions and numbers of a module. With these lists another library can
// evaluate the module, for example numpy by `on(numpy)` in Python.
#pragma once

#include <string>
#include <vector>

#include "base/fill_template.hpp"
#include "elgen/program.hpp"
#include "elgen/spellings.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/text/emission_input.hpp"

namespace elgen {

/// The library functions that the module calls, by their names in the library.
[[nodiscard]] std::vector<std::string> called_library_functions(const Program& program,
                                                                const SourceSpelling& spelling);

/// Sets imports, exports, lengths of arguments, exact numbers and lists of functions. `arrays`: the
/// arrays at the head of the module. If one contains infinity, the name of infinity is imported.
void set_reflection(TemplateData& data, const EmissionInput& input,
                    const std::vector<DeclaredArray>& arrays);

}  // namespace elgen
