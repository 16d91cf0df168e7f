// Units of expressions: inferred from the leaves, compared where terms meet and where a place asks.
#pragma once

#include "check/names/context.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// Whether a variable or parameter has a unit other than 1; otherwise units are not checked.
[[nodiscard]] bool uses_units(const FileSyntax& model);

/// E401, E403, E404, a note E405 of values that name nothing, and one E520 that lists what has no
/// unit. The model has no cycles.
void check_units(Context& context);

}  // namespace elgen
