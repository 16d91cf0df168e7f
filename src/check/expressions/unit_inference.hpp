// Units of expressions: inferred from the leaves, compared where terms meet and where a place asks.
#pragma once

#include "check/names/context.hpp"

namespace elgen {

/// E401, E403, E404, and one note E520 that lists what has no unit. The model has no cycles.
void check_units(Context& context);

}  // namespace elgen
