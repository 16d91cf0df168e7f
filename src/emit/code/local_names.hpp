// local_names: the names of the values that a body declares.
#pragma once

#include <string>
#include <vector>

#include "elgen/program.hpp"
#include "emit/code/dialect.hpp"

namespace elgen {

/// Unique names of the temporaries of a function; "" for an instruction that is written out at each
/// use.
[[nodiscard]] std::vector<std::string> local_names(const Dialect& dialect, const Program& program,
                                                   const Function& function);

}  // namespace elgen
